//! From the connections of nested systems to those between FMUs.

use std::collections::HashMap;

use crate::interface::si::Linear;
use crate::system::structure::{Connection, ConnectorKind, Endpoint, Sampling, Structure};

/// A connection as a system states it: either end may be a connector of a system, whose element
/// is then the system's full name.
#[derive(Debug, Clone, PartialEq)]
pub struct Edge {
    /// Where the value comes from.
    pub from: Endpoint,
    /// Where it goes.
    pub to: Endpoint,
    /// What is done to it.
    pub transformation: Linear,
    /// Whether units are converted.
    pub convert_units: bool,
}

/// Follows every component's inputs back to the component that gives the value. An input that
/// leads to the outermost system is not connected.
///
/// # Errors
/// A sentence when the connectors of systems are connected in a circle.
pub fn trace(edges: &[Edge], structure: &Structure) -> Result<Vec<Connection>, String> {
    let giver: HashMap<&Endpoint, &Edge> = edges.iter().map(|edge| (&edge.to, edge)).collect();
    let mut connections = vec![];
    for component in &structure.components {
        for connector in &component.connectors {
            let takes = matches!(connector.kind, ConnectorKind::Input | ConnectorKind::Parameter);
            let to =
                Endpoint { element: component.name.clone(), connector: connector.name.clone() };
            if takes {
                connections.extend(back(to, &giver, structure)?);
            }
        }
    }
    Ok(connections)
}

/// The connection to an input, through the connectors of systems in between.
fn back(
    to: Endpoint,
    giver: &HashMap<&Endpoint, &Edge>,
    structure: &Structure,
) -> Result<Option<Connection>, String> {
    let mut at = &to;
    let mut transformation = Linear::IDENTITY;
    let mut convert_units = true;
    // Hierarchy is finite, but a file may connect a system's connectors in a circle.
    for _ in 0..giver.len() {
        let Some(edge) = giver.get(at) else { return Ok(None) };
        transformation = edge.transformation.then(transformation);
        convert_units &= edge.convert_units;
        if structure.component(&edge.from.element).is_some() {
            let from = edge.from.clone();
            let sampling = Sampling::default();
            let connection = Connection { from, to, transformation, convert_units, sampling };
            return Ok(Some(connection));
        }
        at = &edge.from;
    }
    match giver.contains_key(at) {
        true => Err(format!("the connections that lead to '{to}' go round in a circle of systems")),
        false => Ok(None),
    }
}
