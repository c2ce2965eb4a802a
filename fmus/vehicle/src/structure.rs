//! What a vehicle is: bodies, wheelsets and elements by index, constant in a run.

use std::sync::Arc;

use contact::{CreepLaw, GeometryTable};
use nalgebra::Vector3;

use crate::body::RigidBody;
use crate::contact::WheelData;
use crate::contact::slip_mobility::SlipMobility;
use crate::suspension::Suspension;

/// What a vehicle is: everything that does not change in a run, except the friction coefficient.
#[derive(Clone, Debug)]
pub struct Structure {
    /// Car body, bogie frames, then wheelsets.
    pub bodies: Vec<RigidBody>,
    /// Wheelsets from front to rear.
    pub wheelsets: Vec<WheelsetData>,
    /// Force elements.
    pub suspension: Suspension,
    /// Creep law.
    pub creep: CreepLaw,
    /// Greatest natural circular frequency, rad/s, with all friction sticking.
    pub highest_frequency: f64,
    /// Couplers' arms from the first body's centre of mass: front, rear, m.
    pub couplers: [Vector3<f64>; 2],
}

/// A wheelset with its two wheels and its drive.
#[derive(Clone, Debug)]
pub struct WheelsetData {
    /// Index of its body.
    pub body: usize,
    /// Index of the body on which drive and brake react.
    pub frame: usize,
    /// Its wheels.
    pub wheel: WheelData,
    /// How easily creep moves its contacts.
    pub slip_mobility: SlipMobility,
    /// Contact geometry of its left and its right wheel on their rails.
    pub tables: [Arc<GeometryTable>; 2],
    /// Vertical load of each of its wheels at rest on straight level track, N.
    pub static_wheel_load: f64,
    /// Share of the vehicle's traction force.
    pub traction_share: f64,
    /// Share of the vehicle's brake force.
    pub brake_share: f64,
}

impl Structure {
    /// Sum of all masses, kg.
    pub fn mass(&self) -> f64 {
        self.bodies.iter().map(|body| body.mass).sum()
    }
}
