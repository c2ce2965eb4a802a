//! A system of units: initialisation, and steps in which all take the last exchange (Jacobi).

use super::links::{Link, Links, Part};
use crate::interface::VariableType;
use crate::system::parallel;
use crate::system::times::Stopwatch;
use crate::system::unit::{Unit, UnitError};
use crate::train::lockstep::Clock;
use crate::train::start::StartError;

/// Units and what flows between them.
pub struct System {
    /// The communication points.
    pub clock: Clock,
    /// The units.
    pub parts: Vec<Part>,
    /// What flows between them.
    pub links: Links,
}

/// Sweeps of the initialisation beyond the longest chain that there can be without a loop: in
/// them a loop may settle that halves its errors.
const SPARE_SWEEPS: usize = 100;

/// Inputs of a loop that a message names.
const NAMED_INPUTS: usize = 5;

impl System {
    /// A system without units.
    pub fn empty(clock: Clock) -> Self {
        Self { clock, parts: vec![], links: Links::default() }
    }

    /// Initialises all units for a run until `stop`, s: outputs go into the inputs that they are
    /// linked to until nothing changes any more.
    ///
    /// # Errors
    /// When a unit refuses, or the initial values do not settle.
    pub fn initialize(&mut self, stop: f64) -> Result<(), StartError> {
        let start = self.clock.start;
        parallel::for_each(&mut self.parts, |part| {
            part.unit.enter_initialization(start, stop)?;
            part.outputs.get(part.unit.as_mut())
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
        let mut moving: Vec<(VariableType, Link)> = vec![];
        for sweep in 0..self.parts.len() + SPARE_SWEEPS {
            // The first sweep also sends the start values of inputs that are not linked.
            let mut concerned = vec![sweep == 0; self.parts.len()];
            moving.clear();
            self.links.transfer(&mut self.parts, |kind, link| {
                concerned[link.to.part] = true;
                moving.push((kind, *link));
            });
            if sweep > 0 && moving.is_empty() {
                return Ok(());
            }
            let mut parts: Vec<_> = self.parts.iter_mut().zip(concerned).collect();
            parallel::for_each(&mut parts, |(part, concerned)| match concerned {
                true => {
                    part.inputs.set(part.unit.as_mut())?;
                    part.outputs.get(part.unit.as_mut())
                }
                false => Ok(()),
            })?;
        }
        moving.truncate(NAMED_INPUTS);
        let inputs = moving
            .iter()
            .map(|(kind, link)| self.parts[link.to.part].input_name(*kind, link.to.at));
        Err(StartError::Loop { inputs: inputs.collect() })
    }

    /// Takes all units from point `k` to `k + 1`.
    ///
    /// # Errors
    /// When a unit fails; the others keep what they have.
    pub fn step(&mut self, k: u64) -> Result<(), UnitError> {
        let (time, length) = (self.clock.at(k), self.clock.length);
        self.links.transfer(&mut self.parts, |_, _| {});
        parallel::for_each(&mut self.parts, |part| {
            let mut watch = Stopwatch::start();
            part.inputs.set(part.unit.as_mut())?;
            part.unit.step(time, length)?;
            part.outputs.get(part.unit.as_mut())?;
            part.wall += watch.lap();
            Ok(())
        })
    }

    /// All units.
    pub fn units(&self) -> impl Iterator<Item = &dyn Unit> {
        self.parts.iter().map(|part| part.unit.as_ref())
    }

    /// All units.
    pub fn units_mut(&mut self) -> impl Iterator<Item = &mut Box<dyn Unit>> {
        self.parts.iter_mut().map(|part| &mut part.unit)
    }
}
