//! The step loop: train, vehicles and rails in lockstep (docs/user-guide, "The step").
//!
//! After each step the outputs of a unit are got once; then everything is computed, set once and
//! stepped, so that no output is read between a set and the next step (FMI 2.0 §4.2.4). Times
//! are t_k = t_0 + k·h from integers.

use controller::{Controller, Motion};

use crate::scenario::Scheme;
use crate::system::parallel;
use crate::system::port::Port;
use crate::system::times::{StepTimes, Stopwatch};
use crate::system::unit::{Unit, UnitError};
use crate::train::rail::Rail;
use crate::train::roles::{train, vehicle_input, vehicle_output};

/// The train's unit with its outputs: a block of [`train::NAMES`] for each vehicle.
pub struct Train {
    /// The unit.
    pub unit: Box<dyn Unit>,
    /// Position and speed at the start.
    pub start: Port,
    /// Inputs that keep a value for the whole run, such as the wind: references and values.
    pub constants: Vec<(u32, f64)>,
    /// Outputs at the last communication point.
    pub outputs: Port,
}

/// A vehicle's unit with what goes in and out, and its controller.
pub struct Vehicle {
    /// The unit.
    pub unit: Box<dyn Unit>,
    /// Position and speed at the start.
    pub start: Port,
    /// Forces of the step, [`vehicle_input::NAMES`].
    pub inputs: Port,
    /// Inputs that keep a value throughout: reference and value.
    pub constants: Vec<(u32, f64)>,
    /// Outputs at the last communication point, laid out as [`vehicle_output`] says.
    pub outputs: Port,
    /// Keeps it at its place in the train.
    pub controller: Controller,
    /// The controller's output at the last communication point, for the scheme in which it is a
    /// unit like the others, N.
    pub controller_force: f64,
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
    /// The heated rails.
    pub rails: Vec<Rail>,
    /// Where the wall time goes.
    pub times: StepTimes,
}

impl Lockstep {
    /// All units: the train, the vehicles from head to tail, the rails.
    pub fn units(&self) -> impl Iterator<Item = &dyn Unit> {
        let vehicles = self.vehicles.iter().map(|vehicle| vehicle.unit.as_ref());
        let rails = self.rails.iter().map(|rail| rail.unit.as_ref());
        std::iter::once(self.train.unit.as_ref()).chain(vehicles).chain(rails)
    }

    /// All units, in the order of [`units`](Self::units).
    pub fn units_mut(&mut self) -> impl Iterator<Item = &mut Box<dyn Unit>> {
        self.units_with_constants().map(|(unit, _)| unit)
    }

    /// All units, in the same order, with their inputs that keep a value: references and values.
    pub fn units_with_constants(
        &mut self,
    ) -> impl Iterator<Item = (&mut Box<dyn Unit>, &[(u32, f64)])> {
        let Self { train, vehicles, rails, .. } = self;
        let train = (&mut train.unit, train.constants.as_slice());
        let vehicles = vehicles.iter_mut().map(|v| (&mut v.unit, v.constants.as_slice()));
        let rails = rails.iter_mut().map(|rail| (&mut rail.unit, rail.constants.as_slice()));
        std::iter::once(train).chain(vehicles).chain(rails)
    }

    /// The time to which the rails have come after so many steps, s.
    pub fn rails_time(&self, steps: u64) -> f64 {
        let every = self.rails.first().map_or(1, |rail| rail.every);
        self.clock.at(steps / every * every)
    }

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

        if self.rails.iter().any(|rail| rail.is_due(k)) {
            let clock = self.clock;
            parallel::for_each(&mut self.rails, |rail| rail.step(clock, k))?;
        }
        self.times.rail += watch.lap();
        Ok(())
    }

    /// Forms the synchronisation forces from the errors at one instant.
    ///
    /// Sequentially they act at once; where all units take the last exchange, a force acts in
    /// the step after the one in which the controller has formed it.
    fn synchronise(&mut self) {
        let (length, scheme) = (self.clock.length, self.scheme);
        for (vehicle, place) in self.vehicles.iter_mut().zip(self.train.blocks()) {
            let force = vehicle.controller.step(vehicle.motion(), in_train(place), length);
            let last = std::mem::replace(&mut vehicle.controller_force, force);
            vehicle.inputs.values[vehicle_input::SYNCHRONISATION] = match scheme {
                Scheme::Sequential => force,
                Scheme::Jacobi => last,
            };
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

    /// Hands the wheels' outputs to the rails.
    pub fn pass_wheels(&mut self) {
        for rail in &mut self.rails {
            let outputs = self.vehicles.iter().map(|vehicle| vehicle.outputs.values.as_slice());
            rail.take(outputs.zip(self.train.blocks()));
        }
    }
}

/// Motion of a vehicle's place in the train, from its block of outputs.
pub fn in_train(block: &[f64]) -> Motion {
    Motion { position: block[train::POSITION], velocity: block[train::VELOCITY] }
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

    /// Number of its wheelsets.
    pub fn wheelsets(&self) -> usize {
        let of_wheelsets = self.outputs.values.len() - vehicle_output::NAMES.len();
        of_wheelsets / vehicle_output::WHEELSET_BLOCK
    }

    /// Position and velocity at the last communication point.
    pub fn motion(&self) -> Motion {
        Motion {
            position: self.outputs.values[vehicle_output::POSITION],
            velocity: self.outputs.values[vehicle_output::VELOCITY],
        }
    }
}
