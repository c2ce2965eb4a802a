//! The format of a file, by its content and the ending of its name.

use super::parsed::{CLEAN, PER_METRE, Parsed, ProfileFormat, points};
use super::{columns, miniprof, simpack};
use crate::error::ContactError;
use crate::profile::kind::ProfileKind;

/// Endings of names that are files of points, in any case.
const ENDINGS: [&str; 10] =
    ["prw", "prr", "whl", "ban", "wheel", "rail", "txt", "csv", "dat", "asc"];

/// Whether `name` is that of a file of points.
pub(super) fn is_file(name: &str) -> bool {
    let ending = name.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
    ending.is_some_and(|ending| ENDINGS.contains(&&*ending))
}

/// The kind of profile that the ending of a name says.
pub(super) fn kind(name: &str) -> Option<ProfileKind> {
    match &*name.rsplit('.').next()?.to_ascii_lowercase() {
        "prw" | "whl" | "wheel" => Some(ProfileKind::Wheel),
        "prr" | "ban" | "rail" => Some(ProfileKind::Rail),
        _ => None,
    }
}

/// Reads `text`; `name` is that of the file, whose ending tells some formats. `per_metre` goes before
/// what the file says.
///
/// # Errors
/// When a line of points has no two numbers, or a key of the header no value that it can have.
pub(super) fn parse(
    text: &str,
    name: &str,
    per_metre: Option<f64>,
) -> Result<Parsed, ContactError> {
    let ending = name.rsplit('.').next().unwrap_or_default().to_ascii_lowercase();
    if text.contains("point.begin") {
        return simpack::parse(text, name, per_metre);
    }
    if ["whl", "ban"].contains(&&*ending) || miniprof::is_header(text) {
        return miniprof::parse(text, name, per_metre);
    }
    let format = match &*ending {
        "wheel" | "rail" => ProfileFormat::Gensys,
        _ => ProfileFormat::Columns,
    };
    let per_metre = per_metre.unwrap_or(PER_METRE);
    let lines = text.lines().map(columns::without_comment).enumerate();
    let begins = |line: &str| {
        let line = line.trim_start_matches('"');
        line.starts_with(|c: char| c.is_ascii_digit() || "+-.\u{2212}".contains(c))
    };
    // Names of columns and a count of the points may stand above.
    let above = |(_, line): &(usize, &str)| {
        !begins(line) || !line.contains(|c: char| c.is_whitespace() || c == ',' || c == ';')
    };
    let lines = lines.skip_while(above).filter(|(_, line)| !line.is_empty());
    let points = points(name, lines, [0, 1], per_metre)?;
    let clean = text.starts_with(CLEAN);
    Ok(Parsed {
        format,
        kind: None,
        per_metre,
        clean,
        points,
        from_flange_back: false,
        notes: vec![],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn coordinates(text: &str, name: &str) -> Vec<[f64; 2]> {
        parse(text, name, None).unwrap().points.iter().map(|point| point.at).collect()
    }

    /// Names of columns, their units and a count of the points are no points.
    #[test]
    fn what_stands_above_the_points_is_passed_over() {
        let expected = [[-0.06, 0.025], [0.01, 0.0]];
        for above in ["", "y;z\n", "521\n", "\"lateral (mm)\", \"height (mm)\"\n", "# -5 3\n\n"] {
            assert_eq!(
                coordinates(&format!("{above}-60 25\n10 0\n"), "p.txt"),
                expected,
                "{above}"
            );
        }
        let words = parse("0 0\n1 x\n", "p.txt", None).unwrap_err().to_string();
        assert!(words.contains("p.txt: line 2: expected two numbers, found \"1 x\""), "{words}");
    }

    #[test]
    fn formats_are_told_by_ending_and_content() {
        let format = |text: &str, name: &str| parse(text, name, None).unwrap().format;
        assert_eq!(format("1 2\n", "W.WHL"), ProfileFormat::MiniProf);
        assert_eq!(format("XYPoints=1\n\n1 2\n", "w.txt"), ProfileFormat::MiniProf);
        assert_eq!(format("1 2\n", "w.Wheel"), ProfileFormat::Gensys);
        assert_eq!(format("point.begin\n1 2\npoint.end", "w.txt"), ProfileFormat::Simpack);
        assert_eq!(format("1 2\n", "w.prw"), ProfileFormat::Columns);
    }
}
