//! `terminalsAndIcons.xml`: which variables belong together, such as those of a coupler.
//!
//! With it a tool connects them by one line (§2.3; the file is that of FMI 3.0 §2.4.9).

use std::path::Path;

use serde::Serialize;

use super::model_description::to_xml;
use crate::error::Error;
use crate::instance::interface::Interface;
use crate::model::Model;
use crate::variables::{Causality, Declaration, Terminal};

#[derive(Serialize)]
#[serde(rename = "fmiTerminalsAndIcons")]
struct Root<'a> {
    #[serde(rename = "@fmiVersion")]
    fmi_version: &'static str,
    #[serde(rename = "Terminals")]
    terminals: List<'a>,
}

#[derive(Serialize)]
struct List<'a> {
    #[serde(rename = "Terminal")]
    terminals: Vec<Element<'a>>,
}

#[derive(Serialize)]
struct Element<'a> {
    #[serde(rename = "@name")]
    name: &'a str,
    #[serde(rename = "@matchingRule")]
    matching_rule: &'static str,
    #[serde(rename = "@terminalKind")]
    kind: String,
    #[serde(rename = "@description")]
    description: &'a str,
    #[serde(rename = "TerminalMemberVariable")]
    members: Vec<Member<'a>>,
}

#[derive(Serialize)]
struct Member<'a> {
    #[serde(rename = "@variableName")]
    variable: &'a str,
    #[serde(rename = "@memberName")]
    name: &'a str,
    #[serde(rename = "@variableKind")]
    kind: &'static str,
}

/// The text of `terminalsAndIcons.xml` of a model with the files in `resources`.
///
/// It is empty if the model declares no terminals.
///
/// # Errors
/// When the interface cannot be formed from the resources.
pub fn terminals<M: Model>(resources: &Path) -> Result<String, Error> {
    let interface = Interface::<M>::new(resources)?;
    write(&interface.declaration)
}

fn write(declaration: &Declaration) -> Result<String, Error> {
    let terminals: Vec<_> =
        declaration.terminals().iter().map(|terminal| element(declaration, terminal)).collect();
    match terminals.is_empty() {
        true => Ok(String::new()),
        false => to_xml(&Root { fmi_version: "3.0", terminals: List { terminals } }),
    }
}

fn element<'a>(declaration: &'a Declaration, terminal: &'a Terminal) -> Element<'a> {
    let members = declaration.variables().iter().filter_map(|variable| {
        let name = variable.name.strip_prefix(&terminal.name)?.strip_prefix('.')?;
        // Parameters are set, not connected.
        let connected = matches!(variable.causality, Causality::Input | Causality::Output);
        connected.then_some(Member { variable: &variable.name, name, kind: "signal" })
    });
    Element {
        name: &terminal.name,
        matching_rule: "plug",
        kind: format!("hotfoot.{}", terminal.kind),
        description: &terminal.description,
        members: members.collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::variables::unit;

    #[test]
    fn a_terminal_has_the_variables_whose_names_begin_with_it() {
        let mut declaration = Declaration::default();
        declaration.terminal("coupler.front", "coupler", "Front coupler");
        let _ = declaration.real("coupler.front.force", unit::NEWTON, "Force").input(0.0);
        let _ = declaration.real("coupler.frontal.force", unit::NEWTON, "Other").input(0.0);
        let _ = declaration.real("coupler.front.slack", unit::METRE, "Slack").parameter(0.0);
        let text = write(&declaration).expect("it can be written");
        assert_eq!(text.matches("<TerminalMemberVariable").count(), 1, "{text}");
        for part in [
            r#"<fmiTerminalsAndIcons fmiVersion="3.0">"#,
            r#"name="coupler.front" matchingRule="plug" terminalKind="hotfoot.coupler""#,
            r#"variableName="coupler.front.force" memberName="force" variableKind="signal""#,
        ] {
            assert!(text.contains(part), "{part}\n{text}");
        }
    }

    #[test]
    fn without_terminals_there_is_no_file() {
        assert_eq!(write(&Declaration::default()).expect("it can be written"), "");
    }
}
