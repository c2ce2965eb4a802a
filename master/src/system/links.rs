//! What flows between the units of a system: values by type, and links from output to input.

use std::time::Duration;

use super::structure::Value;
use crate::interface::VariableType;
use crate::interface::si::Linear;
use crate::system::unit::{Unit, UnitError};

/// Relative change of a Real that is no more than rounding.
const ROUNDING: f64 = 1e-13;

/// Variables of one type that are set or got together.
#[derive(Debug, Clone, Default)]
pub struct Bank<T> {
    /// Value references.
    references: Vec<u32>,
    /// Their values.
    pub values: Vec<T>,
}

impl<T: Copy> Bank<T> {
    /// The place of a variable, which is taken in with `value` if it is new.
    pub fn place(&mut self, reference: u32, value: T) -> usize {
        let known = self.references.iter().position(|&other| other == reference);
        known.unwrap_or_else(|| {
            self.references.push(reference);
            self.values.push(value);
            self.references.len() - 1
        })
    }

    /// Takes in a variable with a value.
    fn start(&mut self, reference: u32, value: T) {
        let at = self.place(reference, value);
        self.values[at] = value;
    }
}

/// Variables of all types that are set or got together.
#[derive(Debug, Clone, Default)]
pub struct Signals {
    /// Real variables.
    pub reals: Bank<f64>,
    /// Integer variables.
    pub integers: Bank<i32>,
    /// Boolean variables, 0 or 1.
    pub booleans: Bank<i32>,
}

impl Signals {
    /// The place of a variable in the bank of its type; Strings have none.
    pub fn place(&mut self, kind: VariableType, reference: u32) -> Option<usize> {
        match kind {
            VariableType::Real => Some(self.reals.place(reference, f64::NAN)),
            VariableType::Integer => Some(self.integers.place(reference, 0)),
            VariableType::Boolean => Some(self.booleans.place(reference, 0)),
            VariableType::Text => None,
        }
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

/// A unit of a system with what goes in and out.
pub struct Part {
    /// The unit.
    pub unit: Box<dyn Unit>,
    /// Inputs that are connected or have a start value.
    pub inputs: Signals,
    /// Outputs that are connected.
    pub outputs: Signals,
    /// Wall time of its steps so far.
    pub wall: Duration,
}

impl Part {
    /// A unit that is not connected yet.
    pub fn new(unit: Box<dyn Unit>) -> Self {
        let (inputs, outputs) = (Signals::default(), Signals::default());
        Self { unit, inputs, outputs, wall: Duration::ZERO }
    }

    /// An input as `component.variable`, for messages.
    pub fn input_name(&self, kind: VariableType, at: usize) -> String {
        let reference = match kind {
            VariableType::Real => self.inputs.reals.references[at],
            VariableType::Integer => self.inputs.integers.references[at],
            _ => self.inputs.booleans.references[at],
        };
        let variable = self.unit.interface().name_of(kind, reference).unwrap_or("?");
        format!("{}.{variable}", self.unit.name())
    }
}

/// A variable of a part: the part's number, and the variable's place in the bank of its type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Place {
    /// Number of the part.
    pub part: usize,
    /// Place in the bank.
    pub at: usize,
}

/// From an output to an input of the same type.
#[derive(Debug, Clone, Copy)]
pub struct Link {
    /// Output.
    pub from: Place,
    /// Input.
    pub to: Place,
    /// What is done to a Real on the way: conversion of units and transformation.
    pub way: Linear,
}

/// All links by type.
#[derive(Debug, Clone, Default)]
pub struct Links {
    /// Of Real variables.
    pub reals: Vec<Link>,
    /// Of Integer variables.
    pub integers: Vec<Link>,
    /// Of Boolean variables.
    pub booleans: Vec<Link>,
}

impl Links {
    /// The links of a type; Strings have none.
    pub fn of(&mut self, kind: VariableType) -> Option<&mut Vec<Link>> {
        match kind {
            VariableType::Real => Some(&mut self.reals),
            VariableType::Integer => Some(&mut self.integers),
            VariableType::Boolean => Some(&mut self.booleans),
            VariableType::Text => None,
        }
    }

    /// Hands every output to the inputs that it is linked to, and tells `changed` of each link
    /// whose input had another value before.
    pub fn transfer(&self, parts: &mut [Part], mut changed: impl FnMut(VariableType, &Link)) {
        for link in &self.reals {
            let output = parts[link.from.part].outputs.reals.values[link.from.at];
            let value = match link.way.is_identity() {
                true => output,
                false => link.way.apply(output),
            };
            let input = &mut parts[link.to.part].inputs.reals.values[link.to.at];
            let last = std::mem::replace(input, value);
            let same = last == value || (last - value).abs() <= ROUNDING * value.abs();
            if !same {
                changed(VariableType::Real, link);
            }
        }
        for link in &self.integers {
            let value = parts[link.from.part].outputs.integers.values[link.from.at];
            let input = &mut parts[link.to.part].inputs.integers.values[link.to.at];
            if std::mem::replace(input, value) != value {
                changed(VariableType::Integer, link);
            }
        }
        for link in &self.booleans {
            let value = parts[link.from.part].outputs.booleans.values[link.from.at];
            let input = &mut parts[link.to.part].inputs.booleans.values[link.to.at];
            if std::mem::replace(input, value) != value {
                changed(VariableType::Boolean, link);
            }
        }
    }
}
