//! The step loop: train, vehicles and rail in lockstep (docs/user-guide, "The step").
//!
//! After each step the outputs of a unit are got once; then everything is computed, set once and
//! stepped, so that no output is read between a set and the next step (FMI 2.0 §4.2.4). Times
//! are t_k = t_0 + k·h from integers.

use crate::parallel;
use crate::port::Port;
use crate::rail::Rail;
use crate::roles::{train, vehicle_input, vehicle_output};
use crate::scenario::Scheme;
use crate::synchronisation::{Controller, Motion};
use crate::times::{StepTimes, Stopwatch};
use crate::unit::{Unit, UnitError};

/// The train's unit with its outputs: a block of [`train::NAMES`] for each vehicle.
pub struct Train {
    /// The unit.
    pub unit: Box<dyn Unit>,
    /// Outputs at the last communication point.
    pub outputs: Port,
}

/// A vehicle's unit with what goes in and out, and its controller.
pub struct Vehicle {
    /// The unit.
    pub unit: Box<dyn Unit>,
    /// Forces of the step, [`vehicle_input::NAMES`].
    pub inputs: Port,
    /// Outputs at the last communication point, laid out as [`vehicle_output`] says.
    pub outputs: Port,
    /// Keeps it at its place in the train.
    pub controller: Controller,
}

/// Communication points t_k = start + k·length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock {
    /// Time of point 0, s.
    pub start: f64,
    /// Time between two points, s.
    pub length: f64,
}

impl Clock {
    /// Time of point `k`, s.
    pub fn at(&self, k: u64) -> f64 {
        self.start + k as f64 * self.length
    }
}

/// All units of a run between two steps.
pub struct Lockstep {
    /// The communication points.
    pub clock: Clock,
    /// Order of the exchange.
    pub scheme: Scheme,
    /// The train.
    pub train: Train,
    /// The vehicles from head to tail.
    pub vehicles: Vec<Vehicle>,
    /// The rail, if one is heated.
    pub rail: Option<Rail>,
    /// Where the wall time goes.
    pub times: StepTimes,
}

impl Lockstep {
    /// Takes all units from point `k` to `k + 1`.
    ///
    /// # Errors
    /// When a unit fails; the others keep what they have.
    pub fn step(&mut self, k: u64) -> Result<(), UnitError> {
        let (time, length) = (self.clock.at(k), self.clock.length);
        let mut watch = Stopwatch::start();
        self.synchronise();
        if self.scheme == Scheme::Jacobi {
            self.pass_forces();
            self.pass_wheels();
        }
        self.times.exchange += watch.lap();

        self.train.step(time, length)?;
        self.times.train += watch.lap();

        if self.scheme == Scheme::Sequential {
            self.pass_forces();
        }
        self.times.exchange += watch.lap();

        parallel::for_each(&mut self.vehicles, |vehicle| vehicle.step(time, length))?;
        self.times.vehicles += watch.lap();

        if self.scheme == Scheme::Sequential {
            self.pass_wheels();
        }
        self.times.exchange += watch.lap();

        if let Some(rail) = &mut self.rail {
            rail.step(self.clock, k)?;
        }
        self.times.rail += watch.lap();
        Ok(())
    }

    /// Forms the synchronisation forces from the errors at one instant.
    fn synchronise(&mut self) {
        let length = self.clock.length;
        for (vehicle, place) in self.vehicles.iter_mut().zip(self.train.blocks()) {
            let motion = vehicle.motion();
            let in_train =
                Motion { position: place[train::POSITION], velocity: place[train::VELOCITY] };
            vehicle.inputs.values[vehicle_input::SYNCHRONISATION] =
                vehicle.controller.force(motion, in_train, length);
        }
    }

    /// Hands the train's forces to the vehicles.
    pub fn pass_forces(&mut self) {
        for (vehicle, place) in self.vehicles.iter_mut().zip(self.train.blocks()) {
            let forces = &mut vehicle.inputs.values;
            forces[vehicle_input::COUPLER_FRONT] = place[train::COUPLER_FRONT];
            forces[vehicle_input::COUPLER_REAR] = place[train::COUPLER_REAR];
            forces[vehicle_input::RESISTANCE] = place[train::RESISTANCE];
            forces[vehicle_input::TRACTION] = place[train::TRACTION];
            forces[vehicle_input::BRAKE] = place[train::BRAKE];
        }
    }

    /// Hands the wheels' outputs to the rail.
    pub fn pass_wheels(&mut self) {
        if let Some(rail) = &mut self.rail {
            let outputs = self.vehicles.iter().map(|vehicle| vehicle.outputs.values.as_slice());
            rail.take(outputs.zip(self.train.blocks()));
        }
    }
}

impl Train {
    fn step(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        self.unit.step(time, length)?;
        self.outputs.get(self.unit.as_mut())
    }

    /// Each vehicle's block of outputs.
    pub fn blocks(&self) -> impl Iterator<Item = &[f64]> {
        self.outputs.values.chunks_exact(train::NAMES.len())
    }
}

impl Vehicle {
    fn step(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        self.inputs.set(self.unit.as_mut())?;
        self.unit.step(time, length)?;
        self.outputs.get(self.unit.as_mut())
    }

    /// Position and velocity at the last communication point.
    pub fn motion(&self) -> Motion {
        Motion {
            position: self.outputs.values[vehicle_output::POSITION],
            velocity: self.outputs.values[vehicle_output::VELOCITY],
        }
    }
}
