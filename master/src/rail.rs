//! The rail's unit: gathers what the wheels do and steps at its own rate.

use crate::lockstep::Clock;
use crate::port::Port;
use crate::roles::{rail_input, train, vehicle_output};
use crate::unit::{Unit, UnitError};

/// The rail's unit with its inputs: a block of [`rail_input::NAMES`] for each wheelset.
pub struct Rail {
    /// The unit.
    pub unit: Box<dyn Unit>,
    /// What the wheelsets do.
    pub inputs: Port,
    /// Number of wheelsets of each vehicle.
    pub wheelsets: Vec<usize>,
    /// Which wheel of a wheelset runs on the rail: 0 left, 1 right.
    pub side: usize,
    /// Exchange steps per step of the rail.
    pub every: u64,
    /// Sums since the last step of the rail, for the means that it gets.
    sums: Vec<f64>,
    /// Exchange steps in the sums.
    gathered: u64,
}

impl Rail {
    /// A rail whose inputs are not yet known.
    pub fn new(
        unit: Box<dyn Unit>,
        inputs: Port,
        wheelsets: Vec<usize>,
        side: usize,
        every: u64,
    ) -> Self {
        let sums = vec![0.0; inputs.values.len()];
        Self { unit, inputs, wheelsets, side, every, sums, gathered: 0 }
    }

    /// Takes the outputs of all vehicles at a communication point, each with its place in the train.
    ///
    /// The wheelsets' positions are the last ones; everything else is the mean since the last
    /// step of the rail, so that energy is summed and never sampled.
    pub fn take<'v>(&mut self, vehicles: impl Iterator<Item = (&'v [f64], &'v [f64])>) {
        self.gathered += 1;
        let block = rail_input::NAMES.len();
        let mut at = 0;
        for ((outputs, place), &wheelsets) in vehicles.zip(&self.wheelsets) {
            for j in 0..wheelsets {
                let inputs = &mut self.inputs.values[at..at + block];
                let sums = &mut self.sums[at..at + block];
                inputs[rail_input::POSITION] = outputs[vehicle_output::wheelset(j)];
                sums[rail_input::SPEED] += outputs[vehicle_output::VELOCITY];
                sums[rail_input::BRAKE_POWER] += place[train::WHEEL_BRAKE_POWER];
                let wheel = &outputs[vehicle_output::wheel(j, self.side)..];
                for (sum, place) in sums[2..].iter_mut().zip(rail_input::FROM_WHEEL) {
                    *sum += wheel[place];
                }
                at += block;
            }
        }
    }

    /// Steps the rail if point `k + 1` ends one of its steps.
    ///
    /// # Errors
    /// When the unit fails.
    pub fn step(&mut self, clock: Clock, k: u64) -> Result<(), UnitError> {
        if !(k + 1).is_multiple_of(self.every) {
            return Ok(());
        }
        self.form_means();
        self.inputs.set(self.unit.as_mut())?;
        let from = k + 1 - self.every;
        self.unit.step(clock.at(from), self.every as f64 * clock.length)
    }

    /// Turns the sums into the inputs of the next step and begins new ones.
    pub fn form_means(&mut self) {
        let count = self.gathered as f64;
        let block = rail_input::NAMES.len();
        for (i, (input, sum)) in self.inputs.values.iter_mut().zip(&mut self.sums).enumerate() {
            if i % block != rail_input::POSITION {
                *input = *sum / count;
            }
            *sum = 0.0;
        }
        self.gathered = 0;
    }
}
