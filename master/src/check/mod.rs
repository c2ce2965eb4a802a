//! `hotfoot check`: the rules of FMI 2.0 for an FMU, each a function with a lasting name.
//!
//! | file | rules |
//! |---|---|
//! | `schema.rs`, `grammar.rs`, `elements.rs` | elements and attributes, as the schema of the standard has them |
//! | `root.rs` | what the FMU is and can do, log categories, default experiment |
//! | `units.rs` | units and types |
//! | `names.rs`, `kinds.rs`, `start.rs` | variables: names and references, what they are, values |
//! | `structure.rs`, `dependencies.rs` | outputs, initial unknowns, and what they depend on |
//! | `package.rs` | the files of the FMU, and its binary |
//! | `terminals.rs` | the terminals |
//! | `reference/` | the reference result that an FMU carries as a self-test |
//!
//! The checkers of other makers each see a part of this (`docs/user-guide/fmus.md` has a table);
//! a rule that any of them enforces is here.

mod dependencies;
mod description;
mod elements;
mod grammar;
mod kinds;
mod names;
mod package;
pub mod reference;
mod root;
mod schema;
mod start;
mod structure;
mod terminals;
#[cfg(test)]
mod tests;
mod units;

use std::fmt;
use std::path::Path;

use description::{Description, Element};
pub(crate) use terminals::FILE as TERMINALS;

/// How much a breach matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Severity {
    /// The standard is broken: some tool refuses the FMU or misreads it.
    Error,
    /// Legal, but some tool complains or works less well.
    Advice,
}

/// A rule that a model description can break.
pub struct Rule {
    /// Lasting name.
    pub name: &'static str,
    /// How much a breach matters.
    pub severity: Severity,
    /// What the rule wants, in a sentence.
    pub wants: &'static str,
    /// Finds the breaches.
    check: fn(&Description<'_>, &mut Breaches),
}

/// What a rule has found: the line, and a sentence that says what stands there and what would be
/// right.
#[derive(Default)]
pub(crate) struct Breaches(Vec<(u32, String)>);

impl Breaches {
    /// A breach at an element.
    pub fn at(&mut self, element: Element<'_>, sentence: String) {
        let line = element.document().text_pos_at(element.range().start).row;
        self.0.push((line, sentence));
    }
}

/// A breach of a rule.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Name of the rule.
    pub rule: &'static str,
    /// How much it matters.
    pub severity: Severity,
    /// File inside of the FMU, with the line where there is one.
    pub place: String,
    /// What is wrong, and what would be right.
    pub sentence: String,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rule, severity, place, sentence } = self;
        let severity = match severity {
            Severity::Error => "error",
            Severity::Advice => "advice",
        };
        write!(f, "{place}: {severity}: {sentence} [{rule}]")
    }
}

/// All rules for a model description.
pub fn rules() -> impl Iterator<Item = &'static Rule> {
    [
        schema::RULES,
        root::RULES,
        units::RULES,
        names::RULES,
        kinds::RULES,
        start::RULES,
        structure::RULES,
        dependencies::RULES,
    ]
    .into_iter()
    .flatten()
}

/// Name of the file with the model description.
const FILE: &str = "modelDescription.xml";

/// Checks the text of a modelDescription.xml.
pub fn check_description(text: &str) -> Vec<Finding> {
    let document = match roxmltree::Document::parse(text) {
        Ok(document) => document,
        Err(error) => {
            return vec![Finding {
                rule: "xml-is-well-formed",
                severity: Severity::Error,
                place: format!("{FILE}:{}", error.pos().row),
                sentence: format!("the file is not XML: {error}"),
            }];
        }
    };
    let description = Description::new(&document);
    let mut findings: Vec<(u32, Finding)> = rules()
        .flat_map(|rule| {
            let mut breaches = Breaches::default();
            (rule.check)(&description, &mut breaches);
            breaches.0.into_iter().map(|(line, sentence)| {
                let place = format!("{FILE}:{line}");
                (line, Finding { rule: rule.name, severity: rule.severity, place, sentence })
            })
        })
        .collect();
    findings.sort_by_key(|(line, _)| *line);
    let mut findings: Vec<_> = findings.into_iter().map(|(_, finding)| finding).collect();
    // To a file of another version most rules do not apply.
    if let Some(version) = findings.iter().position(|finding| finding.rule == root::VERSION) {
        findings = vec![findings.swap_remove(version)];
    }
    findings
}

/// Checks an FMU: its archive, its model description and its binary.
pub fn check(fmu: &Path) -> Vec<Finding> {
    package::check(fmu)
}
