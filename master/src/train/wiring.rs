//! The wiring of a train: ONE table of what flows between train, controllers, vehicles and rails.
//! The run, the exported package and `hotfoot wiring` all come from it.

use std::collections::HashMap;

use super::layout::{Layout, RailHolder, VehicleHolder};
use super::roles::Names;
use super::roles::tables::{
    CONTROLLER_INPUT, CONTROLLER_OUTPUT, RAIL_INPUT, SIDES, TRAIN_OUTPUT, VEHICLE_INPUT,
    VEHICLE_OUTPUT, WHEEL, WHEELSET,
};
use super::roles::variable::{RoleVariable, find, named};
use crate::interface::Interface;
use crate::interface::si::Linear;
use crate::system::structure::{Connection, Endpoint};

/// What gives and takes in a train, for vehicle i with its wheelsets j.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Of {
    /// The train, `vehicle[i].…`.
    Train,
    /// The controller of vehicle i.
    Controller,
    /// Vehicle i.
    Vehicle,
    /// Its wheelset j, `wheelset[j].…`.
    Wheelset,
    /// Of that the wheel that runs on the rail, `wheelset[j].left.…`.
    Wheel,
    /// A rail, `vehicle[i].wheelset[j].…`.
    Rail,
}

/// Who gives what to whom, which takes it as what.
const WIRING: &[(Of, &str, Of, &str)] = &[
    (Of::Train, "coupler.front.force", Of::Vehicle, "coupler.front.force"),
    (Of::Train, "coupler.rear.force", Of::Vehicle, "coupler.rear.force"),
    (Of::Train, "resistance.force", Of::Vehicle, "resistance.force"),
    (Of::Train, "traction.force", Of::Vehicle, "traction.force"),
    (Of::Train, "brake.force", Of::Vehicle, "brake.force"),
    (Of::Controller, "sync.force", Of::Vehicle, "sync.force"),
    (Of::Vehicle, "position", Of::Controller, "vehicle.position"),
    (Of::Vehicle, "velocity", Of::Controller, "vehicle.velocity"),
    (Of::Train, "position", Of::Controller, "train.position"),
    (Of::Train, "velocity", Of::Controller, "train.velocity"),
    (Of::Wheelset, "position", Of::Rail, "position"),
    (Of::Vehicle, "velocity", Of::Rail, "speed"),
    (Of::Wheel, "creepage.longitudinal", Of::Rail, "creepage.longitudinal"),
    (Of::Wheel, "force.normal", Of::Rail, "force.normal"),
    (Of::Wheel, "friction_power", Of::Rail, "friction_power"),
    (Of::Wheel, "contact.a", Of::Rail, "contact.a"),
    (Of::Wheel, "contact.b", Of::Rail, "contact.b"),
    (Of::Wheel, "contact.flash_factor", Of::Rail, "contact.flash_factor"),
    (Of::Wheel, "contact.lateral_position", Of::Rail, "contact.lateral_position"),
    (Of::Train, "wheel.brake_power", Of::Rail, "brake_power"),
];

impl Of {
    /// The variables that it gives.
    const fn outputs(self) -> &'static [RoleVariable] {
        match self {
            Self::Train => TRAIN_OUTPUT,
            Self::Controller => CONTROLLER_OUTPUT,
            Self::Vehicle => VEHICLE_OUTPUT,
            Self::Wheelset => WHEELSET,
            Self::Wheel => WHEEL,
            Self::Rail => &[],
        }
    }

    /// The variables that it takes.
    const fn inputs(self) -> &'static [RoleVariable] {
        match self {
            Self::Controller => CONTROLLER_INPUT,
            Self::Vehicle => VEHICLE_INPUT,
            Self::Rail => RAIL_INPUT,
            Self::Train | Self::Wheelset | Self::Wheel => &[],
        }
    }
}

/// Component, prefix of its variables, and its maker's names for ours.
type Holder<'h> = (&'h str, String, &'h Names);

/// A vehicle, its number from one, and if a rail takes: that rail and the wheelset's number from one.
struct Instance<'l> {
    layout: &'l Layout,
    number: usize,
    vehicle: &'l VehicleHolder,
    rail: Option<(&'l RailHolder, usize)>,
}

/// No maker's names.
static OURS: Names = Names::new();

impl Instance<'_> {
    fn holder(&self, of: Of) -> Option<Holder<'_>> {
        let Self { layout, number, vehicle, rail } = self;
        let VehicleHolder { component, prefix, names, controller, .. } = vehicle;
        Some(match (of, rail) {
            (Of::Train, _) => (&layout.train, format!("vehicle[{number}]."), &OURS),
            (Of::Controller, _) => (controller, String::new(), &OURS),
            (Of::Vehicle, _) => (component, prefix.clone(), names),
            (Of::Wheelset, Some((_, j))) => (component, format!("{prefix}wheelset[{j}]."), names),
            (Of::Wheel, Some((rail, j))) => {
                (component, format!("{prefix}wheelset[{j}].{}.", SIDES[rail.side]), names)
            }
            (Of::Rail, Some((rail, j))) => {
                (&rail.component, format!("vehicle[{number}].wheelset[{j}]."), &OURS)
            }
            (Of::Wheelset | Of::Wheel | Of::Rail, None) => return None,
        })
    }
}

/// All connections of a train; `interfaces` are those of its components by name. Variables that an
/// FMU need not have and lacks are not connected.
pub fn connections(layout: &Layout, interfaces: &HashMap<&str, &Interface>) -> Vec<Connection> {
    let mut connections = vec![];
    let mut connect = |instance: &Instance<'_>, to_rail: bool| {
        let rows = WIRING.iter().filter(|(_, _, to, _)| (*to == Of::Rail) == to_rail);
        for &(from, output, to, input) in rows {
            let (output, input) = (named(from.outputs(), output), named(to.inputs(), input));
            let end = |of, variable: &RoleVariable, causality| -> Option<(Endpoint, Linear)> {
                let (component, prefix, names) = instance.holder(of)?;
                let interface = interfaces.get(component)?;
                let found = find(interface, &prefix, variable, causality, names);
                let (name, conversion) = found.ok().flatten()?;
                Some((Endpoint::new(component, &name), conversion))
            };
            let ends = (end(from, output, "output"), end(to, input, "input"));
            if let (Some((from, to_si)), Some((to, of_input))) = ends {
                let conversion = to_si.then(of_input.inverse());
                connections.push(Connection::of(from, to, conversion, input.sampling));
            }
        }
    };
    let vehicles = || (1..).zip(&layout.vehicles);
    for (number, vehicle) in vehicles() {
        connect(&Instance { layout, number, vehicle, rail: None }, false);
    }
    for rail in &layout.rails {
        for (number, vehicle) in vehicles() {
            for j in 1..=vehicle.wheelsets {
                connect(&Instance { layout, number, vehicle, rail: Some((rail, j)) }, true);
            }
        }
    }
    connections
}
