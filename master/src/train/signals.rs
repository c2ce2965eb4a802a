//! The signals of a train by their names in the roles.

use super::layout::{Layout, VehicleHolder};
use super::roles::Names;
use super::roles::tables::{SIDES, TRAIN_OUTPUT, VEHICLE_INPUT, VEHICLE_OUTPUT, WHEEL, WHEELSET};
use super::roles::variable::{RoleVariable, find, named};
use crate::system::step::System;
use crate::system::tap::Tap;

/// No other maker's names.
static OUR_NAMES: Names = Names::new();

impl Layout {
    /// What the train says of its vehicle with that number, from one.
    pub fn tap_train(&self, system: &mut System, number: usize, name: &str) -> Option<Tap> {
        let prefix = format!("vehicle[{number}].");
        let variable = named(TRAIN_OUTPUT, name);
        tap(system, &self.train, &prefix, variable, "output", &OUR_NAMES)
    }
}

impl VehicleHolder {
    /// An output of the vehicle.
    pub fn tap_output(&self, system: &mut System, name: &str) -> Option<Tap> {
        self.tap(system, "", named(VEHICLE_OUTPUT, name), "output")
    }

    /// An input of the vehicle.
    pub fn tap_input(&self, system: &mut System, name: &str) -> Option<Tap> {
        self.tap(system, "", named(VEHICLE_INPUT, name), "input")
    }

    /// Chainage of the wheelset with that number, from one.
    pub fn tap_wheelset(&self, system: &mut System, number: usize) -> Option<Tap> {
        let prefix = format!("wheelset[{number}].");
        self.tap(system, &prefix, named(WHEELSET, "position"), "output")
    }

    /// An output of a wheel on a side: 0 left, 1 right.
    pub fn tap_wheel(
        &self,
        system: &mut System,
        (wheelset, side): (usize, usize),
        name: &str,
    ) -> Option<Tap> {
        let prefix = format!("wheelset[{wheelset}].{}.", SIDES[side]);
        self.tap(system, &prefix, named(WHEEL, name), "output")
    }

    fn tap(
        &self,
        system: &mut System,
        behind: &str,
        variable: &RoleVariable,
        causality: &str,
    ) -> Option<Tap> {
        let prefix = format!("{}{behind}", self.prefix);
        tap(system, &self.component, &prefix, variable, causality, &self.names)
    }
}

/// A signal in the unit of the exchange.
fn tap(
    system: &mut System,
    component: &str,
    prefix: &str,
    variable: &RoleVariable,
    causality: &str,
    names: &Names,
) -> Option<Tap> {
    let interface = system.parts[system.number(component)?].unit.interface();
    let found = find(interface, prefix, variable, causality, names);
    let (name, conversion) = found.ok().flatten()?;
    Some(system.tap(component, &name)?.converted(conversion))
}
