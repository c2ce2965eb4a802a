//! The three roles of a run, and the signals that an FMU must or may have to fill one: the order
//! of the names here is the order of the exchange.

use std::collections::BTreeMap;

use crate::interface::Interface;
use crate::port::{Port, Signal, SignalUnit};
use crate::si::Dimension;

/// Units of the exchange.
mod unit {
    use super::{Dimension, SignalUnit};

    const fn of(symbol: &'static str, kg: i32, m: i32, s: i32) -> SignalUnit {
        SignalUnit { symbol, dimension: Dimension::mechanical(kg, m, s) }
    }

    pub const ONE: SignalUnit = of("1", 0, 0, 0);
    pub const METRE: SignalUnit = of("m", 0, 1, 0);
    pub const PER_METRE: SignalUnit = of("1/m", 0, -1, 0);
    pub const METRE_PER_SECOND: SignalUnit = of("m/s", 0, 1, -1);
    pub const METRE_PER_SECOND_SQUARED: SignalUnit = of("m/s2", 0, 1, -2);
    pub const NEWTON: SignalUnit = of("N", 1, 1, -2);
    pub const WATT: SignalUnit = of("W", 1, 2, -3);
}

/// Outputs of the train for each vehicle, `vehicle[i].…`.
pub mod train {
    use super::SignalUnit;
    use super::unit::{METRE, METRE_PER_SECOND, NEWTON, WATT};

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
}

/// Inputs of a vehicle.
pub mod vehicle_input {
    use super::SignalUnit;
    use super::unit::NEWTON;

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
}

/// Outputs of a vehicle: those of the vehicle, then a block for each wheelset.
pub mod vehicle_output {
    use super::SignalUnit;
    use super::unit::{
        METRE, METRE_PER_SECOND, METRE_PER_SECOND_SQUARED, NEWTON, ONE, PER_METRE, WATT,
    };

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
}

/// The names of the two sides in the order of the exchange.
pub const SIDES: [&str; 2] = ["left", "right"];

/// Inputs of the rail for each wheelset, `vehicle[i].wheelset[j].…`.
pub mod rail_input {
    use super::SignalUnit;
    use super::unit::{METRE, METRE_PER_SECOND, NEWTON, ONE, WATT};

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
}

/// What an FMU does in a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Role {
    /// The train: one degree of freedom a vehicle.
    Longitudinal,
    /// One vehicle in three dimensions.
    Vehicle,
    /// One rail's temperature.
    Railheat,
}

/// Signals of a role by causality.
#[derive(Debug, Clone, Default)]
pub struct RoleSignals {
    /// Parameters.
    pub parameters: Vec<Signal>,
    /// Inputs.
    pub inputs: Vec<Signal>,
    /// Outputs.
    pub outputs: Vec<Signal>,
}

/// Names under a prefix with their units, the first `required` of them required.
fn signals(
    prefix: &str,
    names: &[&str],
    units: &[SignalUnit],
    required: usize,
) -> impl Iterator<Item = Signal> {
    names.iter().zip(units).enumerate().map(move |(i, (name, unit))| Signal {
        name: format!("{prefix}{name}"),
        required: i < required,
        unit: Some(*unit),
    })
}

/// Signals of a longitudinal FMU for a train of `vehicles`.
pub fn longitudinal_signals(vehicles: usize) -> RoleSignals {
    let block = |i| {
        let prefix = format!("vehicle[{i}].");
        signals(&prefix, &train::NAMES, &train::UNITS, train::REQUIRED).collect::<Vec<_>>()
    };
    RoleSignals {
        parameters: start_parameters(),
        inputs: vec![],
        outputs: (1..=vehicles).flat_map(block).collect(),
    }
}

/// Signals of a vehicle FMU with so many wheelsets.
pub fn vehicle_signals(wheelsets: usize) -> RoleSignals {
    use vehicle_output::{NAMES, REQUIRED, UNITS, WHEEL_NAMES, WHEEL_UNITS};
    let mut outputs: Vec<Signal> = signals("", &NAMES, &UNITS, REQUIRED).collect();
    for j in 1..=wheelsets {
        let position = Signal::optional(format!("wheelset[{j}].position"));
        outputs.push(position.in_unit(unit::METRE));
        for side in SIDES {
            let prefix = format!("wheelset[{j}].{side}.");
            outputs.extend(signals(&prefix, &WHEEL_NAMES, &WHEEL_UNITS, 0));
        }
    }
    RoleSignals {
        parameters: start_parameters(),
        inputs: {
            use vehicle_input::{NAMES, REQUIRED, UNITS};
            signals("", &NAMES, &UNITS, REQUIRED).collect()
        },
        outputs,
    }
}

/// Signals of a rail-heat FMU for vehicles with so many wheelsets each.
pub fn railheat_signals(wheelsets: &[usize]) -> RoleSignals {
    let mut inputs = vec![];
    for (i, &count) in wheelsets.iter().enumerate() {
        for j in 1..=count {
            let prefix = format!("vehicle[{}].wheelset[{j}].", i + 1);
            inputs.extend(signals(
                &prefix,
                &rail_input::NAMES,
                &rail_input::UNITS,
                rail_input::REQUIRED,
            ));
        }
    }
    RoleSignals { parameters: vec![], inputs, outputs: vec![] }
}

/// Parameters of a start: position and speed.
fn start_parameters() -> Vec<Signal> {
    vec![
        Signal::required("initial.position").in_unit(unit::METRE),
        Signal::required("initial.velocity").in_unit(unit::METRE_PER_SECOND),
    ]
}

/// What an interface lacks to fill a role, a sentence each.
pub fn missing(interface: &Interface, role: Role) -> Vec<String> {
    let wanted = match role {
        Role::Longitudinal => longitudinal_signals(interface.count("vehicle", "position").max(1)),
        Role::Vehicle => vehicle_signals(wheelset_count(interface, &BTreeMap::new())),
        Role::Railheat => railheat_signals(&rail_wheelsets(interface)),
    };
    let groups =
        [(&wanted.parameters, "parameter"), (&wanted.inputs, "input"), (&wanted.outputs, "output")];
    let connect = |(signals, causality): (&Vec<Signal>, &str)| {
        Port::connect(interface, signals, causality, &BTreeMap::new()).err().unwrap_or_default()
    };
    groups.into_iter().flat_map(connect).collect()
}

/// Number of wheelsets of a vehicle FMU with its `names` for our signals.
pub fn wheelset_count(interface: &Interface, names: &BTreeMap<String, String>) -> usize {
    let has = |j: &usize| {
        let name = format!("wheelset[{j}].position");
        interface.variable(names.get(&name).unwrap_or(&name)).is_some()
    };
    (1..).take_while(has).count()
}

/// Number of wheelsets of each vehicle of a rail-heat FMU; at least one vehicle with one.
fn rail_wheelsets(interface: &Interface) -> Vec<usize> {
    let count = |i: usize| interface.count(&format!("vehicle[{i}].wheelset"), "position");
    let counts: Vec<usize> = (1..).map(count).take_while(|&count| count > 0).collect();
    if counts.is_empty() { vec![1] } else { counts }
}
