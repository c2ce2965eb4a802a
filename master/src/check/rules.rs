//! All rules for a model description, and how they are put to one.

use super::description::Description;
use super::rule::{Breaches, Finding, Lines, Rule, Severity};
use super::{dependencies, kinds, names, root, schema, start, structure, units};
use crate::files::xml_depth::check_depth;

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
    let no_xml = |line: u32, sentence: String| Finding {
        rule: "xml-is-well-formed",
        severity: Severity::Error,
        location: format!("{FILE}:{line}"),
        sentence: format!("the file is not XML: {sentence}"),
    };
    if let Err(error) = check_depth(text) {
        return vec![no_xml(error.line as u32, error.to_string())];
    }
    let document = match roxmltree::Document::parse(text) {
        Ok(document) => document,
        Err(error) => return vec![no_xml(error.pos().row, error.to_string())],
    };
    let description = Description::new(&document);
    let lines = Lines::of(text);
    let mut findings: Vec<(usize, Finding)> = rules()
        .flat_map(|rule| {
            let mut breaches = Breaches::default();
            (rule.check)(&description, &mut breaches);
            let lines = &lines;
            breaches.0.into_iter().map(move |(byte, sentence)| {
                let line = lines.number(byte);
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
