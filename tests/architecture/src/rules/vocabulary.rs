//! One word for one thing, and it is the field's (docs/vocabulary.md).

use proc_macro2::{TokenStream, TokenTree};

use crate::breach::Breach;
use crate::workspace::Workspace;

/// Words that no identifier of the sources holds, and what to say instead.
const WORDS: &[(&str, &str)] = &[
    ("act", "apply"),
    ("apart", "separate, check_until"),
    ("felt", "received, applied"),
    ("foresee", "check_until"),
    ("give_up", "mark_fatal, stop"),
    ("go_on", "continue, continue_after_run"),
    ("hear", "arrival, pressure_command"),
    ("heard", "arrived, pressure_command"),
    ("listen", "subscribe, receive"),
    ("lose", "mark_fatal, fail"),
    ("operate", "update_brakes"),
    ("place", "number, index, outputs, motion, chainage, lateral"),
    ("places", "numbers, indices, positions"),
    ("told", "warned, reported"),
    ("way", "conversion, distance, arm"),
    ("ways", "conversions, distances, arms"),
];

/// Identifiers that hold a word of the list.
pub fn breaches(workspace: &Workspace) -> Vec<Breach> {
    let mut found = vec![];
    for package in &workspace.packages {
        for source in package.sources.iter().filter(|source| package.is_product(source)) {
            let tokens = source.text.parse().expect("what was parsed consists of tokens");
            let mut identifiers = vec![];
            collect(tokens, &mut identifiers);
            let code = source.text.lines().count() - source.lines_of_tests();
            for (identifier, line) in identifiers.into_iter().filter(|(_, line)| *line <= code) {
                if let Some((word, instead)) = unwanted(&identifier) {
                    let message = format!("`{identifier}` says '{word}'; better: {instead}");
                    found.push(Breach::new(&source.path, line, message));
                }
            }
        }
    }
    found.sort();
    found.dedup();
    found
}

/// Identifiers with their lines.
fn collect(tokens: TokenStream, found: &mut Vec<(String, usize)>) {
    for token in tokens {
        match token {
            TokenTree::Ident(ident) => {
                found.push((ident.to_string(), ident.span().start().line));
            }
            TokenTree::Group(group) => collect(group.stream(), found),
            _ => {}
        }
    }
}

/// The word of the list that an identifier holds, and what to say instead.
fn unwanted(identifier: &str) -> Option<(&'static str, &'static str)> {
    let snake = format!("_{}_", snake_case(identifier));
    WORDS.iter().copied().find(|(word, _)| snake.contains(&format!("_{word}_")))
}

/// `WheelPlace` and `WHEEL_PLACE` become `wheel_place`.
fn snake_case(identifier: &str) -> String {
    let mut snake = String::new();
    let mut before = '_';
    for letter in identifier.chars() {
        if letter.is_uppercase() && before.is_lowercase() {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
        before = letter;
    }
    snake
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_found_within_identifiers() {
        for identifier in ["place", "Place", "wheel_place", "WheelPlace", "FIRST_PLACE", "give_up"]
        {
            assert!(unwanted(identifier).is_some(), "{identifier}");
        }
    }

    #[test]
    fn other_words_that_hold_the_same_letters_are_not() {
        for identifier in ["replace", "placement", "always", "active", "wayside", "gives_up"] {
            assert_eq!(unwanted(identifier), None, "{identifier}");
        }
    }
}
