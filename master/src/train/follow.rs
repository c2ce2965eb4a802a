//! Which vehicles follow the train if their FMUs fail, and how they know its motion.

use super::following::{Following, MOTION};
use super::layout::{Layout, VehicleHolder};
use super::roles::Names;
use super::roles::tables::TRAIN_OUTPUT;
use super::roles::variable::{find, named};
use crate::system::structure::{Connection, Endpoint, Home, Sampling, Structure};
use crate::system::unit::Unit;

/// The vehicles that follow the train if their FMUs fail: those that the scenario wants to, if they have
/// processes of their own.
fn followers<'a>(
    layout: &'a Layout,
    structure: &'a Structure,
) -> impl Iterator<Item = (usize, &'a VehicleHolder)> {
    let is_separate = |holder: &VehicleHolder| {
        let own = structure.components.iter().find(|own| own.name == holder.component);
        own.is_some_and(|own| own.schedule.home == Home::OwnProcess)
    };
    (1..).zip(&layout.vehicles).filter(move |(_, holder)| holder.follows && is_separate(holder))
}

/// Lets the vehicles that may have to follow the train know its motion; `units` are all components.
pub fn connect(layout: &Layout, structure: &mut Structure, units: &[Box<dyn Unit>]) {
    let mut connections = vec![];
    let Some(train) = units.iter().find(|unit| unit.name() == layout.train) else { return };
    for (number, holder) in followers(layout, structure) {
        for (ours, own) in MOTION {
            let variable = named(TRAIN_OUTPUT, ours);
            let prefix = format!("vehicle[{number}].");
            let found = find(train.interface(), &prefix, variable, "output", &Names::new());
            let Some((name, to_si)) = found.ok().flatten() else { continue };
            let (from, to) =
                (Endpoint::new(&layout.train, &name), Endpoint::new(&holder.component, own));
            connections.push(Connection::of(from, to, to_si, Sampling::Last));
        }
    }
    structure.connections.extend(connections);
}

/// The unit of a component, which follows the train after a failure if it is a vehicle that shall.
pub fn following(layout: &Layout, structure: &Structure, unit: Box<dyn Unit>) -> Box<dyn Unit> {
    let mut followers = followers(layout, structure);
    match followers.find(|(_, holder)| holder.component == unit.name()) {
        Some((_, holder)) => Box::new(Following::new(unit, holder)),
        None => unit,
    }
}
