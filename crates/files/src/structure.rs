//! What a file's structure lacks: the messages of TOML and serde in plain words.
//!
//! Both libraries say what is wrong in the terms of a program (`expected f64`); here it is said in those of
//! the file. A message of theirs that is not known here is passed on as it is.

use serde::de::DeserializeOwned;

use crate::document::Document;
use crate::key;
use crate::mistake::{Mistake, is_short};
use crate::nearest::did_you_mean;
use crate::syntax;

/// The mistake of a document that is not the structure `T`.
pub(crate) fn mistake<T: DeserializeOwned>(
    document: &Document,
    error: &toml::de::Error,
) -> Mistake {
    let text = document.text();
    let span = error.span();
    let begin = span.as_ref().map_or(0, |span| span.start);
    // What all of the file lacks stands nowhere.
    let is_somewhere = span.as_ref().is_some_and(|span| !span.is_empty());
    let key = if is_somewhere { key::at(text, begin) } else { String::new() };
    let at = Site { text, begin, key };
    let message = error.message().trim();
    let sentence = unknown_key::<T>(&at, message)
        .or_else(|| missing_key(&at, message))
        .or_else(|| unknown_choice(&at, message))
        .or_else(|| wrong_type(&at, message, span.clone().and_then(|span| text.get(span))))
        .or_else(|| {
            syntax::in_words(at.line(), message, span.clone().and_then(|span| text.get(span)))
        })
        .unwrap_or_else(|| {
            let message = message.replace('\n', "; ");
            if at.key.is_empty() { message } else { format!("{}: {message}", at.key) }
        });
    match span {
        Some(span) if is_somewhere || !message.starts_with("missing field ") => {
            document.mistake(span, sentence)
        }
        _ => Mistake::in_file(document.name(), sentence),
    }
}

/// Where an error is.
struct Site<'a> {
    text: &'a str,
    begin: usize,
    /// The innermost key there.
    key: String,
}

impl Site<'_> {
    /// The line up to the error, and from it on.
    fn line(&self) -> (&str, &str) {
        let (before, after) = self.text.split_at(self.begin.min(self.text.len()));
        let before = before.rsplit('\n').next().unwrap_or_default();
        (before, after.lines().next().unwrap_or_default())
    }
}

/// The names that a message has in backquotes.
fn quoted(message: &str) -> Vec<&str> {
    message.split('`').skip(1).step_by(2).collect()
}

fn unknown_key<T: DeserializeOwned>(at: &Site<'_>, message: &str) -> Option<String> {
    let names = message.strip_prefix("unknown field ").map(quoted)?;
    let (unknown, known) = names.split_first()?;
    let section = at.key.strip_suffix(unknown).unwrap_or(&at.key).trim_end_matches('.');
    let here = if section.is_empty() { String::new() } else { format!(" in {section}") };
    if !section.is_empty() && is_key_of_the_top::<T>(unknown) {
        let remedy = match at.line().0.trim_start().starts_with('[') {
            true => format!("write [{unknown}]"),
            false => "it belongs to the top of the file, before the first [section]".to_owned(),
        };
        return Some(format!("there is no key `{unknown}`{here}; {remedy}"));
    }
    let meant = did_you_mean(unknown, known.iter().copied());
    let end = if meant.is_empty() { "." } else { &meant };
    let known: Vec<_> = known.iter().map(|name| format!("`{name}`")).collect();
    Some(format!("there is no key `{unknown}`{here}{end} Known here: {}", known.join(", ")))
}

/// Whether the structure has this key on its own level.
///
/// Then a file with nothing else is wrong for another reason than an unknown key.
fn is_key_of_the_top<T: DeserializeOwned>(key: &str) -> bool {
    let alone = format!("\"{key}\" = 0");
    let unknown = format!("unknown field `{key}`");
    toml::from_str::<T>(&alone).err().is_none_or(|error| !error.message().starts_with(&unknown))
}

fn missing_key(at: &Site<'_>, message: &str) -> Option<String> {
    let name = message.strip_prefix("missing field ").map(quoted)?.first().copied()?;
    let key = if at.key.is_empty() { name.to_owned() } else { format!("{}.{name}", at.key) };
    Some(format!("{key} is missing"))
}

fn unknown_choice(at: &Site<'_>, message: &str) -> Option<String> {
    let names = message.strip_prefix("unknown variant ").map(quoted)?;
    let (unknown, known) = names.split_first()?;
    let meant = did_you_mean(unknown, known.iter().copied());
    let known: Vec<_> = known.iter().map(|name| format!("\"{name}\"")).collect();
    Some(format!("{} = \"{unknown}\": must be {}{meant}", at.key, or(&known)))
}

/// Names in a row, the last one after "or".
fn or(names: &[String]) -> String {
    match names {
        [] => "nothing".to_owned(),
        [only] => only.clone(),
        [names @ .., last] => format!("{} or {last}", names.join(", ")),
    }
}

fn wrong_type(at: &Site<'_>, message: &str, written: Option<&str>) -> Option<String> {
    let (kind, found_and_wanted) = message
        .split_once(": ")
        .filter(|(kind, _)| ["invalid type", "invalid value"].contains(kind))
        .or_else(|| message.strip_prefix("invalid length ").map(|rest| ("invalid length", rest)))?;
    let (found, wanted) = found_and_wanted.split_once(", expected ")?;
    let key = &at.key;
    if kind == "invalid length" {
        let wanted = wanted.strip_prefix("an array of length ").unwrap_or(wanted);
        return Some(format!("{key}: must have {wanted} values, but has {found}"));
    }
    if (found, wanted) == ("map", "a sequence") {
        return Some(format!("{key}: write [[{key}]] in double brackets, once for each"));
    }
    let wanted = in_words(wanted);
    let number = written.and_then(|text| text.trim_matches(['"', '\'']).parse::<f64>().ok());
    let quotes = match found.starts_with("string ") && wanted.ends_with("number") {
        true if number.is_some() => ", without quotes",
        _ => "",
    };
    let short = written.filter(|value| is_short(value));
    Some(match short {
        Some(value) if !value.starts_with('[') => {
            format!("{key} = {value}: must be {wanted}{quotes}")
        }
        _ => format!("{key}: must be {wanted}{quotes}"),
    })
}

/// What serde wants, in the words of a file.
fn in_words(wanted: &str) -> &str {
    match wanted {
        "f64" | "f32" => "a number",
        "usize" | "u8" | "u16" | "u32" | "u64" | "i8" | "i16" | "i32" | "i64" | "integer" => {
            "a whole number"
        }
        "a boolean" => "true or false",
        "a string" | "path string" => "a text in quotes",
        "a sequence" => "a list in brackets, as in [1, 2]",
        "a map" => "a section with keys of its own",
        wanted if wanted.starts_with("struct ") => "a section with keys of its own",
        wanted => wanted,
    }
}

#[cfg(test)]
mod tests {
    use serde::Deserialize;

    use super::*;

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    #[expect(dead_code, reason = "read by serde only")]
    struct Scenario {
        duration_s: f64,
        #[serde(default)]
        train_alone: bool,
        #[serde(default)]
        title: String,
        stock: Option<String>,
        train: Option<Train>,
    }

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    #[expect(dead_code, reason = "read by serde only")]
    struct Train {
        speed_m_per_s: f64,
        #[serde(default)]
        scheme: Scheme,
        #[serde(default)]
        vehicles: Vec<Group>,
        #[serde(default)]
        wind: [f64; 2],
    }

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    #[expect(dead_code, reason = "read by serde only")]
    struct Group {
        r#type: String,
        count: usize,
    }

    #[derive(Debug, Default, Deserialize)]
    #[serde(rename_all = "lowercase")]
    enum Scheme {
        #[default]
        Sequential,
        Jacobi,
    }

    /// The first line of the message of a wrong file.
    fn first_line(text: &str) -> String {
        let mistake = Document::new("s.toml", text).parse::<Scenario>().unwrap_err();
        mistake.to_string().lines().next().unwrap().to_owned()
    }

    const TRAIN: &str = "duration_s = 1\n[train]\nspeed_m_per_s = 3\n";

    #[test]
    fn unknown_keys_are_answered_with_the_one_that_is_meant_and_those_that_are_known() {
        assert_eq!(
            first_line("duraton_s = 1"),
            "s.toml:1:1: there is no key `duraton_s`; did you mean `duration_s`? Known here: \
             `duration_s`, `train_alone`, `title`, `stock`, `train`"
        );
        let in_a_section = first_line(&format!("{TRAIN}sped = 1\n"));
        assert!(in_a_section.starts_with("s.toml:4:1: there is no key `sped` in train"));
        assert!(in_a_section.contains("Known here: `speed_m_per_s`, `scheme`"));
    }

    /// In TOML a key below a section's line belongs to it, which is easily forgotten.
    #[test]
    fn a_key_of_the_top_that_stands_in_a_section_is_sent_there() {
        assert_eq!(
            first_line(&format!("{TRAIN}stock = \"stock\"\n")),
            "s.toml:4:1: there is no key `stock` in train; it belongs to the top of the file, before \
             the first [section]"
        );
        let section = first_line(&format!("{TRAIN}[train.stock]\n"));
        assert_eq!(section, "s.toml:4:8: there is no key `stock` in train; write [stock]");
    }

    #[test]
    fn missing_keys_are_named_with_their_section() {
        assert_eq!(first_line("title = \"t\""), "s.toml: duration_s is missing");
        let group = "[[train.vehicles]]\ntype = \"wagon\"\n";
        let line = first_line(&format!("{TRAIN}{group}"));
        assert_eq!(line, "s.toml:4:1: train.vehicles[1].count is missing");
    }

    #[test]
    fn types_are_named_in_words() {
        let quoted = "s.toml:1:14: duration_s = \"0.5\": must be a number, without quotes";
        assert_eq!(first_line("duration_s = \"0.5\""), quoted);
        assert_eq!(
            first_line("duration_s = \"long\""),
            "s.toml:1:14: duration_s = \"long\": must be a number"
        );
        let count = format!("{TRAIN}vehicles = [{{ type = \"wagon\", count = -2 }}]");
        assert_eq!(
            first_line(&count),
            "s.toml:4:39: train.vehicles[1].count = -2: must be a whole number"
        );
        let alone = first_line("duration_s = 1\ntrain_alone = \"yes\"");
        assert_eq!(alone, "s.toml:2:15: train_alone = \"yes\": must be true or false");
        let title = first_line("duration_s = 1\ntitle = 7");
        assert_eq!(title, "s.toml:2:9: title = 7: must be a text in quotes");
        assert!(
            first_line("duration_s = 1\ntrain = 7")
                .ends_with("must be a section with keys of its own")
        );
        let wind = first_line(&format!("{TRAIN}wind = [1.0]"));
        assert!(wind.contains("train.wind: must have 2 values, but has 1"), "{wind}");
    }

    #[test]
    fn choices_are_listed() {
        let line = first_line(&format!("{TRAIN}scheme = \"jacoby\""));
        let wanted = "train.scheme = \"jacoby\": must be \"sequential\" or \"jacobi\"; did you mean \
                      `jacobi`?";
        assert_eq!(line, format!("s.toml:4:10: {wanted}"));
    }

    #[test]
    fn brackets_and_double_keys_are_put_right() {
        let single = first_line(&format!("{TRAIN}[train.vehicles]\ntype = \"wagon\"\ncount = 1\n"));
        assert!(
            single.ends_with("write [[train.vehicles]] in double brackets, once for each"),
            "{single}"
        );
        let mixed = "[train.vehicles]\ntype = \"a\"\n[[train.vehicles]]\ntype = \"b\"\n";
        let mixed = first_line(&format!("{TRAIN}{mixed}"));
        assert!(mixed.contains("write [[train.vehicles]] in double brackets for each"), "{mixed}");
        assert!(first_line("duration_s = 1\nduration_s = 2").ends_with("leave one of them out"));
        let section = first_line(&format!("{TRAIN}[train]\n"));
        assert!(section.ends_with("the section [train] stands twice; put its keys together"));
    }

    #[test]
    fn numbers_with_a_comma_or_a_unit_are_put_right() {
        let comma = first_line("duration_s = 16,67");
        assert_eq!(comma, "s.toml:1:16: a number has a decimal point, not a comma");
        let text = first_line("title = my train");
        assert_eq!(text, "s.toml:1:9: a text needs quotes");
        let unit = first_line("duration_s = 10 s");
        assert!(
            unit.ends_with("a number stands alone; its unit is at the end of the key"),
            "{unit}"
        );
    }

    #[test]
    fn what_is_not_known_here_is_passed_on() {
        let open = first_line("title = \"open\nduration_s = 1");
        assert!(open.starts_with("s.toml:1:"), "{open}");
        assert!(open.len() > "s.toml:1:14: ".len(), "{open}");
    }
}
