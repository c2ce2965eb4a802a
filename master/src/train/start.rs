//! The start of a run: the initialisation of all units, in the order in which values flow.
//!
//! The train is initialised first; its vehicles' places, speeds and forces are start values and
//! inputs of the vehicles, and their wheels' outputs are inputs of the rail.

use controller::Motion;

use crate::scenario::Scenario;
use crate::system::parallel;
use crate::system::port::Port;
use crate::system::unit::{Unit, UnitError};
use crate::train::lockstep::{Lockstep, Train, Vehicle, in_train};
use crate::train::rail::Rail;

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

/// Place of the leading vehicle's middle and speed at the start of a scenario.
pub(crate) fn start_of(scenario: &Scenario) -> Motion {
    Motion {
        position: scenario.train.leading_vehicle_position_m,
        velocity: scenario.train.speed_m_per_s,
    }
}

impl Lockstep {
    /// Initialises all units for a run until `stop`, the rails until `rails_stop`, s, with the
    /// leading vehicle's middle and speed as in `values`.
    ///
    /// # Errors
    /// When a unit cannot be initialised.
    pub fn initialize(
        &mut self,
        values: Motion,
        stop: f64,
        rails_stop: f64,
    ) -> Result<(), UnitError> {
        let start = self.clock.start;
        self.train.initialize(values, start, stop)?;
        self.pass_forces();
        let places: Vec<Motion> = self.train.blocks().map(in_train).collect();
        let mut vehicles: Vec<_> = self.vehicles.iter_mut().zip(places).collect();
        parallel::for_each(&mut vehicles, |(vehicle, place)| {
            vehicle.initialize(*place, start, stop)
        })?;
        self.pass_wheels();
        parallel::for_each(&mut self.rails, |rail| rail.initialize(start, rails_stop))
    }
}

impl Train {
    fn initialize(&mut self, values: Motion, start: f64, stop: f64) -> Result<(), UnitError> {
        set_start_values(&mut self.start, self.unit.as_mut(), values)?;
        self.unit.enter_initialization(start, stop)?;
        set_constants(&self.constants, self.unit.as_mut())?;
        self.unit.exit_initialization()?;
        // Some FMUs compute their outputs only when the initialisation ends.
        self.outputs.get(self.unit.as_mut())
    }
}

impl Vehicle {
    /// `place` is the vehicle's place and speed in the train.
    fn initialize(&mut self, place: Motion, start: f64, stop: f64) -> Result<(), UnitError> {
        set_start_values(&mut self.start, self.unit.as_mut(), place)?;
        self.unit.enter_initialization(start, stop)?;
        set_constants(&self.constants, self.unit.as_mut())?;
        self.inputs.set(self.unit.as_mut())?;
        self.unit.exit_initialization()?;
        self.outputs.get(self.unit.as_mut())?;
        self.controller_force = self.controller.force(self.motion(), place);
        Ok(())
    }
}

impl Rail {
    fn initialize(&mut self, start: f64, stop: f64) -> Result<(), UnitError> {
        self.unit.enter_initialization(start, stop)?;
        set_constants(&self.constants, self.unit.as_mut())?;
        self.form_means();
        self.inputs.set(self.unit.as_mut())?;
        self.unit.exit_initialization()
    }
}

/// Sets the inputs that keep a value throughout.
fn set_constants(constants: &[(u32, f64)], unit: &mut dyn Unit) -> Result<(), UnitError> {
    constants.iter().try_for_each(|&(reference, value)| unit.set_reals(&[reference], &[value]))
}

/// Sets the two start parameters that the train and the vehicles share.
fn set_start_values(port: &mut Port, unit: &mut dyn Unit, start: Motion) -> Result<(), UnitError> {
    port.values.copy_from_slice(&[start.position, start.velocity]);
    port.set(unit)
}
