//! A rail's unit: gathers what the wheels do and steps at its own rate.

use std::io;

use crate::system::port::Port;
use crate::system::unit::{Unit, UnitError};
use crate::train::lockstep::Clock;
use crate::train::roles::{SIDES, rail_input, train, vehicle_output};
use crate::train::tape::Tape;

/// A rail's unit with its inputs: a block of [`rail_input::NAMES`] for each wheelset.
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
    /// Inputs that keep a value throughout, such as those of the weather: reference and value.
    pub constants: Vec<(u32, f64)>,
    /// What the wheels of the run do, if further trains shall do the same.
    pub tape: Option<Tape>,
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
        let constants = vec![];
        Self { unit, inputs, wheelsets, side, every, constants, tape: None, sums, gathered: 0 }
    }

    /// `left` or `right`.
    pub fn side_name(&self) -> &'static str {
        SIDES[self.side]
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

    /// Whether point `k + 1` ends one of the rail's steps.
    pub fn is_due(&self, k: u64) -> bool {
        (k + 1).is_multiple_of(self.every)
    }

    /// Steps the rail if point `k + 1` ends one of its steps.
    ///
    /// # Errors
    /// When the unit fails, or the tape cannot be written.
    pub fn step(&mut self, clock: Clock, k: u64) -> Result<(), UnitError> {
        if !self.is_due(k) {
            return Ok(());
        }
        self.form_means();
        if let Some(tape) = &mut self.tape {
            tape.add(&self.inputs.values).map_err(|error| self.tape_error(&error))?;
        }
        self.inputs.set(self.unit.as_mut())?;
        let from = k + 1 - self.every;
        self.unit.step(clock.at(from), self.every as f64 * clock.length)
    }

    /// Steps once more with what the wheels did in the next step on the tape.
    ///
    /// # Errors
    /// When the unit fails, or the tape cannot be read.
    pub fn step_again(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        if let Some(tape) = &mut self.tape {
            tape.next(&mut self.inputs.values).map_err(|error| self.tape_error(&error))?;
        }
        self.inputs.set(self.unit.as_mut())?;
        self.unit.step(time, length)
    }

    /// Steps without wheels.
    ///
    /// # Errors
    /// When the unit fails.
    pub fn step_alone(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        self.inputs.values.fill(0.0);
        self.inputs.set(self.unit.as_mut())?;
        self.unit.step(time, length)
    }

    /// Goes back to the beginning of the tape and gives its number of steps.
    ///
    /// # Errors
    /// When what is on it could not be written.
    pub fn rewind(&mut self) -> Result<u64, UnitError> {
        match &mut self.tape {
            Some(tape) => tape.rewind().map_err(|error| self.tape_error(&error)),
            None => Ok(0),
        }
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

    fn tape_error(&self, error: &io::Error) -> UnitError {
        UnitError {
            instance: format!("{} rail", self.side_name()).into(),
            source_file: "the wheels' loads on disk, for further trains".into(),
            action: "writing or reading".into(),
            status: None,
            last_message: Some(error.to_string().into()),
        }
    }
}
