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

/// A chainage: in all of a railway, and no faster than any train.
const fn chainage(variable: RoleVariable) -> RoleVariable {
    variable.within(-1e8, 1e8).slower_than(300.0)
}

/// A speed: of any train, and no faster changed than by 20 g, in which couplers break.
const fn speed(variable: RoleVariable) -> RoleVariable {
    variable.within(-200.0, 200.0).slower_than(200.0)
}

/// A force: ten times what the heaviest trains have at a coupler, N.
const fn force(variable: RoleVariable) -> RoleVariable {
    variable.within(-1e8, 1e8)
}

/// A power that is lost to friction: never won, and a hundred times that of a locomotive at one wheel, W.
const fn lost(variable: RoleVariable) -> RoleVariable {
    variable.within(0.0, 1e8)
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
    chainage(required("position", METRE)),
    speed(required("velocity", METRE_PER_SECOND)),
    force(required("coupler.front.force", NEWTON)),
    force(required("coupler.rear.force", NEWTON)),
    force(optional("resistance.force", NEWTON)),
    force(optional("traction.force", NEWTON)),
    force(optional("brake.force", NEWTON)),
    lost(optional("wheel.brake_power", WATT)),
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
    chainage(required("position", METRE)),
    speed(required("velocity", METRE_PER_SECOND)),
    optional("acceleration", METRE_PER_SECOND_SQUARED).within(-1e4, 1e4),
];

/// What a vehicle gives of each wheelset, `wheelset[j].…`.
pub const WHEELSET: &[RoleVariable] = &[chainage(optional("position", METRE))];

/// What a vehicle gives of each wheel, `wheelset[j].left.…`.
pub const WHEEL: &[RoleVariable] = &[
    optional("creepage.longitudinal", ONE),
    optional("creepage.lateral", ONE),
    optional("creepage.spin", PER_METRE),
    force(optional("force.longitudinal", NEWTON)),
    force(optional("force.lateral", NEWTON)),
    optional("force.normal", NEWTON).within(0.0, 1e8),
    lost(optional("friction_power", WATT)),
    optional("contact.a", METRE).within(0.0, 1.0),
    optional("contact.b", METRE).within(0.0, 1.0),
    optional("contact.flash_factor", ONE).within(0.0, 1e4),
    optional("contact.lateral_position", METRE).within(-10.0, 10.0),
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
    optional("contact.flash_factor", ONE),
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
