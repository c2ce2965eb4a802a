//! Rules on terminalsAndIcons.xml (§2.3, and FMI 3.0 §2.4.9, whose file it is).

use std::collections::HashSet;
use std::path::Path;

use roxmltree::Document;

use super::rule::{Finding, Lines, Severity};
use crate::files::xml_depth::check_depth;
use crate::files::xml_text;

/// Where the file lies in an FMU.
pub const FILE: &str = "terminalsAndIcons/terminalsAndIcons.xml";

/// Checks the file where there is one: it must be XML, and name variables that there are.
pub fn check(folder: &Path, description: &str) -> Vec<Finding> {
    let Ok(text) = xml_text::read(&folder.join(FILE)) else {
        return vec![];
    };
    let error =
        |rule, location, sentence| Finding { rule, severity: Severity::Error, location, sentence };
    if let Err(source) = check_depth(&text) {
        let location = format!("{FILE}:{}", source.line);
        return vec![error("terminals-are-xml", location, source.to_string())];
    }
    let lines = Lines::of(&text);
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
            let line = lines.number(member.range().start);
            let sentence = format!("there is no variable `{name}` in modelDescription.xml");
            error("terminals-name-variables", format!("{FILE}:{line}"), sentence)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const DESCRIPTION: &str = r#"<fmiModelDescription><ModelVariables>
        <ScalarVariable name="coupler.force"/><ScalarVariable name="coupler.position"/>
        </ModelVariables></fmiModelDescription>"#;

    /// What is found in an FMU with this terminals file.
    fn found(terminals: &str) -> Vec<String> {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join(FILE);
        std::fs::create_dir_all(file.parent().unwrap()).unwrap();
        std::fs::write(file, terminals).unwrap();
        check(folder.path(), DESCRIPTION).iter().map(ToString::to_string).collect()
    }

    /// The form of the file is that of FMI 3.0.2, section 2.4.9.2.
    fn terminal(variable: &str) -> String {
        format!(
            "<fmiTerminalsAndIcons fmiVersion=\"3.0\">\n<Terminals><Terminal name=\"coupler\" \
             matchingRule=\"plug\">\n<TerminalMemberVariable variableName=\"{variable}\" \
             variableKind=\"signal\"/>\n</Terminal></Terminals></fmiTerminalsAndIcons>"
        )
    }

    #[test]
    fn members_that_are_variables_are_right() {
        assert_eq!(found(&terminal("coupler.force")), [""; 0]);
    }

    #[test]
    fn a_member_that_is_no_variable_is_named_with_its_line() {
        let expected = format!(
            "{FILE}:3: error: there is no variable `coupler.speed` in modelDescription.xml \
             [terminals-name-variables]"
        );
        assert_eq!(found(&terminal("coupler.speed")), [expected]);
    }

    #[test]
    fn what_is_no_xml_is_named_with_its_line() {
        let found = found("<fmiTerminalsAndIcons>\n</Terminals>");
        assert_eq!(found.len(), 1);
        assert!(
            found[0].starts_with(&format!("{FILE}:2: error: the file is not XML")),
            "{found:?}"
        );
    }

    #[test]
    fn an_fmu_needs_no_terminals() {
        let folder = tempfile::tempdir().unwrap();
        assert!(check(folder.path(), DESCRIPTION).is_empty());
    }
}
