//! Variables of a unit that are set or got together, by type.

use serde::{Deserialize, Serialize};

use super::structure::Value;
use super::unit::{Unit, UnitError};
use crate::interface::VariableType;

/// Relative change of a Real that is no more than rounding.
const ROUNDING: f64 = 1e-13;

/// Variables of one type that are set or got together.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Bank<T> {
    /// Value references.
    references: Vec<u32>,
    /// Their values.
    pub values: Vec<T>,
}

impl<T: Copy> Bank<T> {
    /// The index of a variable, which is taken in with `value` if it is new.
    pub fn index(&mut self, reference: u32, value: T) -> usize {
        self.known(reference).unwrap_or_else(|| {
            self.references.push(reference);
            self.values.push(value);
            self.references.len() - 1
        })
    }

    /// The index of a variable that has been taken in.
    pub fn known(&self, reference: u32) -> Option<usize> {
        self.references.iter().position(|&other| other == reference)
    }

    /// Takes in a variable with a value.
    fn start(&mut self, reference: u32, value: T) {
        let index = self.index(reference, value);
        self.values[index] = value;
    }
}

/// Variables of all types that are set or got together.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Signals {
    /// Real variables.
    pub reals: Bank<f64>,
    /// Integer variables.
    pub integers: Bank<i32>,
    /// Boolean variables, 0 or 1.
    pub booleans: Bank<i32>,
}

impl Signals {
    /// The index of a variable in the bank of its type; Strings have none.
    pub fn index(&mut self, kind: VariableType, reference: u32) -> Option<usize> {
        match kind {
            VariableType::Real => Some(self.reals.index(reference, f64::NAN)),
            VariableType::Integer => Some(self.integers.index(reference, 0)),
            VariableType::Boolean => Some(self.booleans.index(reference, 0)),
            VariableType::Text => None,
        }
    }

    /// The value at an index as a number.
    pub fn number(&self, kind: VariableType, index: usize) -> f64 {
        match kind {
            VariableType::Real => self.reals.values[index],
            VariableType::Integer => f64::from(self.integers.values[index]),
            _ => f64::from(self.booleans.values[index]),
        }
    }

    /// The value reference of the variable at an index.
    pub(super) fn reference(&self, kind: VariableType, index: usize) -> u32 {
        match kind {
            VariableType::Real => self.reals.references[index],
            VariableType::Integer => self.integers.references[index],
            _ => self.booleans.references[index],
        }
    }

    /// The variables that have other values than in `before`, but for rounding.
    pub(super) fn changed_since(&self, before: &Self) -> Vec<(VariableType, usize)> {
        let same = |a: f64, b: f64| a == b || (a - b).abs() <= ROUNDING * b.abs();
        let reals = differing(&before.reals, &self.reals, same);
        let integers = differing(&before.integers, &self.integers, |a, b| a == b);
        let booleans = differing(&before.booleans, &self.booleans, |a, b| a == b);
        let of = |kind, indices: Vec<usize>| indices.into_iter().map(move |index| (kind, index));
        of(VariableType::Real, reals)
            .chain(of(VariableType::Integer, integers))
            .chain(of(VariableType::Boolean, booleans))
            .collect()
    }

    /// Takes in a variable with a value; false for Strings.
    pub fn start(&mut self, reference: u32, value: &Value) -> bool {
        match *value {
            Value::Real(value) => self.reals.start(reference, value),
            Value::Integer(value) => self.integers.start(reference, value),
            Value::Boolean(value) => self.booleans.start(reference, value.into()),
            Value::Text(_) => return false,
        }
        true
    }

    /// Whether they are the same variables.
    pub(super) fn has_variables_of(&self, other: &Self) -> bool {
        self.reals.references == other.reals.references
            && self.integers.references == other.integers.references
            && self.booleans.references == other.booleans.references
    }

    /// Sends the values to the unit.
    ///
    /// # Errors
    /// When the unit refuses.
    pub fn set(&self, unit: &mut dyn Unit) -> Result<(), UnitError> {
        if !self.reals.values.is_empty() {
            unit.set_reals(&self.reals.references, &self.reals.values)?;
        }
        if !self.integers.values.is_empty() {
            unit.set_integers(&self.integers.references, &self.integers.values)?;
        }
        if !self.booleans.values.is_empty() {
            unit.set_booleans(&self.booleans.references, &self.booleans.values)?;
        }
        Ok(())
    }

    /// Takes the values from the unit.
    ///
    /// # Errors
    /// When the unit refuses.
    pub fn get(&mut self, unit: &mut dyn Unit) -> Result<(), UnitError> {
        if !self.reals.values.is_empty() {
            unit.get_reals(&self.reals.references, &mut self.reals.values)?;
        }
        if !self.integers.values.is_empty() {
            unit.get_integers(&self.integers.references, &mut self.integers.values)?;
        }
        if !self.booleans.values.is_empty() {
            unit.get_booleans(&self.booleans.references, &mut self.booleans.values)?;
        }
        Ok(())
    }
}

/// The indices at which two banks of the same variables differ.
fn differing<T: Copy>(before: &Bank<T>, now: &Bank<T>, same: impl Fn(T, T) -> bool) -> Vec<usize> {
    let pairs = before.values.iter().zip(&now.values).enumerate();
    pairs.filter(|(_, (before, now))| !same(**before, **now)).map(|(index, _)| index).collect()
}
