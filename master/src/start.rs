//! The start of a run: the initialisation of all units, in the order in which values flow.
//!
//! The train is initialised first; its vehicles' places, speeds and forces are start values and
//! inputs of the vehicles, and their wheels' outputs are inputs of the rail.

use crate::lockstep::{Lockstep, Train, Vehicle};
use crate::parallel;
use crate::rail::Rail;
use crate::roles::train;
use crate::unit::{Unit, UnitError};

/// Start position and speed of the train.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StartValues {
    /// Chainage of the leading vehicle's middle, m.
    pub position: f64,
    /// Speed, m/s.
    pub velocity: f64,
}

impl Lockstep {
    /// Initialises all units for a run until `stop`, the rails until `rails_stop`, s.
    ///
    /// # Errors
    /// When a unit cannot be initialised.
    pub fn initialize(
        &mut self,
        values: StartValues,
        stop: f64,
        rails_stop: f64,
    ) -> Result<(), UnitError> {
        let start = self.clock.start;
        self.train.initialize(values, start, stop)?;
        self.pass_forces();
        let places: Vec<StartValues> = self
            .train
            .blocks()
            .map(|b| StartValues { position: b[train::POSITION], velocity: b[train::VELOCITY] })
            .collect();
        let mut vehicles: Vec<_> = self.vehicles.iter_mut().zip(places).collect();
        parallel::for_each(&mut vehicles, |(vehicle, place)| {
            vehicle.initialize(*place, start, stop)
        })?;
        self.pass_wheels();
        parallel::for_each(&mut self.rails, |rail| rail.initialize(start, rails_stop))
    }

    /// Ends the run of all units; every one is told, the first error is given.
    ///
    /// # Errors
    /// When a unit could not complete what it writes.
    pub fn terminate(&mut self) -> Result<(), UnitError> {
        let ends: Vec<_> = self.units_mut().map(|unit| unit.terminate()).collect();
        ends.into_iter().collect()
    }
}

impl Train {
    fn initialize(&mut self, values: StartValues, start: f64, stop: f64) -> Result<(), UnitError> {
        set_start_values(self.unit.as_mut(), values)?;
        self.unit.enter_initialization(start, stop)?;
        self.outputs.get(self.unit.as_mut())?;
        self.unit.exit_initialization()
    }
}

impl Vehicle {
    fn initialize(&mut self, values: StartValues, start: f64, stop: f64) -> Result<(), UnitError> {
        set_start_values(self.unit.as_mut(), values)?;
        self.unit.enter_initialization(start, stop)?;
        self.inputs.set(self.unit.as_mut())?;
        self.outputs.get(self.unit.as_mut())?;
        self.unit.exit_initialization()
    }
}

impl Rail {
    fn initialize(&mut self, start: f64, stop: f64) -> Result<(), UnitError> {
        self.unit.enter_initialization(start, stop)?;
        for &(reference, value) in &self.constants {
            self.unit.set_reals(&[reference], &[value])?;
        }
        self.form_means();
        self.inputs.set(self.unit.as_mut())?;
        self.unit.exit_initialization()
    }
}

/// Sets the two start parameters that the train and the vehicles share.
fn set_start_values(unit: &mut dyn Unit, values: StartValues) -> Result<(), UnitError> {
    unit.set_real_parameter("initial.position", values.position)?;
    unit.set_real_parameter("initial.velocity", values.velocity)
}
