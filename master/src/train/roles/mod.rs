//! The three roles of a run, and the signals that an FMU must or may have to fill one: the order
//! of the names is the order of the exchange.
//!
//! | file | part |
//! |---|---|
//! | `train.rs` | what the train gives for each vehicle |
//! | `vehicle_input.rs`, `vehicle_output.rs` | what a vehicle takes and gives |
//! | `rail_input.rs` | what a rail takes of each wheelset |
//! | `unit.rs` | their units |

use std::collections::BTreeMap;

use crate::interface::Interface;
use crate::system::port::{Port, Signal, SignalUnit};

pub mod rail_input;
pub mod train;
mod unit;
pub mod vehicle_input;
pub mod vehicle_output;

/// The names of the two sides in the order of the exchange.
pub const SIDES: [&str; 2] = ["left", "right"];

/// What an FMU does in a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
