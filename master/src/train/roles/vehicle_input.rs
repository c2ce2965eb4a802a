//! Inputs of a vehicle.

use super::unit::NEWTON;
use crate::system::port::SignalUnit;

/// Force of the front coupler, tension positive.
pub const COUPLER_FRONT: usize = 0;
/// Force of the rear coupler, tension positive.
pub const COUPLER_REAR: usize = 1;
/// Force of the synchronisation controller.
pub const SYNCHRONISATION: usize = 2;
/// Propulsion resistance.
pub const RESISTANCE: usize = 3;
/// Traction at the wheel rims.
pub const TRACTION: usize = 4;
/// Friction brake at the treads.
pub const BRAKE: usize = 5;
/// Names; the first three are required.
pub const NAMES: [&str; 6] = [
    "coupler.front.force",
    "coupler.rear.force",
    "sync.force",
    "resistance.force",
    "traction.force",
    "brake.force",
];
/// How many of the names are required.
pub const REQUIRED: usize = 3;
/// Their units: all are forces.
pub(super) const UNITS: [SignalUnit; NAMES.len()] = [NEWTON; NAMES.len()];
