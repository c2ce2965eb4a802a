//! Signals by name, as those who observe a run ask for them.

use super::step::System;
use crate::interface::VariableType;
use crate::interface::si::Linear;

/// A Real variable of a part that somebody observes.
#[derive(Debug, Clone, Copy)]
pub struct Tap {
    part: usize,
    index: usize,
    is_input: bool,
    conversion: Linear,
}

impl Tap {
    /// The same signal with its values converted.
    #[must_use]
    pub fn converted(self, conversion: Linear) -> Self {
        Self { conversion, ..self }
    }
}

impl System {
    /// A Real output of a component, or a connected Real input; none where there is no such variable.
    /// Outputs that are not connected are got from now on after each step.
    pub fn tap(&mut self, component: &str, variable: &str) -> Option<Tap> {
        let part = self.number(component)?;
        let of_system = &mut self.parts[part];
        let variable = of_system.unit.interface().variable(variable)?;
        if variable.kind != VariableType::Real {
            return None;
        }
        let (reference, is_input) = (variable.reference, variable.causality == "input");
        let index = match is_input {
            true => of_system.inputs.reals.known(reference)?,
            false => of_system.outputs.reals.index(reference, f64::NAN),
        };
        Some(Tap { part, index, is_input, conversion: Linear::IDENTITY })
    }

    /// The value of a signal: of an output after the last step, of an input in it.
    pub fn value(&self, tap: &Tap) -> f64 {
        let part = &self.parts[tap.part];
        let signals = if tap.is_input { &part.inputs } else { &part.outputs };
        let value = signals.reals.values[tap.index];
        match tap.conversion.is_identity() {
            true => value,
            false => tap.conversion.apply(value),
        }
    }
}
