//! Outputs of a vehicle: those of the vehicle, then a block for each wheelset.

use super::unit::{
    METRE, METRE_PER_SECOND, METRE_PER_SECOND_SQUARED, NEWTON, ONE, PER_METRE, WATT,
};
use crate::system::port::SignalUnit;

/// Chainage of the vehicle's middle.
pub const POSITION: usize = 0;
/// Speed.
pub const VELOCITY: usize = 1;
/// Names; the first two are required.
pub const NAMES: [&str; 3] = ["position", "velocity", "acceleration"];
/// How many of the names are required.
pub const REQUIRED: usize = 2;
/// Their units.
pub(super) const UNITS: [SignalUnit; NAMES.len()] =
    [METRE, METRE_PER_SECOND, METRE_PER_SECOND_SQUARED];

/// Names of a wheel's outputs after `wheelset[j].left.`, all optional.
pub const WHEEL_NAMES: [&str; 10] = [
    "creepage.longitudinal",
    "creepage.lateral",
    "creepage.spin",
    "force.longitudinal",
    "force.lateral",
    "force.normal",
    "friction_power",
    "contact.a",
    "contact.b",
    "contact.lateral_position",
];
/// Their units.
pub(super) const WHEEL_UNITS: [SignalUnit; WHEEL_NAMES.len()] =
    [ONE, ONE, PER_METRE, NEWTON, NEWTON, NEWTON, WATT, METRE, METRE, METRE];
/// Place of a wheel's longitudinal creep force in its block.
pub const FORCE_LONGITUDINAL: usize = 3;
/// Place of a wheel's friction power in its block.
pub const FRICTION_POWER: usize = 6;
/// Length of a wheelset's block: its position and two wheels.
pub const WHEELSET_BLOCK: usize = 1 + 2 * WHEEL_NAMES.len();

/// Where wheelset `j`'s block begins, counted from zero; its position comes first.
pub const fn wheelset(j: usize) -> usize {
    NAMES.len() + j * WHEELSET_BLOCK
}

/// Where the block of a wheel begins: `side` 0 is left, 1 is right.
pub const fn wheel(j: usize, side: usize) -> usize {
    wheelset(j) + 1 + side * WHEEL_NAMES.len()
}
