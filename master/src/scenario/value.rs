//! A value for a variable of an FMU, of whichever type.

use std::fmt;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a scenario sets a variable to.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Value {
    /// For a Boolean.
    Boolean(bool),
    /// For an Integer, or a Real.
    Integer(i32),
    /// For a Real.
    Real(f64),
    /// For a String.
    Text(String),
    /// For a String that is the path of a file: a text that was found to be one.
    #[serde(skip)]
    File(PathBuf),
}

/// A name of a variable as a key: in quotes if it holds a dot or a bracket.
pub fn quoted(name: &str) -> String {
    match name.contains(['.', '[']) {
        true => format!("\"{name}\""),
        false => name.to_owned(),
    }
}

impl Value {
    /// The number that it is, if it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Integer(value) => Some(f64::from(*value)),
            Self::Real(value) => Some(*value),
            Self::Boolean(_) | Self::Text(_) | Self::File(_) => None,
        }
    }
}

impl fmt::Display for Value {
    /// As it stands in the scenario's file.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Boolean(value) => write!(f, "{value}"),
            Self::Integer(value) => write!(f, "{value}"),
            Self::Real(value) => write!(f, "{value}"),
            Self::Text(value) => write!(f, "\"{value}\""),
            Self::File(path) => write!(f, "\"{}\"", path.display()),
        }
    }
}
