//! Inputs of the rail for each wheelset, `vehicle[i].wheelset[j].…`.

use super::unit::{METRE, METRE_PER_SECOND, NEWTON, ONE, WATT};
use crate::system::port::SignalUnit;

/// Place of the wheelset's chainage in its block; only it and the speed are required.
pub const POSITION: usize = 0;
/// Place of the wheelset's speed.
pub const SPEED: usize = 1;
/// Place of the heat that the friction brake puts into the wheel, which the train tells.
pub const BRAKE_POWER: usize = 8;
/// Names after `vehicle[i].wheelset[j].`; from the third to the last but one they are those of
/// the wheel.
pub const NAMES: [&str; 9] = [
    "position",
    "speed",
    "creepage.longitudinal",
    "force.normal",
    "friction_power",
    "contact.a",
    "contact.b",
    "contact.lateral_position",
    "brake_power",
];
/// Places in a wheel's output block from which the third and later inputs are taken.
pub const FROM_WHEEL: [usize; 6] = [0, 5, 6, 7, 8, 9];
/// How many of the names are required.
pub const REQUIRED: usize = 2;
/// Their units.
pub(super) const UNITS: [SignalUnit; NAMES.len()] =
    [METRE, METRE_PER_SECOND, ONE, NEWTON, WATT, METRE, METRE, METRE, WATT];
