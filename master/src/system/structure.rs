//! What a system structure says: components, their connections and start values, without
//! hierarchy. It knows neither XML nor FMUs.

use std::collections::{HashMap, HashSet};

use crate::interface::VariableType;
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
    /// The outputs that a package connects to something, a system's own connectors too.
    pub given: HashSet<Endpoint>,
    /// Proposed start, s.
    pub start: Option<f64>,
    /// Proposed end, s.
    pub stop: Option<f64>,
    /// Proposed step of the exchange, s.
    pub step: Option<f64>,
    /// What the stages are called, in their order; those without a name have numbers.
    pub stages: Vec<String>,
    /// Relative tolerance that the FMUs are told instead of their own; none: their own.
    pub tolerance: Option<f64>,
    /// What the user should know of the file that it comes from, in sentences.
    pub notes: Vec<String>,
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
    /// When it steps.
    pub schedule: Schedule,
}

/// When a component steps, and where.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Schedule {
    /// In a step of the exchange the stages follow one another, from 0: a component takes what those
    /// of earlier stages have given in the same step.
    pub stage: usize,
    /// It steps at every so many communication points.
    pub every: u64,
    /// Where its FMU is called.
    pub home: Home,
}

/// Where an FMU is made, called and freed; what comes later keeps it further from the others.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Home {
    /// On any thread of the run.
    #[default]
    AnyThread,
    /// On a thread of its own.
    OwnThread,
    /// In a process of its own.
    OwnProcess,
}

impl Default for Schedule {
    /// With all others, at every communication point.
    fn default() -> Self {
        Self { stage: 0, every: 1, home: Home::AnyThread }
    }
}

/// What a component that steps less often than the exchange gets of an input.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Sampling {
    /// The mean since its last step.
    #[default]
    Mean,
    /// The sum since its last step.
    Sum,
    /// The last value.
    Last,
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
    /// What a slower receiver gets.
    pub sampling: Sampling,
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
    /// Whether it holds on this machine only, such as the path of a file of the results.
    pub local: bool,
    /// What is done to the value behind the conversion of units.
    pub transformation: Linear,
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

impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Real(value) => value.fmt(f),
            Self::Integer(value) => value.fmt(f),
            Self::Boolean(value) => value.fmt(f),
            Self::Text(value) => value.fmt(f),
        }
    }
}

impl Value {
    /// The value of a type that a text states; none where it is no value of it.
    pub fn parse(text: &str, kind: VariableType) -> Option<Self> {
        Some(match (kind, text.trim()) {
            (VariableType::Real, text) => Self::Real(text.parse().ok()?),
            (VariableType::Integer, text) => Self::Integer(text.parse().ok()?),
            (VariableType::Boolean, "true" | "1") => Self::Boolean(true),
            (VariableType::Boolean, "false" | "0") => Self::Boolean(false),
            (VariableType::Boolean, _) => return None,
            (VariableType::Text, _) => Self::Text(text.to_owned()),
        })
    }

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
    /// A connection that is converted as `conversion` says and not otherwise.
    pub fn of(from: Endpoint, to: Endpoint, conversion: Linear, sampling: Sampling) -> Self {
        let convert_units = conversion.is_identity();
        Self { from, to, transformation: conversion, convert_units, sampling }
    }
}

impl Parameter {
    /// A parameter without a unit.
    pub fn new(name: &str, value: Value) -> Self {
        Self {
            name: name.to_owned(),
            value,
            unit: None,
            si: None,
            local: false,
            transformation: Linear::IDENTITY,
        }
    }
}

impl std::fmt::Display for Endpoint {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}.{}", self.element, self.connector)
    }
}

impl Endpoint {
    /// A connector of a component.
    pub fn new(element: &str, connector: &str) -> Self {
        Self { element: element.to_owned(), connector: connector.to_owned() }
    }
}
