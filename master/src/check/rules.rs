//! All rules for a model description, and how they are put to one.

use super::description::Description;
use super::rule::{Breaches, Finding, Rule, Severity};
use super::{dependencies, kinds, names, root, schema, start, structure, units};

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
pub const FILE: &str = "modelDescription.xml";

/// Checks the text of a modelDescription.xml.
pub fn check_description(text: &str) -> Vec<Finding> {
    let document = match roxmltree::Document::parse(text) {
        Ok(document) => document,
        Err(error) => {
            return vec![Finding {
                rule: "xml-is-well-formed",
                severity: Severity::Error,
                location: format!("{FILE}:{}", error.pos().row),
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
                let location = format!("{FILE}:{line}");
                (line, Finding { rule: rule.name, severity: rule.severity, location, sentence })
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
