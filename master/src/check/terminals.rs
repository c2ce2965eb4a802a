//! Rules on terminalsAndIcons.xml (§2.3, and FMI 3.0 §2.4.9, whose file it is).

use std::collections::HashSet;
use std::path::Path;

use roxmltree::Document;

use super::rule::{Finding, Severity};

/// Where the file lies in an FMU.
pub const FILE: &str = "terminalsAndIcons/terminalsAndIcons.xml";

/// Checks the file where there is one: it must be XML, and name variables that there are.
pub fn check(folder: &Path, description: &str) -> Vec<Finding> {
    let Ok(text) = std::fs::read_to_string(folder.join(FILE)) else {
        return vec![];
    };
    let error =
        |rule, location, sentence| Finding { rule, severity: Severity::Error, location, sentence };
    let document = match Document::parse(&text) {
        Ok(document) => document,
        Err(source) => {
            let location = format!("{FILE}:{}", source.pos().row);
            let sentence = format!("the file is not XML: {source}");
            return vec![error("terminals-are-xml", location, sentence)];
        }
    };
    let Ok(description) = Document::parse(description) else {
        return vec![];
    };
    let scalars = description.descendants().filter(|node| node.has_tag_name("ScalarVariable"));
    let known: HashSet<_> = scalars.filter_map(|scalar| scalar.attribute("name")).collect();
    let members = document.descendants().filter(|node| node.has_tag_name("TerminalMemberVariable"));
    members
        .filter_map(|member| member.attribute("variableName").map(|name| (member, name)))
        .filter(|(_, name)| !known.contains(name))
        .map(|(member, name)| {
            let line = document.text_pos_at(member.range().start).row;
            let sentence = format!("there is no variable `{name}` in modelDescription.xml");
            error("terminals-name-variables", format!("{FILE}:{line}"), sentence)
        })
        .collect()
}
