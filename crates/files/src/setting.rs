//! Values of the command line that stand in a TOML text before it is read.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::document::Document;
use crate::key::{self, Found};
use crate::mistake::Mistake;

/// A key of a file with the value that it is given, as in `train.speed_m_per_s=20`.
///
/// Keys are written as in `key.rs`. A value that is no TOML is a text, so that its quotes may be
/// left out; a text such as `60E1`, which is a number too, needs them.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Setting {
    key: String,
    value: String,
}

impl FromStr for Setting {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('=').map(|(key, value)| (key.trim(), value.trim()));
        let Some((key, value)) = parts
            .filter(|(key, value)| !key.is_empty() && !value.is_empty() && !value.contains('\n'))
        else {
            return Err("must be a key and its value, as in train.speed_m_per_s=20".to_owned());
        };
        let alone = toml::from_str::<toml::Table>(&format!("value = {value}"));
        let value = match alone.is_ok() {
            true => value.to_owned(),
            false => toml::Value::from(value).to_string(),
        };
        Ok(Self { key: key.to_owned(), value })
    }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "--set {}={}", self.key, self.value)
    }
}

impl Document {
    /// The document with these values in it; its name says so.
    ///
    /// # Errors
    /// When a key is a section, or lies in a value or in an element of a list that is not there.
    pub fn with(&self, settings: &[Setting]) -> Result<Self, Mistake> {
        let (mut name, mut text) = (format!("{} with", self.name()), self.text().to_owned());
        for setting in settings {
            name += &format!(" {setting}");
            text = setting.put_into(&text).ok_or_else(|| {
                let wanted = "set the key of a single value, in a section or an element of a list that is there";
                Mistake::in_file(self.name(), format!("{setting}: cannot be set; {wanted}"))
            })?;
        }
        Ok(Self::new(name, text))
    }
}

impl Setting {
    /// The text with the value in it; nothing if that is no TOML any more.
    fn put_into(&self, text: &str) -> Option<String> {
        let Self { key, value } = self;
        let mut changed = text.to_owned();
        match key::find(text, key) {
            Some(Found::Value(bytes)) => changed.replace_range(bytes, value),
            _ => {
                let (at, line) = self.new_line(text);
                changed.insert_str(at, &line);
            }
        }
        matches!(key::find(&changed, key), Some(Found::Value(_))).then_some(changed)
    }

    /// Where a key that is not there belongs, and what is to stand there: in the innermost section that is
    /// there, or before all of them.
    fn new_line(&self, text: &str) -> (usize, String) {
        let Self { key, value } = self;
        for (section, name) in sections(key) {
            let Some(Found::Value(bytes)) = key::find(text, section) else { continue };
            let written = &text[bytes.clone()];
            if written.starts_with('{') {
                return (bytes.start + 1, format!(" {name} = {value},"));
            }
            // The header of a section within it.
            let line = text[..bytes.start].rfind('\n').map_or(0, |end| end + 1);
            if text[line..].starts_with('[') && section.ends_with(written) {
                return (line, format!("[{section}]\n{name} = {value}\n"));
            }
            let header = written.trim_matches(['[', ']', ' ']);
            if header == section.rsplit_once('[').map_or(section, |(list, _)| list) {
                let end = text[bytes.end..].find('\n').map_or(text.len(), |end| bytes.end + end);
                return (end, format!("\n{name} = {value}"));
            }
        }
        (0, format!("{key} = {value}\n"))
    }
}

/// The sections that may hold a key, the innermost one first, each with the name of the key in it.
fn sections(key: &str) -> impl Iterator<Item = (&str, &str)> {
    let is_outside = |at: &usize| key[..*at].matches('"').count().is_multiple_of(2);
    let dots = key.rmatch_indices('.').map(|(at, _)| at).filter(move |at| is_outside(at));
    dots.map(|at| (&key[..at], &key[at + 1..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "step_s = 0.001\n[train]  # of two\nspeed = 3.0\nwind = { speed = 1 }\n\
        [[train.vehicles]]\ncount = 1\n[[train.vehicles]]\ncount = 22\nlist = [4, 55]\n\
        [heat.parameters]\n\"cell.size\" = 7\n";

    /// The text with a setting, of which the line that is new or changed.
    fn changed(setting: &str) -> String {
        let document = Document::new("s.toml", TEXT).with(&[setting.parse().unwrap()]).unwrap();
        let before: Vec<_> = TEXT.lines().collect();
        let lines = document.text().lines().filter(|line| !before.contains(line));
        lines.collect::<Vec<_>>().join("; ")
    }

    #[test]
    fn a_value_that_is_there_is_replaced() {
        assert_eq!(changed("train.speed=20"), "speed = 20");
        assert_eq!(changed("step_s = 1e-4"), "step_s = 1e-4");
        assert_eq!(changed("train.vehicles[2].count=64"), "count = 64");
        assert_eq!(changed("train.vehicles[2].list[1]=9"), "list = [9, 55]");
        assert_eq!(changed("train.vehicles[2].list=[]"), "list = []");
        assert_eq!(changed("train.wind.speed=2"), "wind = { speed = 2 }");
        assert_eq!(changed("heat.parameters.\"cell.size\"=8"), "\"cell.size\" = 8");
    }

    #[test]
    fn a_key_that_is_not_there_comes_into_its_section() {
        assert_eq!(changed("train.couplers=unstressed"), "couplers = \"unstressed\"");
        assert_eq!(changed("train.vehicles[2].group=1"), "group = 1");
        assert_eq!(changed("train.wind.angle=2"), "wind = { angle = 2, speed = 1 }");
        assert_eq!(changed("heat.parameters.\"section.rail\"=AS60"), "\"section.rail\" = \"AS60\"");
        assert_eq!(changed("heat.rail=both"), "[heat]; rail = \"both\"");
        assert_eq!(changed("record.interval_s=0.5"), "record.interval_s = 0.5");
        for key in ["train.couplers", "train.vehicles[2].group", "heat.rail", "record.interval_s"] {
            let setting = Setting { key: key.to_owned(), value: "1".to_owned() };
            let text = setting.put_into(TEXT).unwrap();
            assert!(matches!(key::find(&text, key), Some(Found::Value(_))), "{text}");
        }
    }

    #[test]
    fn what_cannot_be_set_is_told_with_the_option() {
        for setting in ["train=5", "train.vehicles[3].count=1", "train.speed.unit=1"] {
            let document = Document::new("s.toml", TEXT);
            let message = document.with(&[setting.parse().unwrap()]).unwrap_err().to_string();
            assert!(
                message.starts_with(&format!("s.toml: --set {setting}: cannot be")),
                "{message}"
            );
        }
        for text in ["train.speed", "=5", "train.speed=", "step_s=1\nx = 2"] {
            assert!(text.parse::<Setting>().unwrap_err().contains("a key and its value"), "{text}");
        }
    }

    /// Several settings are named together; a value cannot bring keys of its own.
    #[test]
    fn the_name_of_the_document_says_what_was_set() {
        let settings = ["step_s=a b", "train.speed=4"].map(|text| text.parse().unwrap());
        let document = Document::new("s.toml", TEXT).with(&settings).unwrap();
        assert_eq!(document.name(), "s.toml with --set step_s=\"a b\" --set train.speed=4");
    }
}
