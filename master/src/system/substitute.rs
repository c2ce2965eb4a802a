//! What the caller's own program does in place of a component's unit.

use std::collections::{BTreeMap, HashMap};

use serde::{Deserialize, Serialize};

use super::unit::{Unit, UnitError};
use crate::interface::{Interface, Variable, VariableType};

/// A model of the caller's in place of a component's.
///
/// It has the variables of the unit that it stands for: numbers, in their units; a Boolean is 0 or 1.
pub trait Substitute: Send {
    /// Begins at `time`, s, with these parameters, and sets the outputs that it knows.
    ///
    /// # Errors
    /// When it cannot begin, in a sentence.
    fn start(&mut self, time: f64, of: &Variables<'_>, outputs: &mut [f64]) -> Result<(), String>;

    /// Steps from `time` over `length`, s, and sets the outputs as they are then.
    ///
    /// # Errors
    /// When it did not get there, in a sentence.
    fn step(&mut self, of: (f64, f64), inputs: &[f64], outputs: &mut [f64]) -> Result<(), String>;

    /// All that changes of it while it runs, as bytes.
    ///
    /// # Errors
    /// When it cannot be saved.
    fn save(&mut self) -> Result<Vec<u8>, String>;

    /// Goes on from what it has saved.
    ///
    /// # Errors
    /// When that was saved by something else.
    fn restore(&mut self, saved: &[u8]) -> Result<(), String>;
}

/// Names of the variables of a unit in the order of their values, and its parameters.
pub struct Variables<'v> {
    /// Names of the inputs.
    pub inputs: &'v [String],
    /// Names of the outputs.
    pub outputs: &'v [String],
    /// Names and values of the parameters that are numbers.
    pub parameters: Vec<(&'v str, f64)>,
}

/// Substitutes by the names of the components that they stand for.
pub type Substitutes = BTreeMap<String, Box<dyn Substitute>>;

/// Puts the substitutes in the places of the units for which they stand, and takes them out of the map.
pub fn replace(units: &mut [Box<dyn Unit>], substitutes: &mut Substitutes) {
    for unit in units {
        if let Some(program) = substitutes.remove(unit.name()) {
            *unit = Box::new(SubstituteUnit::new(unit.as_ref(), program));
        }
    }
}

/// A substitute as a unit of the system.
struct SubstituteUnit {
    name: String,
    source_file: String,
    interface: Interface,
    program: Box<dyn Substitute>,
    /// Names of the inputs, of the outputs, and of the rest, as `values` has them.
    names: [Vec<String>; 3],
    values: Vec<f64>,
    /// Where the value of each variable stands.
    indices: HashMap<(VariableType, u32), usize>,
}

/// The state of a substitute and its values.
#[derive(Serialize, Deserialize)]
struct State {
    #[serde(with = "serde_bytes")]
    program: Vec<u8>,
    values: Vec<f64>,
}

impl SubstituteUnit {
    /// A substitute for `unit`, whose parameters are not set yet.
    fn new(unit: &dyn Unit, program: Box<dyn Substitute>) -> Self {
        let interface = unit.interface();
        let mut numbers = interface.variables();
        numbers.retain(|variable| variable.kind != VariableType::Text);
        let group = |wanted: &str| match wanted {
            "input" => 0,
            "output" => 1,
            _ => 2,
        };
        numbers.sort_by_key(|variable| group(&variable.causality));
        let mut names = [vec![], vec![], vec![]];
        for variable in &numbers {
            names[group(&variable.causality)].push(variable.name.clone());
        }
        let indices = numbers.iter().zip(0..).map(|(v, index)| ((v.kind, v.reference), index));
        Self {
            name: unit.name().to_owned(),
            source_file: format!("in place of {}", unit.source_file()),
            indices: indices.collect(),
            values: numbers.iter().map(|variable| start_value(variable)).collect(),
            interface: interface.clone(),
            program,
            names,
        }
    }

    fn failed(&self, action: &str, reason: String) -> UnitError {
        UnitError {
            instance: self.name.as_str().into(),
            source_file: self.source_file.as_str().into(),
            action: action.into(),
            status: None,
            last_message: Some(reason.into()),
        }
    }

    fn set(&mut self, kind: VariableType, references: &[u32], values: impl Iterator<Item = f64>) {
        for (reference, value) in references.iter().zip(values) {
            if let Some(&index) = self.indices.get(&(kind, *reference)) {
                self.values[index] = value;
            }
        }
    }

    fn get(&self, kind: VariableType, references: &[u32]) -> impl Iterator<Item = f64> {
        references.iter().map(move |reference| {
            self.indices.get(&(kind, *reference)).map_or(f64::NAN, |index| self.values[*index])
        })
    }

    fn set_whole(&mut self, kind: VariableType, references: &[u32], values: &[i32]) {
        self.set(kind, references, values.iter().copied().map(f64::from));
    }

    fn get_whole(&self, kind: VariableType, references: &[u32], values: &mut [i32]) {
        let numbers = self.get(kind, references);
        values.iter_mut().zip(numbers).for_each(|(value, number)| *value = number as i32);
    }
}

/// What a variable is before anybody sets it.
fn start_value(variable: &Variable) -> f64 {
    match variable.start.as_deref().map(str::trim) {
        Some("true") => 1.0,
        Some(text) => text.parse().unwrap_or(0.0),
        None => 0.0,
    }
}

impl Unit for SubstituteUnit {
    fn name(&self) -> &str {
        &self.name
    }

    fn source_file(&self) -> &str {
        &self.source_file
    }

    fn interface(&self) -> &Interface {
        &self.interface
    }

    /// It is called on the thread of the loop, which its program may be bound to.
    fn is_brief(&self) -> bool {
        true
    }

    fn set_text(&mut self, _: u32, _: &str) -> Result<(), UnitError> {
        Ok(())
    }

    fn set_reals(&mut self, references: &[u32], values: &[f64]) -> Result<(), UnitError> {
        self.set(VariableType::Real, references, values.iter().copied());
        Ok(())
    }

    fn get_reals(&mut self, references: &[u32], values: &mut [f64]) -> Result<(), UnitError> {
        let numbers = self.get(VariableType::Real, references);
        values.iter_mut().zip(numbers).for_each(|(value, number)| *value = number);
        Ok(())
    }

    fn set_integers(&mut self, references: &[u32], values: &[i32]) -> Result<(), UnitError> {
        self.set_whole(VariableType::Integer, references, values);
        Ok(())
    }

    fn get_integers(&mut self, references: &[u32], values: &mut [i32]) -> Result<(), UnitError> {
        self.get_whole(VariableType::Integer, references, values);
        Ok(())
    }

    fn set_booleans(&mut self, references: &[u32], values: &[i32]) -> Result<(), UnitError> {
        self.set_whole(VariableType::Boolean, references, values);
        Ok(())
    }

    fn get_booleans(&mut self, references: &[u32], values: &mut [i32]) -> Result<(), UnitError> {
        self.get_whole(VariableType::Boolean, references, values);
        Ok(())
    }

    fn enter_initialization(&mut self, start: f64, _: f64) -> Result<(), UnitError> {
        let Self { names: [inputs, outputs, rest], program, interface, values, .. } = self;
        let (given, values) = values[inputs.len()..].split_at_mut(outputs.len());
        let is_parameter = |name: &str| {
            interface.variable(name).is_some_and(|variable| variable.causality == "parameter")
        };
        let parameters = rest.iter().map(String::as_str).zip(values.iter().copied());
        let parameters = parameters.filter(|(name, _)| is_parameter(name)).collect();
        let started = program.start(start, &Variables { inputs, outputs, parameters }, given);
        started.map_err(|reason| self.failed("its start", reason))
    }

    fn exit_initialization(&mut self) -> Result<(), UnitError> {
        Ok(())
    }

    fn step(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        let Self { names: [inputs, outputs, _], program, values, .. } = self;
        let (given, values) = values.split_at_mut(inputs.len());
        let stepped = program.step((time, length), given, &mut values[..outputs.len()]);
        stepped.map_err(|reason| self.failed("its step", reason))
    }

    fn keeps_states(&self) -> bool {
        true
    }

    fn save(&mut self) -> Result<Vec<u8>, UnitError> {
        let program = self.program.save().map_err(|reason| self.failed("saving", reason))?;
        let state = State { program, values: self.values.clone() };
        postcard::to_allocvec(&state).map_err(|error| self.failed("saving", error.to_string()))
    }

    fn restore(&mut self, saved: &[u8]) -> Result<(), UnitError> {
        let state: State =
            postcard::from_bytes(saved).map_err(|error| self.differs(&error.to_string()))?;
        if state.values.len() != self.values.len() {
            return Err(self.differs("it is one with other variables"));
        }
        self.program.restore(&state.program).map_err(|reason| self.differs(&reason))?;
        self.values = state.values;
        Ok(())
    }

    fn terminate(&mut self) -> Result<(), UnitError> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::sync::{Arc, Mutex};

    use super::*;
    use crate::system::mock::Mock;

    /// Adds its parameter to its input, and counts its steps.
    struct Adder(u8, f64);

    impl Substitute for Adder {
        fn start(&mut self, _: f64, of: &Variables<'_>, _: &mut [f64]) -> Result<(), String> {
            assert_eq!((of.inputs, of.outputs), (&["in".to_owned()][..], &["out".to_owned()][..]));
            self.1 = of.parameters[0].1;
            Ok(())
        }

        fn step(&mut self, _: (f64, f64), inputs: &[f64], out: &mut [f64]) -> Result<(), String> {
            self.0 += 1;
            out[0] = inputs[0] + self.1;
            if self.0 > 2 { Err("it is tired".to_owned()) } else { Ok(()) }
        }

        fn save(&mut self) -> Result<Vec<u8>, String> {
            Ok(vec![self.0])
        }

        fn restore(&mut self, saved: &[u8]) -> Result<(), String> {
            self.0 = saved[0];
            Ok(())
        }
    }

    fn adder() -> Box<dyn Unit> {
        let names = [("out", "output"), ("in", "input"), ("more", "parameter")];
        let variables = names.map(|(name, causality)| (name.to_owned(), causality));
        let calls = Arc::new(Mutex::new(vec![]));
        let mut units: [Box<dyn Unit>; 1] =
            [Box::new(Mock::new("adder", &variables, &calls, |_, _, _| {}))];
        let adder: Box<dyn Substitute> = Box::new(Adder(0, 0.0));
        let mut substitutes = Substitutes::from([("adder".to_owned(), adder)]);
        replace(&mut units, &mut substitutes);
        assert!(substitutes.is_empty(), "it is taken");
        let [mut unit] = units;
        unit.set_reals(&[2], &[10.0]).unwrap();
        unit.enter_initialization(0.0, 1.0).unwrap();
        unit
    }

    fn stepped(unit: &mut Box<dyn Unit>, input: f64) -> Result<f64, UnitError> {
        let mut value = [f64::NAN];
        unit.set_reals(&[1], &[input])?;
        unit.step(0.0, 1.0)?;
        unit.get_reals(&[0], &mut value)?;
        Ok(value[0])
    }

    /// It goes on from a saved state, and what it complains of is told under its name.
    #[test]
    fn a_substitute_has_the_variables_of_the_unit_that_it_stands_for() {
        let mut unit = adder();
        assert_eq!(stepped(&mut unit, 1.0), Ok(11.0));
        let saved = unit.save().unwrap();
        assert_eq!(stepped(&mut unit, 2.0), Ok(12.0));
        let error = stepped(&mut unit, 3.0).unwrap_err().to_string();
        assert!(error.starts_with("adder: it is tired (in place of"), "{error}");
        unit.restore(&saved).unwrap();
        let mut value = [f64::NAN];
        unit.get_reals(&[0], &mut value).unwrap();
        assert_eq!(value, [11.0]);
        assert_eq!(stepped(&mut unit, 2.0), Ok(12.0));
        assert!(unit.restore(&saved[..1]).is_err());
    }
}
