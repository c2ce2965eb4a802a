//! The elementary functions of the models do not hang on the processor.
//!
//! Those of the system's C library do: glibc chooses among versions with and without fused
//! multiplication, whose last bits differ. The crate `libm` computes the same bits everywhere.

use std::path::Path;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use super::dependencies::PHYSICS;
use crate::breach::Breach;
use crate::workspace::Workspace;

/// Methods of `f64` that the C library computes, and the functions of `libm` in their place.
const METHODS: [(&str, &str); 22] = [
    ("acos", "acos"),
    ("acosh", "acosh"),
    ("asin", "asin"),
    ("asinh", "asinh"),
    ("atan", "atan"),
    ("atan2", "atan2"),
    ("atanh", "atanh"),
    ("cbrt", "cbrt"),
    ("cos", "cos"),
    ("cosh", "cosh"),
    ("exp", "exp"),
    ("exp_m1", "expm1"),
    ("hypot", "hypot"),
    ("ln", "log"),
    ("ln_1p", "log1p"),
    ("log10", "log10"),
    ("powf", "pow"),
    ("sin", "sin"),
    ("sin_cos", "sincos"),
    ("sinh", "sinh"),
    ("tan", "tan"),
    ("tanh", "tanh"),
];

/// Calls of these methods in the sources of the models.
pub fn breaches(workspace: &Workspace) -> Vec<Breach> {
    let mut found = vec![];
    let is_physics = |folder: &Path| PHYSICS.iter().any(|physics| folder == Path::new(physics));
    for package in workspace.packages.iter().filter(|package| is_physics(&package.folder)) {
        for source in package.sources.iter().filter(|source| package.is_product(source)) {
            let code = source.text.lines().count() - source.lines_of_tests();
            let tokens = source.text.parse().expect("what was parsed consists of tokens");
            let mut calls = vec![];
            collect(tokens, &mut calls);
            for (method, function, line) in calls.into_iter().filter(|(_, _, line)| *line <= code) {
                let message = format!("`{method}` hangs on the processor: use `libm::{function}`");
                found.push(Breach::new(&source.path, line, message));
            }
        }
    }
    found
}

/// Method, function in its place, and line of each call: an identifier behind a dot or `f64::` and,
/// in the former case, before parentheses.
fn collect(tokens: TokenStream, found: &mut Vec<(&'static str, &'static str, usize)>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (index, token) in tokens.iter().enumerate() {
        match token {
            TokenTree::Group(group) => collect(group.stream(), found),
            TokenTree::Ident(name) => {
                let method = METHODS.iter().find(|(method, _)| name == method);
                let called = matches!(
                    tokens.get(index + 1),
                    Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis
                );
                let text = |back: usize| index.checked_sub(back).map(|at| tokens[at].to_string());
                let behind_dot = text(1).as_deref() == Some(".") && called;
                let of_type = text(3).as_deref() == Some("f64");
                if let Some(&(method, function)) = method
                    && (behind_dot || of_type)
                {
                    found.push((method, function, name.span().start().line));
                }
            }
            _ => {}
        }
    }
}
