//! Where the energy comes from and where it goes.
//!
//! Each step multiplies every force by the mean of the velocities before and after it, which is
//! exactly its share in the change of the kinetic energy.

use serde::{Deserialize, Serialize};

/// Work and heat since the start, J.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Account {
    /// Work of both couplers on the vehicle.
    pub couplers: f64,
    /// Work of the drives.
    pub traction: f64,
    /// Work of the resistance, negative as a rule.
    pub resistance: f64,
    /// Work of the synchronising force.
    pub synchronisation: f64,
    /// Heat in the friction brake.
    pub brake_heat: f64,
    /// Heat in springs' damping and dampers.
    pub suspension_heat: f64,
    /// Friction heat of all contacts.
    pub friction_heat: f64,
    /// Heat in the normal damping of the contacts.
    pub contact_heat: f64,
    /// Heat in the support of the rails.
    pub track_heat: f64,
    /// Work of the irregularities, which move the rails under the wheels.
    pub irregularities: f64,
}

impl Account {
    /// Work of all inputs, J.
    pub fn work(&self) -> f64 {
        self.couplers + self.traction + self.resistance + self.synchronisation + self.irregularities
    }

    /// All heat, J.
    pub fn heat(&self) -> f64 {
        self.brake_heat
            + self.suspension_heat
            + self.friction_heat
            + self.contact_heat
            + self.track_heat
    }
}

/// Energy that the vehicle holds, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stored {
    /// Motion.
    pub kinetic: f64,
    /// Springs and contacts, against the unloaded contact and the springs' static load.
    pub elastic: f64,
    /// Height.
    pub gravity: f64,
}

impl Stored {
    /// All of it, J.
    pub fn sum(&self) -> f64 {
        self.kinetic + self.elastic + self.gravity
    }
}
