//! Rules on the names and value references of variables (§2.2.7, §2.2.9).

use std::collections::HashMap;

use super::description::{Description, Variable};
use super::rule::{Breaches, Rule, Severity};

pub const RULES: &[Rule] = &[
    Rule {
        name: "names-are-unique",
        severity: Severity::Error,
        wants: "no two variables have the same name",
        check: unique,
    },
    Rule {
        name: "names-are-structured",
        severity: Severity::Error,
        wants: "with the naming convention `structured`, names have the form `a.b[1].c` or `der(a)`",
        check: structured,
    },
    Rule {
        name: "aliases-have-one-start",
        severity: Severity::Error,
        wants: "of the variables with one value reference at most one has a start value",
        check: aliases,
    },
];

fn unique(description: &Description<'_>, breaches: &mut Breaches) {
    let mut first = HashMap::new();
    for Variable { element, index, name, .. } in &description.variables {
        let earlier = *first.entry(*name).or_insert(index);
        if earlier != index {
            breaches.at(*element, format!("`{name}` is the name of variable {earlier} already"));
        }
    }
}

fn structured(description: &Description<'_>, breaches: &mut Breaches) {
    if description.root.attribute("variableNamingConvention") != Some("structured") {
        return;
    }
    for Variable { element, name, .. } in &description.variables {
        if !is_structured(name) {
            let sentence = format!(
                "`{name}` is no structured name: words of letters, digits and underscores (or any \
                 text in single quotes) with dots between them and indices as [1,2]"
            );
            breaches.at(*element, sentence);
        }
    }
}

/// `name = identifier | "der(" identifier ["," number] ")"` (§2.2.9).
fn is_structured(name: &str) -> bool {
    match name.strip_prefix("der(").and_then(|rest| rest.strip_suffix(')')) {
        None => is_identifier(name),
        Some(inside) => match inside.rsplit_once(',') {
            Some((identifier, order)) if is_number(order) => is_identifier(identifier),
            _ => is_identifier(inside),
        },
    }
}

/// Words with dots between them, each with indices if it is an array.
fn is_identifier(text: &str) -> bool {
    let Some(mut rest) = after_word(text) else { return false };
    loop {
        if let Some(indices) = rest.strip_prefix('[') {
            let Some((numbers, after)) = indices.split_once(']') else { return false };
            if !numbers.split(',').all(is_number) {
                return false;
            }
            rest = after;
        }
        let Some(next) = rest.strip_prefix('.') else { return rest.is_empty() };
        match after_word(next) {
            Some(after) => rest = after,
            None => return false,
        }
    }
}

/// What follows the word at the beginning of the text.
fn after_word(text: &str) -> Option<&str> {
    if let Some(quoted) = text.strip_prefix('\'') {
        return after_quote(quoted);
    }
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let end = text.find(|c| !is_part(c)).unwrap_or(text.len());
    let begins = text.starts_with(|c: char| is_part(c) && !c.is_ascii_digit());
    begins.then(|| &text[end..])
}

/// What follows the closing quote; a backslash takes the meaning from the mark behind it.
fn after_quote(quoted: &str) -> Option<&str> {
    let mut escaped = false;
    for (index, mark) in quoted.char_indices() {
        match mark {
            '\'' if !escaped => return (index > 0).then(|| &quoted[index + 1..]),
            _ => escaped = mark == '\\' && !escaped,
        }
    }
    None
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

fn aliases(description: &Description<'_>, breaches: &mut Breaches) {
    let mut with_start: HashMap<_, &str> = HashMap::new();
    for variable in &description.variables {
        let Some(reference) = variable.reference else { continue };
        if variable.of_kind("start").is_none() || variable.variability == "constant" {
            continue;
        }
        // Integers and enumerations are got and set by the same functions.
        let kind = match variable.type_name() {
            "Enumeration" => "Integer",
            kind => kind,
        };
        let earlier = *with_start.entry((kind, reference)).or_insert(variable.name);
        if earlier != variable.name {
            let sentence = format!(
                "`{}` and `{earlier}` are the same {kind} variable (value reference {reference}), \
                 but both have a start value; only one may",
                variable.name
            );
            breaches.at(variable.element, sentence);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_the_standard_are_structured() {
        for name in [
            "x",
            "_x1",
            "vehicle[1].wheelset[12].left.force",
            "a[1,2].b",
            "der(a.b[1])",
            "der(x,2)",
            "'any text, even [ and . and \\' in it'.b",
        ] {
            assert!(is_structured(name), "{name}");
        }
        for name in [
            "", "v 1", "1a", "a.", ".a", "a..b", "a[1", "a[]", "a[x]", "a[1]b", "''", "'a", "der(x",
        ] {
            assert!(!is_structured(name), "{name}");
        }
    }
}
