//! What a system structure says: components, their connections and start values, without
//! hierarchy. It knows neither XML nor FMUs.

use std::collections::HashMap;

use crate::interface::si::{Linear, SiUnit};

/// A system of FMUs.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Structure {
    /// Name of the system.
    pub name: String,
    /// Its FMUs.
    pub components: Vec<Component>,
    /// What flows between them.
    pub connections: Vec<Connection>,
    /// Units of measurement that connectors and parameters refer to.
    pub units: HashMap<String, SiUnit>,
    /// Proposed start, s.
    pub start: Option<f64>,
    /// Proposed end, s.
    pub stop: Option<f64>,
    /// Proposed step of the exchange, s.
    pub step: Option<f64>,
}

/// An instance of an FMU.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Component {
    /// Name; that of a component in a nested system begins with the system's.
    pub name: String,
    /// Path of the FMU in the package.
    pub source: String,
    /// Variables that are connected or could be.
    pub connectors: Vec<Connector>,
    /// Start values.
    pub parameters: Vec<Parameter>,
}

/// A variable of a component.
#[derive(Debug, Clone, PartialEq)]
pub struct Connector {
    /// Name of the variable.
    pub name: String,
    /// Its causality.
    pub kind: ConnectorKind,
    /// Unit, where one is stated.
    pub unit: Option<String>,
}

/// Causality of a connector.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ConnectorKind {
    /// Takes values.
    Input,
    /// Gives values.
    Output,
    /// Set at the start.
    Parameter,
    /// Computed at the start.
    CalculatedParameter,
}

/// A connector of a component.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Endpoint {
    /// Name of the component.
    pub element: String,
    /// Name of the connector.
    pub connector: String,
}

/// A value that flows from an output to an input.
#[derive(Debug, Clone, PartialEq)]
pub struct Connection {
    /// Output.
    pub from: Endpoint,
    /// Input.
    pub to: Endpoint,
    /// What is done to the value behind the conversion of units.
    pub transformation: Linear,
    /// Whether units are converted.
    pub convert_units: bool,
}

/// A start value.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// Name of the variable.
    pub name: String,
    /// Value.
    pub value: Value,
    /// Unit of the value, where one is stated.
    pub unit: Option<String>,
    /// What that is in SI base units, where the parameter's own file says so.
    pub si: Option<SiUnit>,
}

/// A value of any type.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// Real.
    Real(f64),
    /// Integer or Enumeration.
    Integer(i32),
    /// Boolean.
    Boolean(bool),
    /// String.
    Text(String),
}

impl Value {
    /// Name of the type.
    pub fn type_name(&self) -> &'static str {
        match self {
            Self::Real(_) => "Real",
            Self::Integer(_) => "Integer",
            Self::Boolean(_) => "Boolean",
            Self::Text(_) => "String",
        }
    }
}

impl Structure {
    /// The component of that name.
    pub fn component(&self, name: &str) -> Option<&Component> {
        self.components.iter().find(|component| component.name == name)
    }
}

impl Component {
    /// The connector of that name.
    pub fn connector(&self, name: &str) -> Option<&Connector> {
        self.connectors.iter().find(|connector| connector.name == name)
    }
}

impl Connection {
    /// A connection that is converted as `way` says and not otherwise.
    pub fn of(from: Endpoint, to: Endpoint, way: Linear) -> Self {
        Self { from, to, transformation: way, convert_units: way.is_identity() }
    }
}

impl Parameter {
    /// A parameter without a unit.
    pub fn new(name: &str, value: Value) -> Self {
        Self { name: name.to_owned(), value, unit: None, si: None }
    }
}

impl Structure {
    /// Adds a connection and the connectors at its ends.
    pub fn connect(&mut self, connection: Connection) {
        let ends =
            [(&connection.from, ConnectorKind::Output), (&connection.to, ConnectorKind::Input)];
        for (end, kind) in ends {
            let component = self.components.iter_mut().find(|c| c.name == end.element);
            let Some(component) = component else { continue };
            if component.connector(&end.connector).is_none() {
                let name = end.connector.clone();
                component.connectors.push(Connector { name, kind, unit: None });
            }
        }
        self.connections.push(connection);
    }
}
