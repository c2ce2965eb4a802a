//! The rules: what each says, and the check that finds what breaks it.

mod boundary;
mod circles;
mod constants;
mod dependencies;
mod elementary;
mod equations;
mod first_lines;
mod map;
mod size;
mod vocabulary;

use crate::breach::Breach;
use crate::workspace::Workspace;

/// A rule that the sources keep.
pub struct Rule {
    /// Name by which the rule is asked for.
    pub name: &'static str,
    /// What holds, as a sentence.
    pub sentence: &'static str,
    /// Finds everything that breaks the rule.
    pub breaches: fn(&Workspace) -> Vec<Breach>,
}

/// Every rule.
pub const RULES: &[Rule] = &[
    Rule {
        name: "circles",
        sentence: "No files of a package use each other in a loop.",
        breaches: circles::breaches,
    },
    Rule { name: "length", sentence: "A file has at most 350 lines.", breaches: size::long_files },
    Rule {
        name: "entries",
        sentence: "The root of a source folder has at most 12 entries.",
        breaches: size::crowded_roots,
    },
    Rule {
        name: "tests",
        sentence: "At least 30 % of the lines are tests.",
        breaches: size::few_tests,
    },
    Rule {
        name: "untested",
        sentence: "A target whose tests are switched off has none.",
        breaches: size::tests_not_run,
    },
    Rule {
        name: "vocabulary",
        sentence: "An identifier says the field's word for a thing.",
        breaches: vocabulary::breaches,
    },
    Rule {
        name: "first-lines",
        sentence: "The doc comment of a public item begins with a line of at most 100 characters.",
        breaches: first_lines::breaches,
    },
    Rule {
        name: "dependencies",
        sentence: "A package depends only on what its part in the house allows.",
        breaches: dependencies::breaches,
    },
    Rule {
        name: "unsafe",
        sentence: "Only the FMI boundary allows unsafe code.",
        breaches: boundary::breaches,
    },
    Rule {
        name: "constants",
        sentence: "A constant of nature stands in one file of the sources.",
        breaches: constants::breaches,
    },
    Rule {
        name: "elementary",
        sentence: "Elementary functions of the models give the same bits on every processor.",
        breaches: elementary::breaches,
    },
    Rule {
        name: "equations",
        sentence: "An equation of the theory has an anchor, is cited by code and is validated.",
        breaches: equations::breaches,
    },
    Rule {
        name: "map",
        sentence: "docs/architecture.md names every package, and no file that does not exist.",
        breaches: map::breaches,
    },
];
