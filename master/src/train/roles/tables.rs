//! The variables of each role: name, unit of the exchange, whether the role cannot do without, and
//! what a receiver that steps less often gets of them.

use super::variable::RoleVariable;
use crate::interface::si::{Dimension, SignalUnit};

const fn unit(symbol: &'static str, kg: i32, m: i32, s: i32) -> SignalUnit {
    SignalUnit { symbol, dimension: Dimension::mechanical(kg, m, s) }
}

const ONE: SignalUnit = unit("1", 0, 0, 0);
const METRE: SignalUnit = unit("m", 0, 1, 0);
const PER_METRE: SignalUnit = unit("1/m", 0, -1, 0);
const METRE_PER_SECOND: SignalUnit = unit("m/s", 0, 1, -1);
const METRE_PER_SECOND_SQUARED: SignalUnit = unit("m/s2", 0, 1, -2);
const NEWTON: SignalUnit = unit("N", 1, 1, -2);
const WATT: SignalUnit = unit("W", 1, 2, -3);

const fn required(name: &'static str, unit: SignalUnit) -> RoleVariable {
    RoleVariable::new(name, unit, true)
}

const fn optional(name: &'static str, unit: SignalUnit) -> RoleVariable {
    RoleVariable::new(name, unit, false)
}

/// The names of the two sides of the track, seen in the running direction.
pub const SIDES: [&str; 2] = ["left", "right"];

/// Start values that train and vehicles share.
pub const START: &[RoleVariable] =
    &[required("initial.position", METRE), required("initial.velocity", METRE_PER_SECOND)];

/// What the train gives of each vehicle, `vehicle[i].…`. Coupler forces are positive in tension,
/// resistance is negative when moving forward, negative traction is the dynamic brake;
/// `wheel.brake_power` is the heat of the friction brake into each wheel.
pub const TRAIN_OUTPUT: &[RoleVariable] = &[
    required("position", METRE),
    required("velocity", METRE_PER_SECOND),
    required("coupler.front.force", NEWTON),
    required("coupler.rear.force", NEWTON),
    optional("resistance.force", NEWTON),
    optional("traction.force", NEWTON),
    optional("brake.force", NEWTON),
    optional("wheel.brake_power", WATT),
];

/// What a vehicle takes.
pub const VEHICLE_INPUT: &[RoleVariable] = &[
    required("coupler.front.force", NEWTON),
    required("coupler.rear.force", NEWTON),
    required("sync.force", NEWTON),
    optional("resistance.force", NEWTON),
    optional("traction.force", NEWTON),
    optional("brake.force", NEWTON),
];

/// What a vehicle gives; its position is the chainage of its middle.
pub const VEHICLE_OUTPUT: &[RoleVariable] = &[
    required("position", METRE),
    required("velocity", METRE_PER_SECOND),
    optional("acceleration", METRE_PER_SECOND_SQUARED),
];

/// What a vehicle gives of each wheelset, `wheelset[j].…`.
pub const WHEELSET: &[RoleVariable] = &[optional("position", METRE)];

/// What a vehicle gives of each wheel, `wheelset[j].left.…`.
pub const WHEEL: &[RoleVariable] = &[
    optional("creepage.longitudinal", ONE),
    optional("creepage.lateral", ONE),
    optional("creepage.spin", PER_METRE),
    optional("force.longitudinal", NEWTON),
    optional("force.lateral", NEWTON),
    optional("force.normal", NEWTON),
    optional("friction_power", WATT),
    optional("contact.a", METRE),
    optional("contact.b", METRE),
    optional("contact.lateral_position", METRE),
];

/// What a rail takes of each wheelset, `vehicle[i].wheelset[j].…`. A rail that steps less often gets
/// means, so that no energy is lost, and the last position.
pub const RAIL_INPUT: &[RoleVariable] = &[
    required("position", METRE).last(),
    required("speed", METRE_PER_SECOND),
    optional("creepage.longitudinal", ONE),
    optional("force.normal", NEWTON),
    optional("friction_power", WATT),
    optional("contact.a", METRE),
    optional("contact.b", METRE),
    optional("contact.lateral_position", METRE),
    optional("brake_power", WATT),
];

/// What a vehicle's controller takes: the motions of the vehicle and of the vehicle in the train.
pub const CONTROLLER_INPUT: &[RoleVariable] = &[
    required("vehicle.position", METRE),
    required("vehicle.velocity", METRE_PER_SECOND),
    required("train.position", METRE),
    required("train.velocity", METRE_PER_SECOND),
];

/// What a vehicle's controller gives.
pub const CONTROLLER_OUTPUT: &[RoleVariable] = &[required("sync.force", NEWTON)];
