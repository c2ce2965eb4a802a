//! The roles of a run, and the variables that an FMU must or may have to fill one. Each is said once,
//! in a table, from which come the checks, the connections and what is recorded.
//!
//! | file | part |
//! |---|---|
//! | `tables.rs` | the variables of each role |
//! | `variable.rs` | a variable of a role in an FMU |
//! | `page.rs` | the page of the roles in `modelDescription/README.md` |

use crate::interface::Interface;

#[cfg(test)]
mod page;
pub mod tables;
pub mod variable;

pub use tables::SIDES;
pub use variable::{Names, RoleVariable, find};

use tables::{RAIL_INPUT, START, TRAIN_OUTPUT, VEHICLE_INPUT, VEHICLE_OUTPUT, WHEEL, WHEELSET};

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

impl Role {
    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Longitudinal => "longitudinal",
            Self::Vehicle => "vehicle",
            Self::Railheat => "railheat",
        }
    }
}

/// A table of variables under a prefix, with their causality.
pub type Group = (String, &'static [RoleVariable], &'static str);

/// The variables that an FMU must have to be a train of so many vehicles, or may have.
pub fn longitudinal(vehicles: usize) -> Vec<Group> {
    let outputs = |i| (format!("vehicle[{i}]."), TRAIN_OUTPUT, "output");
    let start = (String::new(), START, "parameter");
    std::iter::once(start).chain((1..=vehicles).map(outputs)).collect()
}

/// The same of a vehicle with so many wheelsets.
pub fn vehicle(wheelsets: usize) -> Vec<Group> {
    let mut groups = vec![
        (String::new(), START, "parameter"),
        (String::new(), VEHICLE_INPUT, "input"),
        (String::new(), VEHICLE_OUTPUT, "output"),
    ];
    for j in 1..=wheelsets {
        groups.push((format!("wheelset[{j}]."), WHEELSET, "output"));
        let wheel = |side| (format!("wheelset[{j}].{side}."), WHEEL, "output");
        groups.extend(SIDES.map(wheel));
    }
    groups
}

/// The same of a rail for vehicles with so many wheelsets each.
pub fn railheat(wheelsets: &[usize]) -> Vec<Group> {
    let of_vehicle = |(i, &count): (usize, &usize)| {
        (1..=count).map(move |j| (format!("vehicle[{i}].wheelset[{j}]."), RAIL_INPUT, "input"))
    };
    (1..).zip(wheelsets).flat_map(of_vehicle).collect()
}

/// What an interface lacks to fill a role, a sentence each.
pub fn missing(interface: &Interface, role: Role) -> Vec<String> {
    let groups = match role {
        Role::Longitudinal => longitudinal(interface.count("vehicle", "position").max(1)),
        Role::Vehicle => vehicle(wheelset_count(interface, &Names::new())),
        Role::Railheat => railheat(&rail_wheelsets(interface)),
    };
    problems(interface, &groups, &Names::new())
}

/// What an interface lacks of groups of variables under its own names, a sentence each.
pub fn problems(interface: &Interface, groups: &[Group], names: &Names) -> Vec<String> {
    let of_group = |(prefix, variables, causality): &Group| {
        let find = |variable| find(interface, prefix, variable, causality, names).err();
        variables.iter().filter_map(find).collect::<Vec<_>>()
    };
    groups.iter().flat_map(of_group).collect()
}

/// Number of wheelsets of a vehicle FMU with its `names` for ours.
pub fn wheelset_count(interface: &Interface, names: &Names) -> usize {
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
