//! The start of a system: the initialisation of all units, with initial values that flow from
//! outputs to inputs until nothing changes any more.

use super::clock::beyond;
use super::parallel;
use super::signals::Signals;
use super::step::{Stage, System};
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
            part.unit.enter_initialization(start, beyond(start, stop(*number)))?;
            part.starts.set(part.unit.as_mut())
        })?;
        self.settle()?;
        for stage in 0..self.stages.len() {
            self.begin(stage)?;
        }
        Ok(())
    }

    /// Ends the initialisation of a stage. Some units compute their outputs only then, so each stage takes
    /// once more what those before it give.
    fn begin(&mut self, stage: usize) -> Result<(), UnitError> {
        let all = vec![true; self.parts.len()];
        let start = self.clock.start;
        let parts = self.stages[stage].parts.clone();
        let changed = self.take(stage, &all);
        let mut concerned: Vec<_> = self.parts[parts].iter_mut().zip(changed).collect();
        parallel::for_each(&mut concerned, |(part, changed)| {
            if !changed.is_empty() {
                part.inputs.set(part.unit.as_mut())?;
            }
            part.unit.exit_initialization()?;
            part.take_outputs(start)
        })
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
        let numbers = self.stages[stage].parts.clone();
        let changed = self.take(stage, known);
        let parts = numbers.clone().zip(&mut self.parts[numbers.clone()]).zip(&changed);
        let mut concerned: Vec<_> =
            parts.filter(|((number, _), changed)| !changed.is_empty() || !known[*number]).collect();
        parallel::for_each(&mut concerned, |((_, part), changed)| {
            if !changed.is_empty() {
                part.inputs.set(part.unit.as_mut())?;
            }
            part.outputs.get(part.unit.as_mut())
        })?;
        let of_part = |(number, inputs): (usize, Vec<(VariableType, usize)>)| {
            inputs.into_iter().map(move |(kind, index)| (number, kind, index))
        };
        Ok(numbers.zip(changed).flat_map(of_part).collect())
    }

    /// Hands the values of the parts that are `known` to the parts of a stage whose givers are all
    /// known, and gives for each part of the stage the inputs that have changed.
    fn take(&mut self, stage: usize, known: &[bool]) -> Vec<Vec<(VariableType, usize)>> {
        let Stage { parts, links, .. } = &self.stages[stage];
        let before: Vec<Signals> =
            self.parts[parts.clone()].iter().map(|part| part.inputs.clone()).collect();
        let mut waits = vec![false; self.parts.len()];
        for link in links.iter() {
            waits[link.receiver as usize] |= !known[link.giver as usize];
        }
        links.pull_at_start(&mut self.parts, |receiver| !waits[receiver]);
        let changed = |(number, before): (usize, &Signals)| match waits[number] {
            true => vec![],
            false => self.parts[number].inputs.changed_since(before),
        };
        parts.clone().zip(&before).map(changed).collect()
    }
}
