//! Start values that are bound at systems.
//!
//! They reach the component that their name begins with, or what the system's connector of their name
//! is connected to (SSP 1.0.1: connectors of all kinds).

use std::collections::HashMap;

use super::connect::Edge;
use crate::interface::si::Linear;
use crate::system::structure::{Connector, ConnectorKind, Endpoint, Parameter, Structure, Value};

/// A start value that is bound at a system.
pub struct Bound {
    /// Full name of the system, empty for the outermost.
    pub system: String,
    /// The value, under its name in the system.
    pub parameter: Parameter,
}

/// Hands start values of systems to the components of a structure, in their order; gives a sentence for
/// each that reaches none. `ports` are the connectors of all systems.
pub fn hand_on(
    bound: Vec<Bound>,
    edges: &[Edge],
    ports: &HashMap<Endpoint, Connector>,
    structure: &mut Structure,
) -> Vec<String> {
    let mut notes = vec![];
    for Bound { system, parameter } in bound {
        let home = home(&system, &parameter.name, ports, structure);
        let mut reached = vec![];
        match home {
            Some(end) if ports.contains_key(&end) => {
                Flow { edges, ports, structure, reached: &mut reached }
                    .from(&end, parameter.clone());
            }
            Some(end) => reached.push((end, parameter.clone())),
            None => {}
        }
        if reached.is_empty() {
            let of = if system.is_empty() { &structure.name } else { &system };
            notes.push(format!(
                "'{}' has a start value at the system '{of}', but there is no such component or \
                 connector that leads to one; it is ignored",
                parameter.name
            ));
        }
        for (end, mut parameter) in reached {
            parameter.name = end.connector;
            let mut components = structure.components.iter_mut();
            if let Some(component) = components.find(|component| component.name == end.element) {
                component.parameters.push(parameter);
            }
        }
    }
    notes
}

/// The connector of a system, or the variable of a component, that a name in a system means.
fn home(
    system: &str,
    name: &str,
    ports: &HashMap<Endpoint, Connector>,
    structure: &Structure,
) -> Option<Endpoint> {
    let own = Endpoint::new(system, name);
    if ports.contains_key(&own) {
        return Some(own);
    }
    let prefix = if system.is_empty() { String::new() } else { format!("{system}.") };
    // Names may contain dots: the longest that is an element counts.
    name.rmatch_indices('.').find_map(|(dot, _)| {
        let end = Endpoint::new(&format!("{prefix}{}", &name[..dot]), &name[dot + 1..]);
        (ports.contains_key(&end) || structure.component(&end.element).is_some()).then_some(end)
    })
}

/// The way of a start value along connections, through the connectors of systems in between.
struct Flow<'f> {
    edges: &'f [Edge],
    ports: &'f HashMap<Endpoint, Connector>,
    structure: &'f Structure,
    reached: &'f mut Vec<(Endpoint, Parameter)>,
}

impl Flow<'_> {
    /// From a connector of a system: an output starts the component that gives it, or else, as inputs
    /// and parameters do, whatever takes it.
    fn from(&mut self, port: &Endpoint, mut parameter: Parameter) {
        let connector = &self.ports[port];
        if parameter.unit.is_none() {
            parameter.unit.clone_from(&connector.unit);
        }
        if matches!(connector.kind, ConnectorKind::Output | ConnectorKind::CalculatedParameter) {
            self.back(port, parameter.clone(), self.edges.len());
        }
        if self.reached.is_empty() {
            self.on(port, &parameter, self.edges.len());
        }
    }

    /// To whatever takes the connector's value, over at most so many connections.
    fn on(&mut self, port: &Endpoint, parameter: &Parameter, most: usize) {
        let edges = self.edges;
        for edge in edges.iter().filter(|edge| edge.from == *port && most > 0) {
            let mut parameter = parameter.clone();
            parameter.transformation = parameter.transformation.then(edge.transformation);
            if !edge.convert_units {
                parameter.unit = None;
            }
            match self.structure.component(&edge.to.element) {
                Some(_) => self.reached.push((edge.to.clone(), parameter)),
                None => self.on(&edge.to, &parameter, most - 1),
            }
        }
    }

    /// To what gives the connector its value, over at most so many connections.
    fn back(&mut self, port: &Endpoint, mut parameter: Parameter, most: usize) {
        let edges = self.edges;
        let Some(edge) = edges.iter().find(|edge| edge.to == *port && most > 0) else { return };
        if let Value::Real(value) = &mut parameter.value {
            if edge.transformation.factor == 0.0 {
                return;
            }
            *value = edge.transformation.inverse().apply(*value);
        } else if edge.transformation != Linear::IDENTITY {
            return;
        }
        match self.structure.component(&edge.from.element) {
            Some(_) => self.reached.push((edge.from.clone(), parameter)),
            None => self.back(&edge.from, parameter, most - 1),
        }
    }
}
