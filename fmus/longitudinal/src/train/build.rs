//! Building a train: what its vehicles share, and why one cannot be built.

use std::sync::Arc;

use files::Mistake;
use numerics::TableError;

use crate::coupling::connection::GearPair;
use crate::coupling::draft_gear::DraftGear;
use crate::train::vehicle::Vehicle;

/// Why a train cannot be built.
#[derive(Debug, thiserror::Error)]
pub enum BuildError {
    /// A rolling-stock file cannot be used.
    #[error(transparent)]
    Stock(#[from] Mistake),
    /// A table of a vehicle type cannot be used.
    #[error("vehicle {vehicle}: {source}")]
    Table {
        /// The type's name.
        vehicle: String,
        /// Reason.
        source: TableError,
    },
    /// Two neighbours have couplers of different kinds.
    #[error(
        "vehicles {number} and {next} of the consist do not fit: the rear coupler of {front} is \
         {front_kind:?}, the front coupler of {rear} is {rear_kind:?} (coupler.kind)"
    )]
    DoNotFit {
        /// Number of the vehicle in front, from 1.
        number: usize,
        /// Number of the vehicle behind it.
        next: usize,
        /// Type of the vehicle in front.
        front: String,
        /// Kind of its rear coupler.
        front_kind: String,
        /// Type of the vehicle behind it.
        rear: String,
        /// Kind of its front coupler.
        rear_kind: String,
    },
    /// A hand brake is applied that a vehicle does not have.
    #[error(
        "vehicle {number} of the consist: hand_brake = {share}: its type {vehicle} has no section \
         [hand_brake]"
    )]
    NoHandBrake {
        /// Number of the vehicle in the train, from 1.
        number: usize,
        /// Share that is applied.
        share: f64,
        /// The type's name.
        vehicle: String,
    },
    /// The step of the model is too long for the train.
    #[error(
        "the step of {step} s is longer than the longest stable one, {longest:.2e} s, which vehicles \
         {number} and {next} set: give their draft gears a greater transition_speed_mm_s or none, \
         less damping, or less stiffness"
    )]
    Unstable {
        /// Step, s.
        step: f64,
        /// Longest stable step, s.
        longest: f64,
        /// Vehicle in front of the connection, from 1.
        number: usize,
        /// Vehicle behind it.
        next: usize,
    },
}

/// What vehicles of the same type and connections of the same gears have in common. A step reads the
/// tables of a type once into the fast memory of the processor, not once for each vehicle.
#[derive(Default)]
pub(crate) struct Shared<'a> {
    vehicles: Vec<(&'a stock::Vehicle, Arc<Vehicle>)>,
    gears: Vec<([&'a stock::DraftGear; 2], Arc<GearPair>)>,
}

impl<'a> Shared<'a> {
    /// The vehicle of a file.
    pub fn vehicle(&mut self, file: &'a stock::Vehicle) -> Result<Arc<Vehicle>, BuildError> {
        if let Some((_, vehicle)) =
            self.vehicles.iter().find(|(known, _)| std::ptr::eq(*known, file))
        {
            return Ok(Arc::clone(vehicle));
        }
        let vehicle = Arc::new(Vehicle::new(file).map_err(|source| table_error(file, source))?);
        self.vehicles.push((file, Arc::clone(&vehicle)));
        Ok(vehicle)
    }

    /// The gears of a vehicle and of the one behind it.
    pub fn gears(
        &mut self,
        [front, rear]: [(&stock::Vehicle, &'a stock::DraftGear); 2],
    ) -> Result<Arc<GearPair>, BuildError> {
        let same =
            |[a, b]: &[&stock::DraftGear; 2]| std::ptr::eq(*a, front.1) && std::ptr::eq(*b, rear.1);
        if let Some((_, gears)) = self.gears.iter().find(|(known, _)| same(known)) {
            return Ok(Arc::clone(gears));
        }
        let gear =
            |(vehicle, gear)| DraftGear::new(gear).map_err(|source| table_error(vehicle, source));
        let gears = Arc::new(GearPair::new(&gear(front)?, &gear(rear)?));
        self.gears.push(([front.1, rear.1], Arc::clone(&gears)));
        Ok(gears)
    }
}

fn table_error(vehicle: &stock::Vehicle, source: TableError) -> BuildError {
    BuildError::Table { vehicle: vehicle.name.clone(), source }
}
