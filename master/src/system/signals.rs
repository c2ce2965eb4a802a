//! Variables of a unit that are set or got together, by type.

use std::collections::HashMap;

use serde::{Deserialize, Serialize};

use super::structure::Value;
use super::unit::{Unit, UnitError};
use crate::interface::VariableType;
use crate::interface::range::Range;

/// Relative change of a Real that is no more than rounding.
const ROUNDING: f64 = 1e-13;

/// Variables of one type that are set or got together.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Bank<T> {
    /// Value references.
    references: Vec<u32>,
    /// Their values.
    pub values: Vec<T>,
    /// The least and the greatest value that each of them may have.
    #[serde(skip)]
    lower: Vec<T>,
    #[serde(skip)]
    upper: Vec<T>,
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

impl<T: Copy + PartialOrd + Bound> Bank<T> {
    /// Whether all values are within their bounds; NaN is not. Bounds are looked up at the first time.
    fn is_within(&mut self, kind: VariableType, ranges: &Ranges) -> bool {
        if self.lower.len() != self.references.len() {
            let range = |reference| ranges.get(&(kind, reference)).unwrap_or(&Range::FINITE);
            let bounds = self.references.iter().map(|&reference| range(reference));
            (self.lower, self.upper) = bounds.map(|r| (T::bound(r.min), T::bound(r.max))).unzip();
        }
        let bounds = self.lower.iter().zip(&self.upper);
        let pairs = self.values.iter().zip(bounds);
        // Without a branch, which takes a quarter of the time.
        pairs.fold(true, |all, (value, (lower, upper))| all & (value >= lower) & (value <= upper))
    }
}

impl<T: Copy + Into<f64>> Bank<T> {
    /// The variables whose values are not within their bounds: reference, value and bounds.
    fn outside(&self) -> impl Iterator<Item = (u32, f64, Range)> {
        let bounds = self.lower.iter().zip(&self.upper);
        let bounds = bounds.map(|(&min, &max)| Range { min: min.into(), max: max.into() });
        let values = self.values.iter().map(|&value| value.into());
        let all = self.references.iter().copied().zip(values).zip(bounds);
        all.map(|((reference, value), range)| (reference, value, range))
            .filter(|(_, value, range)| !(*value >= range.min && *value <= range.max))
    }
}

/// A number that a bound can be.
pub trait Bound {
    /// The bound, or that of the type if it has none so far away.
    fn bound(bound: f64) -> Self;
}

impl Bound for f64 {
    fn bound(bound: f64) -> Self {
        bound
    }
}

impl Bound for i32 {
    fn bound(bound: f64) -> Self {
        // The conversion ends at the least and the greatest number of the type.
        bound as Self
    }
}

/// The ranges of variables that have one, by type and value reference.
pub type Ranges = HashMap<(VariableType, u32), Range>;

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

    /// Whether a variable has been taken in.
    pub fn has(&self, kind: VariableType, reference: u32) -> bool {
        match kind {
            VariableType::Real => self.reals.known(reference).is_some(),
            VariableType::Integer => self.integers.known(reference).is_some(),
            VariableType::Boolean => self.booleans.known(reference).is_some(),
            VariableType::Text => false,
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

    /// Whether all values are finite and within their ranges.
    pub(super) fn are_within(&mut self, ranges: &Ranges) -> bool {
        self.reals.is_within(VariableType::Real, ranges)
            & self.integers.is_within(VariableType::Integer, ranges)
            & self.booleans.is_within(VariableType::Boolean, ranges)
    }

    /// The variables whose values are not: which, value, and range.
    pub(super) fn outside(&self) -> Vec<((VariableType, u32), f64, Range)> {
        let of = |kind, found: (u32, f64, Range)| ((kind, found.0), found.1, found.2);
        let reals = self.reals.outside().map(|found| of(VariableType::Real, found));
        let integers = self.integers.outside().map(|found| of(VariableType::Integer, found));
        let booleans = self.booleans.outside().map(|found| of(VariableType::Boolean, found));
        reals.chain(integers).chain(booleans).collect()
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
