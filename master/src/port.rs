//! A port: a group of Real variables of a unit that are set or got together, in the fixed order
//! of the exchange.

use std::collections::BTreeMap;

use crate::interface::{Interface, VariableType};
use crate::unit::{Unit, UnitError};

/// A variable that a role wants.
#[derive(Debug, Clone, PartialEq)]
pub struct Signal {
    /// Hotfoot's name.
    pub name: String,
    /// Whether the role cannot do without.
    pub required: bool,
}

impl Signal {
    /// A signal that must be there.
    pub fn required(name: impl Into<String>) -> Self {
        Self { name: name.into(), required: true }
    }

    /// A signal that is zero (as an output) or dropped (as an input) where it is missing.
    pub fn optional(name: impl Into<String>) -> Self {
        Self { name: name.into(), required: false }
    }
}

/// Variables in the order of the exchange, with their present values.
///
/// Optional variables that the unit lacks keep the value zero.
#[derive(Debug, Clone, Default)]
pub struct Port {
    /// Values in the order of the signals.
    pub values: Vec<f64>,
    /// Value references of the signals that the unit has.
    references: Vec<u32>,
    /// Place of each of them in `values`.
    places: Vec<usize>,
    /// Their values in the order of `references`.
    buffer: Vec<f64>,
}

impl Port {
    /// Finds the signals in a unit's interface; `names` maps our names to the unit's.
    ///
    /// # Errors
    /// One sentence for each required signal that is missing or not Real.
    pub fn connect(
        interface: &Interface,
        signals: &[Signal],
        causality: &str,
        names: &BTreeMap<String, String>,
    ) -> Result<Self, Vec<String>> {
        let mut port = Self { values: vec![0.0; signals.len()], ..Self::default() };
        let mut problems = vec![];
        for (place, signal) in signals.iter().enumerate() {
            let name = names.get(&signal.name).unwrap_or(&signal.name);
            match interface.variable(name) {
                Some(v) if v.kind == VariableType::Real && v.causality == causality => {
                    port.references.push(v.reference);
                    port.places.push(place);
                }
                Some(v) => problems.push(format!(
                    "variable '{name}' is {} {:?}, but must be a Real {causality}",
                    v.causality, v.kind
                )),
                None if signal.required => {
                    problems.push(format!("the Real {causality} '{name}' is missing"));
                }
                None => {}
            }
        }
        port.buffer = vec![0.0; port.references.len()];
        if problems.is_empty() { Ok(port) } else { Err(problems) }
    }

    /// Sends the values to the unit.
    ///
    /// # Errors
    /// When the unit refuses.
    pub fn set(&mut self, unit: &mut dyn Unit) -> Result<(), UnitError> {
        for (value, &place) in self.buffer.iter_mut().zip(&self.places) {
            *value = self.values[place];
        }
        unit.set_reals(&self.references, &self.buffer)
    }

    /// Takes the values from the unit.
    ///
    /// # Errors
    /// When the unit refuses.
    pub fn get(&mut self, unit: &mut dyn Unit) -> Result<(), UnitError> {
        unit.get_reals(&self.references, &mut self.buffer)?;
        for (value, &place) in self.buffer.iter().zip(&self.places) {
            self.values[place] = *value;
        }
        Ok(())
    }
}
