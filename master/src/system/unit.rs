//! A unit: anything that a system can set, step and read. FMUs are units, and so are the
//! mocks of the tests; the loop knows nothing else of them.

use std::fmt;

use super::structure::Value;
use crate::interface::{Interface, VariableType};

/// Why a unit failed, with all that helps to find the cause.
///
/// Its sentence begins with what the unit says itself, in the words of the user, where it says anything.
#[derive(Debug, Clone, PartialEq)]
pub struct UnitError {
    /// Name of the instance, such as `vehicle[17]`.
    pub instance: Box<str>,
    /// File that it came from.
    pub source_file: Box<str>,
    /// What was tried: the FMI function, and the variable where one is concerned.
    pub action: Box<str>,
    /// The FMI status, where one was returned.
    pub status: Option<&'static str>,
    /// The last message that the unit logged.
    pub last_message: Option<Box<str>>,
}

impl std::error::Error for UnitError {}

impl fmt::Display for UnitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { instance, source_file, action, status, last_message } = self;
        let status = status.map(|status| format!(" with {status}")).unwrap_or_default();
        match last_message {
            Some(message) => {
                let message = message.trim_end();
                write!(f, "{instance}: {message} ({source_file}: {action} failed{status})")
            }
            None => write!(f, "{instance} ({source_file}): {action} failed{status}"),
        }
    }
}

/// One co-simulation unit, in the order of calls of FMI 2.0 §4.2.4: parameters are set, then
/// `enter_initialization`, inputs set and outputs got, `exit_initialization`, then steps. A unit without
/// variables of a type need not say how to set and get them.
pub trait Unit: Send {
    /// Name of the instance, such as `vehicle[17]`.
    fn name(&self) -> &str;

    /// The file that it came from.
    fn source_file(&self) -> &str;

    /// The variables of the unit.
    fn interface(&self) -> &Interface;

    /// Whether its step takes less time than it takes to hand it to another thread.
    fn is_brief(&self) -> bool {
        false
    }

    /// Whether it computes elsewhere, so that a step that was begun goes on while others step.
    fn is_separate(&self) -> bool {
        false
    }

    /// Begins the step that [`Self::step`] ends then.
    ///
    /// # Errors
    /// When the unit cannot be reached.
    fn begin_step(&mut self, _: f64, _: f64) -> Result<(), UnitError> {
        Ok(())
    }

    /// Sets a String variable.
    ///
    /// # Errors
    /// When the unit refuses.
    fn set_text(&mut self, _: u32, _: &str) -> Result<(), UnitError> {
        Err(self.lacks("Strings"))
    }

    /// Gets a String variable.
    ///
    /// # Errors
    /// When the unit refuses.
    fn get_text(&mut self, _: u32) -> Result<String, UnitError> {
        Err(self.lacks("Strings"))
    }

    /// Sets Integer variables by value reference.
    ///
    /// # Errors
    /// When the unit refuses.
    fn set_integers(&mut self, _: &[u32], _: &[i32]) -> Result<(), UnitError> {
        Err(self.lacks("Integers"))
    }

    /// Gets Integer variables by value reference into `values`.
    ///
    /// # Errors
    /// When the unit refuses.
    fn get_integers(&mut self, _: &[u32], _: &mut [i32]) -> Result<(), UnitError> {
        Err(self.lacks("Integers"))
    }

    /// Sets Boolean variables, as 0 or 1, by value reference.
    ///
    /// # Errors
    /// When the unit refuses.
    fn set_booleans(&mut self, _: &[u32], _: &[i32]) -> Result<(), UnitError> {
        Err(self.lacks("Booleans"))
    }

    /// Gets Boolean variables, as 0 or 1, by value reference into `values`.
    ///
    /// # Errors
    /// When the unit refuses.
    fn get_booleans(&mut self, _: &[u32], _: &mut [i32]) -> Result<(), UnitError> {
        Err(self.lacks("Booleans"))
    }

    /// Sets Real variables by value reference.
    ///
    /// # Errors
    /// When the unit refuses.
    fn set_reals(&mut self, references: &[u32], values: &[f64]) -> Result<(), UnitError>;

    /// Gets Real variables by value reference into `values`.
    ///
    /// # Errors
    /// When the unit refuses.
    fn get_reals(&mut self, references: &[u32], values: &mut [f64]) -> Result<(), UnitError>;

    /// Begins the initialisation of a run from `start` to `stop`, s.
    ///
    /// # Errors
    /// When the unit refuses.
    fn enter_initialization(&mut self, start: f64, stop: f64) -> Result<(), UnitError>;

    /// Ends the initialisation.
    ///
    /// # Errors
    /// When the unit cannot start from what was set.
    fn exit_initialization(&mut self) -> Result<(), UnitError>;

    /// Steps from `time` to `time + length`, s.
    ///
    /// # Errors
    /// When the unit did not get there.
    fn step(&mut self, time: f64, length: f64) -> Result<(), UnitError>;

    /// The time at which the unit wants the run to end, s, after a step that failed for that reason:
    /// that until which it came.
    fn wish_to_end(&self) -> Option<f64> {
        None
    }

    /// Whether it can be saved between two steps, and another one of its kind be set back.
    fn keeps_states(&self) -> bool {
        false
    }

    /// All that another unit of its kind needs to go on from here, bit for bit, as bytes.
    ///
    /// # Errors
    /// When the unit refuses, or cannot be saved at all.
    fn save(&mut self) -> Result<Vec<u8>, UnitError> {
        Err(self.lacks("states"))
    }

    /// Goes on, when its initialisation has ended, from what another unit of its kind has saved.
    ///
    /// # Errors
    /// When the unit refuses, or what was saved is not of its kind.
    fn restore(&mut self, _: &[u8]) -> Result<(), UnitError> {
        Err(self.lacks("states"))
    }

    /// Ends the run.
    ///
    /// # Errors
    /// When the unit could not complete what it writes.
    fn terminate(&mut self) -> Result<(), UnitError>;

    /// The error of a unit without variables of a type.
    fn lacks(&self, variables: &str) -> UnitError {
        UnitError {
            instance: self.name().into(),
            source_file: self.source_file().into(),
            action: format!("setting or getting of {variables}, of which it has none,").into(),
            status: None,
            last_message: None,
        }
    }

    /// The error of a unit that cannot go on from what was saved.
    fn differs(&self, reason: &str) -> UnitError {
        UnitError {
            instance: self.name().into(),
            source_file: self.source_file().into(),
            action: "going on from its saved state".into(),
            status: None,
            last_message: Some(reason.into()),
        }
    }

    /// Takes the warnings that the unit has logged.
    fn take_warnings(&mut self) -> Vec<String> {
        vec![]
    }
}

impl dyn Unit + '_ {
    /// Sets a variable to a value of its type.
    ///
    /// # Errors
    /// When the unit refuses.
    pub fn set_value(&mut self, reference: u32, value: &Value) -> Result<(), UnitError> {
        match value {
            Value::Real(value) => self.set_reals(&[reference], &[*value]),
            Value::Integer(value) => self.set_integers(&[reference], &[*value]),
            Value::Boolean(value) => self.set_booleans(&[reference], &[i32::from(*value)]),
            Value::Text(value) => self.set_text(reference, value),
        }
    }

    /// Gets the value of a variable of this type.
    ///
    /// # Errors
    /// When the unit refuses.
    pub fn value(&mut self, kind: VariableType, reference: u32) -> Result<Value, UnitError> {
        let (mut real, mut whole) = ([0.0], [0]);
        Ok(match kind {
            VariableType::Real => {
                self.get_reals(&[reference], &mut real)?;
                Value::Real(real[0])
            }
            VariableType::Integer => {
                self.get_integers(&[reference], &mut whole)?;
                Value::Integer(whole[0])
            }
            VariableType::Boolean => {
                self.get_booleans(&[reference], &mut whole)?;
                Value::Boolean(whole[0] != 0)
            }
            VariableType::Text => Value::Text(self.get_text(reference)?),
        })
    }

    /// Sets a Real parameter by its name.
    ///
    /// # Errors
    /// When the unit has no such variable or refuses the value.
    pub fn set_real_parameter(&mut self, name: &str, value: f64) -> Result<(), UnitError> {
        let reference = self.reference(name)?;
        self.set_reals(&[reference], &[value])
    }

    /// Value reference of a variable.
    ///
    /// # Errors
    /// When the unit has no such variable.
    pub fn reference(&self, name: &str) -> Result<u32, UnitError> {
        let variable = self.interface().variable(name);
        variable.map(|variable| variable.reference).ok_or_else(|| UnitError {
            instance: self.name().into(),
            source_file: self.source_file().into(),
            action: format!("setting '{name}', which is no variable of it,").into(),
            status: None,
            last_message: None,
        })
    }
}

/// Ends the run of units; every one is told, the first error is given.
///
/// # Errors
/// When a unit could not complete what it writes.
pub fn terminate<'u>(units: impl Iterator<Item = &'u mut Box<dyn Unit>>) -> Result<(), UnitError> {
    let ends: Vec<_> = units.map(|unit| unit.terminate()).collect();
    ends.into_iter().collect()
}
