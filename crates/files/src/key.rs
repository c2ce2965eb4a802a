//! Where the value of a key stands in a TOML text, and which key stands at a byte of it.
//!
//! Keys are written as in `train.vehicles[2].count`: tables by name, elements of lists by number from 1, and
//! a name that holds a dot in quotes, as in `heat.parameters."cell.size"`.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

/// Where a key stands.
#[derive(Debug, PartialEq)]
pub enum Found {
    /// The bytes of its value.
    Value(Range<usize>),
    /// The key is not there; the bytes of the table or list that should hold it.
    Holder(Range<usize>),
}

/// A step from a value into it.
#[derive(Debug, PartialEq)]
enum Step<'a> {
    Name(&'a str),
    /// From 0.
    Index(usize),
}

/// The steps of a key.
fn steps(key: &str) -> Vec<Step<'_>> {
    let mut steps = vec![];
    let mut rest = key;
    while let Some(begin) = rest.find(|c| c != '.' && c != ']') {
        rest = &rest[begin..];
        let (step, length) = match rest.as_bytes()[0] {
            b'"' => {
                let end = rest[1..].find('"').map_or(rest.len(), |end| end + 1);
                (Step::Name(&rest[1..end]), (end + 1).min(rest.len()))
            }
            b'[' => {
                let end = rest.find(']').unwrap_or(rest.len());
                let number = rest[1..end].parse::<usize>().ok();
                (Step::Index(number.map_or(usize::MAX, |number| number.wrapping_sub(1))), end)
            }
            _ => {
                let end = rest.find(['.', '[']).unwrap_or(rest.len());
                (Step::Name(&rest[..end]), end)
            }
        };
        steps.push(step);
        rest = &rest[length..];
    }
    steps
}

/// Where `key` stands in a text that is TOML; nothing if not even its first table is there.
pub fn find(text: &str, key: &str) -> Option<Found> {
    let root = DeTable::parse(text).ok()?;
    let mut table = Some(root.get_ref());
    let mut list = None;
    let mut holder = None;
    for step in steps(key) {
        let next = match (step, table, list) {
            (Step::Name(name), Some(table), _) => table.get(name),
            (Step::Index(index), _, Some(list)) => {
                let list: &toml::de::DeArray<'_> = list;
                list.get(index)
            }
            _ => None,
        };
        let Some(next) = next else { return holder.map(Found::Holder) };
        holder = Some(next.span());
        table = next.get_ref().as_table();
        list = next.get_ref().as_array();
    }
    holder.map(Found::Value)
}

/// The key whose name or value holds the byte, the innermost one; empty for the text's own level.
pub fn at(text: &str, byte: usize) -> String {
    let mut key = String::new();
    if let Ok(root) = DeTable::parse(text) {
        descend(root.get_ref(), byte, &mut key);
    }
    key
}

/// Adds to `key` the steps into the table that lead to the byte; says whether there are any.
fn descend(table: &DeTable<'_>, byte: usize, key: &mut String) -> bool {
    table.iter().any(|(name, value)| {
        let before = key.len();
        if before > 0 {
            key.push('.');
        }
        let name_text: &str = name.get_ref();
        match name_text.contains('.') {
            true => *key += &format!("\"{name_text}\""),
            false => *key += name_text,
        }
        let inside = into(value.get_ref(), byte, key);
        let here = inside || name.span().contains(&byte) || value.span().contains(&byte);
        if !here {
            key.truncate(before);
        }
        here
    })
}

/// The same for a value of any kind.
fn into(value: &DeValue<'_>, byte: usize, key: &mut String) -> bool {
    if let Some(table) = value.as_table() {
        return descend(table, byte, key);
    }
    let elements = value.as_array().into_iter().flat_map(|list| list.iter()).enumerate();
    elements.into_iter().any(|(i, element)| {
        let before = key.len();
        *key += &format!("[{}]", i + 1);
        let here = into(element.get_ref(), byte, key) || element.span().contains(&byte);
        if !here {
            key.truncate(before);
        }
        here
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "step_s = 0.001\n[train]\nspeed = 3.0\n[[train.vehicles]]\ncount = 1\n\
        [[train.vehicles]]\ncount = 22\nlist = [4, 55]\n[heat.parameters]\n\"cell.size\" = 7\n";

    fn value(key: &str) -> Option<&str> {
        match find(TEXT, key)? {
            Found::Value(bytes) => Some(&TEXT[bytes]),
            Found::Holder(_) => None,
        }
    }

    #[test]
    fn values_are_found_by_their_keys() {
        assert_eq!(value("step_s"), Some("0.001"));
        assert_eq!(value("train.vehicles[2].count"), Some("22"));
        assert_eq!(value("train.vehicles[2].list[2]"), Some("55"));
        assert_eq!(value("heat.parameters.\"cell.size\""), Some("7"));
    }

    #[test]
    fn a_key_that_is_not_there_is_looked_for_in_what_should_hold_it() {
        for (key, holder) in [
            ("train.vehicles[2].type", "[[train.vehicles]]"),
            ("train.vehicles[2].count.more", "22"),
            ("train.driver", "[train]"),
        ] {
            let Some(Found::Holder(bytes)) = find(TEXT, key) else { panic!("{key}") };
            assert_eq!(&TEXT[bytes], holder, "{key}");
        }
        assert_eq!(find(TEXT, "duration_s"), None);
        assert_eq!(find("no toml", "duration_s"), None);
    }

    #[test]
    fn a_byte_belongs_to_the_innermost_key() {
        let at = |marked: &str| at(TEXT, TEXT.find(marked).unwrap());
        assert_eq!(at("0.001"), "step_s");
        assert_eq!(at("step_s"), "step_s");
        assert_eq!(at("22"), "train.vehicles[2].count");
        assert_eq!(at("55"), "train.vehicles[2].list[2]");
        assert_eq!(at("7"), "heat.parameters.\"cell.size\"");
        assert_eq!(at("[train]"), "train");
    }
}
