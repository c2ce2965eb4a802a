//! The start of a system: the initialisation of all units, with initial values that flow from
//! outputs to inputs until nothing changes any more.

use super::parallel;
use super::signals::Signals;
use super::step::System;
use super::unit::UnitError;
use crate::interface::VariableType;

/// Why units cannot be initialised.
#[derive(Debug, thiserror::Error)]
pub enum StartError {
    /// A unit refuses.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// Initial values depend on each other.
    #[error(
        "the initial values of {} depend on each other in a loop and do not settle; give start \
         values that fit, or break the loop",
        inputs.join(", ")
    )]
    Loop {
        /// Inputs that still change, as `component.variable`.
        inputs: Vec<String>,
    },
}

/// Sweeps of the initialisation beyond the longest chain that there can be without a loop: in
/// them a loop may settle that halves its errors.
const SPARE_SWEEPS: usize = 100;

/// Inputs of a loop that a message names.
const NAMED_INPUTS: usize = 5;

/// An input of a part: number of the part, type, and index.
type Input = (usize, VariableType, usize);

impl System {
    /// Initialises all units for a run that ends for each part at the time that `stop` tells, s.
    ///
    /// # Errors
    /// When a unit refuses, or the initial values do not settle.
    pub fn initialize(&mut self, stop: impl Fn(usize) -> f64 + Sync) -> Result<(), StartError> {
        let start = self.clock.start;
        let mut parts: Vec<_> = self.parts.iter_mut().enumerate().collect();
        parallel::for_each(&mut parts, |(number, part)| {
            part.unit.enter_initialization(start, stop(*number))?;
            part.starts.set(part.unit.as_mut())
        })?;
        self.settle()?;
        parallel::for_each(&mut self.parts, |part| {
            part.unit.exit_initialization()?;
            // Some units compute their outputs only now.
            part.outputs.get(part.unit.as_mut())
        })?;
        Ok(())
    }

    /// Repeats the exchange of initial values until nothing changes.
    fn settle(&mut self) -> Result<(), StartError> {
        let mut known = vec![false; self.parts.len()];
        let mut moving: Vec<Input> = vec![];
        for sweep in 0..=self.parts.len() + SPARE_SWEEPS {
            moving.clear();
            for stage in 0..self.stages.len() {
                moving.extend(self.sweep(stage, &known)?);
                known[self.stages[stage].parts.clone()].fill(true);
            }
            if sweep > 0 && moving.is_empty() {
                return Ok(());
            }
        }
        moving.truncate(NAMED_INPUTS);
        let name = |&(part, kind, index): &Input| self.parts[part].input_name(kind, index);
        Err(StartError::Loop { inputs: moving.iter().map(name).collect() })
    }

    /// Takes the initial values of a stage from the parts that are `known`, and gives the inputs that
    /// have changed. What is not known yet leaves the unit's own start values.
    fn sweep(&mut self, stage: usize, known: &[bool]) -> Result<Vec<Input>, UnitError> {
        let stage = &self.stages[stage];
        let numbers = stage.parts.clone();
        let before: Vec<Signals> =
            self.parts[numbers.clone()].iter().map(|part| part.inputs.clone()).collect();
        let mut waits = vec![false; self.parts.len()];
        for gather in &stage.gathers {
            waits[gather.receiver] |= !known[gather.giver];
        }
        for gather in stage.gathers.iter().filter(|gather| !waits[gather.receiver]) {
            gather.pull_at_start(&mut self.parts);
        }
        let mut moved = vec![];
        let mut concerned = vec![];
        for ((number, part), before) in numbers.clone().zip(&mut self.parts[numbers]).zip(&before) {
            let changed = part.inputs.changed_since(before);
            if !changed.is_empty() || !known[number] {
                concerned.push((part, !changed.is_empty()));
            }
            moved.extend(changed.into_iter().map(|(kind, index)| (number, kind, index)));
        }
        parallel::for_each(&mut concerned, |(part, changed)| {
            if *changed {
                part.inputs.set(part.unit.as_mut())?;
            }
            part.outputs.get(part.unit.as_mut())
        })?;
        Ok(moved)
    }
}
