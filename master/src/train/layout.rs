//! Who is what in a train's structure: for each vehicle the component that holds it, and the rails.

use super::roles::Names;
use super::roles::tables::SIDES;

/// The components of a train by their parts in it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Layout {
    /// Component of the train.
    pub train: String,
    /// Number of vehicles in the train.
    pub count: usize,
    /// Who holds each vehicle, from head to tail; none where the train runs alone.
    pub vehicles: Vec<VehicleHolder>,
    /// The heated rails.
    pub rails: Vec<RailHolder>,
}

/// Who holds a vehicle. A component may hold several, each under a prefix of its own.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct VehicleHolder {
    /// Component.
    pub component: String,
    /// What the names of the vehicle's variables in it begin with, such as `vehicle[2].`.
    pub prefix: String,
    /// Its maker's names for ours.
    pub names: Names,
    /// Number of wheelsets.
    pub wheelsets: usize,
    /// Whether it follows the motion of the train if its FMU fails in a process of its own.
    pub follows: bool,
    /// Component of its controller.
    pub controller: String,
}

/// A heated rail.
#[derive(Debug, Clone, PartialEq)]
pub struct RailHolder {
    /// Component.
    pub component: String,
    /// Which wheel of a wheelset runs on it: 0 left, 1 right.
    pub side: usize,
}

impl RailHolder {
    /// `left` or `right`.
    pub fn side_name(&self) -> &'static str {
        SIDES[self.side]
    }
}
