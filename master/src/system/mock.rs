//! A unit for tests: its step is a closure over its variables, and its calls are written down.

use std::sync::{Arc, Mutex};

use crate::interface::range::Range;
use crate::interface::{Interface, Variable, VariableType};
use crate::system::unit::{Unit, UnitError};

/// What a mock does in a step: its variables, the time and the length of the step.
type Step = Box<dyn FnMut(&mut [f64], f64, f64) + Send>;

/// A unit with Real variables only.
pub struct Mock {
    interface: Interface,
    values: Vec<f64>,
    step: Step,
    /// Whether its outputs follow its inputs before it steps.
    feeds_through: bool,
    /// Whether they do when the initialisation ends.
    computes_at_exit: bool,
    calls: Arc<Mutex<Vec<String>>>,
    name: String,
}

impl Mock {
    /// A mock with variables given as (name, causality); a variable's reference is its index.
    pub fn new(
        name: &str,
        variables: &[(String, &str)],
        calls: &Arc<Mutex<Vec<String>>>,
        step: impl FnMut(&mut [f64], f64, f64) + Send + 'static,
    ) -> Self {
        let variable = |(i, (name, causality)): (usize, &(String, &str))| Variable {
            name: name.clone(),
            reference: i as u32,
            kind: VariableType::Real,
            causality: (*causality).to_owned(),
            discrete: false,
            unit: None,
            si: None,
            range: Range::FINITE,
            start: None,
            description: String::new(),
        };
        Self {
            interface: Interface::of(variables.iter().enumerate().map(variable)),
            values: vec![0.0; variables.len()],
            step: Box::new(step),
            feeds_through: false,
            computes_at_exit: false,
            calls: Arc::clone(calls),
            name: name.to_owned(),
        }
    }

    /// The mock with outputs that follow its inputs before it steps, by a step of no length.
    pub fn feeding_through(self) -> Self {
        Self { feeds_through: true, ..self }
    }

    /// The mock with outputs that follow its inputs when the initialisation ends.
    pub fn computing_at_exit(self) -> Self {
        Self { computes_at_exit: true, ..self }
    }

    fn note(&self, call: &str) {
        self.calls.lock().unwrap().push(format!("{} {call}", self.name));
    }
}

impl Unit for Mock {
    fn name(&self) -> &str {
        &self.name
    }

    fn source_file(&self) -> &str {
        "a mock"
    }

    fn interface(&self) -> &Interface {
        &self.interface
    }

    fn set_reals(&mut self, references: &[u32], values: &[f64]) -> Result<(), UnitError> {
        self.note("set");
        for (&reference, &value) in references.iter().zip(values) {
            self.values[reference as usize] = value;
        }
        if self.feeds_through {
            (self.step)(&mut self.values, 0.0, 0.0);
        }
        Ok(())
    }

    fn get_reals(&mut self, references: &[u32], values: &mut [f64]) -> Result<(), UnitError> {
        self.note("get");
        for (&reference, value) in references.iter().zip(values) {
            *value = self.values[reference as usize];
        }
        Ok(())
    }

    fn enter_initialization(&mut self, _: f64, _: f64) -> Result<(), UnitError> {
        self.note("enter");
        Ok(())
    }

    fn exit_initialization(&mut self) -> Result<(), UnitError> {
        self.note("exit");
        if self.computes_at_exit {
            (self.step)(&mut self.values, 0.0, 0.0);
        }
        Ok(())
    }

    fn step(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        self.note(&format!("step {time:.3}"));
        (self.step)(&mut self.values, time, length);
        Ok(())
    }

    fn terminate(&mut self) -> Result<(), UnitError> {
        self.note("terminate");
        Ok(())
    }
}
