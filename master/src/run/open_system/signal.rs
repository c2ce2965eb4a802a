//! Variables of a system by name: got from their units and set in them.

use std::collections::HashMap;

use files::did_you_mean;

use super::error::OpenSystemError;
use crate::interface::VariableType;
use crate::interface::range::Range;
use crate::system::step::System;
use crate::system::structure::Value;

/// The variables that were asked for, by `component.variable`.
#[derive(Default)]
pub struct Signals(HashMap<String, Signal>);

/// A variable of a part.
#[derive(Debug, Clone, Copy)]
struct Signal {
    part: usize,
    kind: VariableType,
    reference: u32,
    is_input: bool,
    range: Range,
}

impl Signals {
    /// The value of a variable: of an output after the last step, of an input for the next one.
    pub fn get(&mut self, system: &mut System, name: &str) -> Result<f64, OpenSystemError> {
        let Signal { part, kind, reference, .. } = self.find(system, name)?;
        match system.parts[part].unit.value(kind, reference)? {
            Value::Real(value) => Ok(value),
            Value::Integer(value) => Ok(f64::from(value)),
            Value::Boolean(value) => Ok(f64::from(value)),
            Value::Text(_) => {
                Err(OpenSystemError::Request(format!("{name} is a String, and no number")))
            }
        }
    }

    /// Sets an input that nothing is connected to.
    pub fn set(
        &mut self,
        system: &mut System,
        name: &str,
        value: f64,
    ) -> Result<(), OpenSystemError> {
        let signal = self.find(system, name)?;
        let part = &mut system.parts[signal.part];
        let problem = if !signal.is_input {
            Some("it is no input")
        } else if part.inputs.has(signal.kind, signal.reference) {
            Some("it is connected, and gets its value from there")
        } else if !value.is_finite() {
            Some("it must be a finite number")
        } else {
            None
        };
        let refused = |problem: &str| {
            Err(OpenSystemError::Request(format!("{name} cannot be set to {value}: {problem}")))
        };
        if let Some(problem) = problem {
            return refused(problem);
        }
        let Range { min, max } = signal.range;
        if value < min || value > max {
            return refused(&format!("it must be from {min} to {max}"));
        }
        let value = match signal.kind {
            VariableType::Real => Value::Real(value),
            VariableType::Integer if value == f64::from(value as i32) => {
                Value::Integer(value as i32)
            }
            VariableType::Boolean if value == 0.0 || value == 1.0 => Value::Boolean(value == 1.0),
            VariableType::Integer => return refused("it must be a whole number"),
            VariableType::Boolean => return refused("it must be 0 or 1"),
            VariableType::Text => return refused("it is a String"),
        };
        Ok(part.unit.set_value(signal.reference, &value)?)
    }

    fn find(&mut self, system: &System, name: &str) -> Result<Signal, OpenSystemError> {
        if let Some(signal) = self.0.get(name) {
            return Ok(*signal);
        }
        let signal = find(system, name).map_err(OpenSystemError::Request)?;
        self.0.insert(name.to_owned(), signal);
        Ok(signal)
    }
}

/// The variable of that name: the longest name of a component that it begins with is its component.
fn find(system: &System, name: &str) -> Result<Signal, String> {
    let splits = name.rmatch_indices('.').map(|(dot, _)| (&name[..dot], &name[dot + 1..]));
    let mut found = splits.filter_map(|(component, variable)| {
        system.number(component).map(|number| (component, number, variable))
    });
    let Some((component, part, variable)) = found.next() else {
        let names: Vec<_> = system.units().map(|unit| unit.name()).collect();
        let component = name.split_once('.').map_or(name, |(component, _)| component);
        return Err(no_component(component, &names));
    };
    let interface = system.parts[part].unit.interface();
    let Some(own) = interface.variable(variable) else {
        let known = interface.variables();
        let meant = did_you_mean(variable, known.iter().map(|known| known.name.as_str()));
        return Err(format!("{component} has no variable `{variable}`{meant}"));
    };
    Ok(Signal {
        part,
        kind: own.kind,
        reference: own.reference,
        is_input: own.causality == "input",
        range: own.range,
    })
}

/// Says that there is no component of that name, and which there are.
pub fn no_component(name: &str, names: &[&str]) -> String {
    let meant = did_you_mean(name, names.iter().copied());
    format!("there is no component `{name}`{meant}; there are {}", names.join(", "))
}
