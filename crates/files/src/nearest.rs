//! The name that was meant by one that is not known.

use strsim::jaro_winkler;

/// Least likeness, from 0 to 1 (Jaro and Winkler), of a name that is offered: another is no help.
const ALIKE: f64 = 0.85;

/// The known name that is most like `name`, if one is like it; capitals do not matter.
pub fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let name = name.to_lowercase();
    let alike = known.into_iter().map(|other| (jaro_winkler(&name, &other.to_lowercase()), other));
    let alike = alike.filter(|(likeness, _)| *likeness >= ALIKE);
    // Of two that are equally like, the first.
    alike.reduce(|best, next| if next.0 > best.0 { next } else { best }).map(|(_, other)| other)
}

/// The end of a sentence that asks whether the nearest name was meant; empty if none is near.
pub fn did_you_mean<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(name, known).map_or_else(String::new, |meant| format!("; did you mean `{meant}`?"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const KEYS: [&str; 4] = ["duration_s", "step_s", "cell.size", "section.cell_size"];

    #[test]
    fn typing_errors_are_seen_through() {
        for (typed, meant) in [
            ("duraton_s", "duration_s"),
            ("Duration_s", "duration_s"),
            ("cellsize", "cell.size"),
            ("setp_s", "step_s"),
        ] {
            assert_eq!(nearest(typed, KEYS), Some(meant), "{typed}");
        }
    }

    #[test]
    fn another_word_is_not_offered() {
        assert_eq!(nearest("colour", KEYS), None);
        assert_eq!(did_you_mean("colour", KEYS), "");
        assert_eq!(did_you_mean("step", KEYS), "; did you mean `step_s`?");
    }
}
