//! A constant of nature stands in one file of the sources.

use proc_macro2::{TokenStream, TokenTree};

use crate::breach::Breach;
use crate::workspace::Workspace;

/// A constant: what it is, how its value begins and ends in any precision, and the name to use.
struct Constant {
    what: &'static str,
    begin: &'static str,
    end: &'static str,
    name: &'static str,
}

impl Constant {
    fn is(&self, number: &str) -> bool {
        number.starts_with(self.begin) && number.ends_with(self.end)
    }
}

const CONSTANTS: [Constant; 2] = [
    Constant {
        what: "the acceleration of gravity",
        begin: "9.8",
        end: "",
        name: "numerics::constants::STANDARD_GRAVITY",
    },
    Constant {
        what: "the Stefan-Boltzmann constant",
        begin: "5.67",
        end: "e-8",
        name: "numerics::constants::STEFAN_BOLTZMANN",
    },
];

/// The file in which they stand.
const FILE: &str = "crates/numerics/src/constants.rs";

/// Numbers in other sources that are a constant of nature.
pub fn breaches(workspace: &Workspace) -> Vec<Breach> {
    let mut found = vec![];
    for package in &workspace.packages {
        let sources = package.sources.iter().filter(|source| package.is_product(source));
        for source in sources.filter(|source| !source.path.ends_with(FILE)) {
            let code = source.text.lines().count() - source.lines_of_tests();
            let tokens = source.text.parse().expect("what was parsed consists of tokens");
            let mut numbers = vec![];
            collect(tokens, &mut numbers);
            for (number, line) in numbers {
                let constant = CONSTANTS.iter().find(|constant| constant.is(&number));
                if let Some(Constant { what, name, .. }) = constant
                    && line <= code
                {
                    let message = format!("{number} is {what}: use `{name}`");
                    found.push(Breach::new(&source.path, line, message));
                }
            }
        }
    }
    found
}

/// Numbers with their lines.
fn collect(tokens: TokenStream, found: &mut Vec<(String, usize)>) {
    for token in tokens {
        match token {
            TokenTree::Literal(literal) => {
                found.push((literal.to_string(), literal.span().start().line));
            }
            TokenTree::Group(group) => collect(group.stream(), found),
            _ => {}
        }
    }
}
