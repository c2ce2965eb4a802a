//! `documentation/index.html`: what an FMU shows, in a table for people.

use std::fmt::Write;
use std::path::Path;

use crate::error::Error;
use crate::instance::interface::Interface;
use crate::model::{Identity, Model};
use crate::variables::{Causality, Declaration, Kind, Variability, Variable};

const STYLE: &str = "body{font:16px/1.4 sans-serif;max-width:70em;margin:2em auto;padding:0 1em}\
table{border-collapse:collapse}\
th,td{border-bottom:1px solid #ccc;padding:.2em .6em;text-align:left;vertical-align:top}\
td:first-child{font-family:monospace}";

/// The text of `documentation/index.html` of a model with the files in `resources`.
///
/// # Errors
/// When the interface cannot be formed from the resources.
pub fn documentation<M: Model>(resources: &Path) -> Result<String, Error> {
    let interface = Interface::<M>::new(resources)?;
    Ok(signal_table_html(&M::IDENTITY, &interface.declaration))
}

/// A page with the inputs, outputs and parameters of a model.
pub fn signal_table_html(identity: &Identity, declaration: &Declaration) -> String {
    let name = escape(identity.name);
    let description = escape(identity.description);
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <title>{name}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n\
         <h1>{name}</h1>\n<p>{description}</p>\n\
         <p>An FMU for FMI 2.0 co-simulation. All values are in SI units; positions in the \
         running direction, y to the right, z down; a coupler force is positive in tension. \
         Begin with a step of {} s.</p>\n",
        identity.default_step
    );
    for (title, causality) in [
        ("Inputs", Causality::Input),
        ("Outputs", Causality::Output),
        ("Parameters", Causality::Parameter),
    ] {
        let variables = declaration.variables().iter();
        let rows: String =
            variables.filter(|variable| variable.causality == causality).map(row).collect();
        if !rows.is_empty() {
            // Writing to a text cannot fail.
            let _ = write!(
                page,
                "<h2>{title}</h2>\n<table>\n<tr><th>Name</th><th>Type</th><th>Unit</th>\
                 <th>Start</th><th>Bounds</th><th>Description</th></tr>\n{rows}</table>\n"
            );
        }
    }
    page + "</body>\n</html>\n"
}

fn row(variable: &Variable) -> String {
    let (kind, unit, start) = match &variable.kind {
        Kind::Real { unit, start, .. } => ("Real", unit.symbol, start.to_string()),
        Kind::Integer { start, .. } => ("Integer", "", start.to_string()),
        Kind::Boolean { start } => ("Boolean", "", start.to_string()),
        Kind::Text { start, .. } => ("String", "", format!("\"{start}\"")),
    };
    let start = match variable.causality {
        Causality::Output => String::new(),
        Causality::Input | Causality::Parameter => start,
    };
    let tunable = match variable.variability {
        Variability::Tunable => " (tunable)",
        _ => "",
    };
    let cells = [
        &variable.name,
        &format!("{kind}{tunable}"),
        unit,
        &start,
        &variable.kind.range(),
        &variable.description,
    ];
    let cells: String = cells.iter().map(|cell| format!("<td>{}</td>", escape(cell))).collect();
    format!("<tr>{cells}</tr>\n")
}

/// A text with the marks of HTML escaped.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::variables::unit;

    #[test]
    fn every_variable_has_a_row_under_its_heading() {
        let identity = Identity {
            name: "Model",
            identifier: "model",
            description: "Cars & bogies",
            default_step: 1e-3,
        };
        let mut declaration = Declaration::default();
        let mass = declaration.real("mass", unit::KILOGRAM, "Mass").within(1.0..);
        let _ = mass.tunable(2.0);
        let _ = declaration.real("speed", unit::METRE_PER_SECOND, "<v>").output();
        let page = signal_table_html(&identity, &declaration);
        for part in [
            "<p>Cars &amp; bogies</p>",
            "<td>mass</td><td>Real (tunable)</td><td>kg</td><td>2</td><td>at least 1</td>",
            "<td>speed</td><td>Real</td><td>m/s</td><td></td><td></td><td>&lt;v&gt;</td>",
        ] {
            assert!(page.contains(part), "{part}\n{page}");
        }
        assert!(!page.contains("<h2>Inputs</h2>"), "{page}");
    }
}
