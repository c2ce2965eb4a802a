//! Outputs of the train for each vehicle, `vehicle[i].…`.

use super::unit::{METRE, METRE_PER_SECOND, NEWTON, WATT};
use crate::system::port::SignalUnit;

/// Places of a vehicle's outputs in its block.
pub const POSITION: usize = 0;
/// Speed.
pub const VELOCITY: usize = 1;
/// Force of the front coupler, tension positive.
pub const COUPLER_FRONT: usize = 2;
/// Force of the rear coupler, tension positive.
pub const COUPLER_REAR: usize = 3;
/// Propulsion resistance, negative when moving forward.
pub const RESISTANCE: usize = 4;
/// Traction at the wheel rims, negative: dynamic brake.
pub const TRACTION: usize = 5;
/// Friction brake at the treads.
pub const BRAKE: usize = 6;
/// Heat of the friction brake into each wheel.
pub const WHEEL_BRAKE_POWER: usize = 7;
/// Names after `vehicle[i].`; the first four are required.
pub const NAMES: [&str; 8] = [
    "position",
    "velocity",
    "coupler.front.force",
    "coupler.rear.force",
    "resistance.force",
    "traction.force",
    "brake.force",
    "wheel.brake_power",
];
/// How many of the names are required.
pub const REQUIRED: usize = 4;
/// Their units.
pub(super) const UNITS: [SignalUnit; NAMES.len()] =
    [METRE, METRE_PER_SECOND, NEWTON, NEWTON, NEWTON, NEWTON, NEWTON, WATT];
