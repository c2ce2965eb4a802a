//! Where the energy comes from and where it goes.
//!
//! Each step multiplies every force by the mean of the velocities before and after it, which is
//! exactly its share in the change of the kinetic energy.

use serde::{Deserialize, Serialize};

fmu::variables! {
    /// Energy that the vehicle holds, J.
    #[derive(Copy, Default)]
    pub struct Stored: output {
        /// Kinetic energy
        kinetic: "kinetic", JOULE;
        /// Elastic energy of suspension and contacts.
        ///
        /// Against the unloaded contact and the springs' static load.
        elastic: "elastic", JOULE;
        /// Energy of height
        gravity: "gravity", JOULE;
    }

    /// Work and heat since the start, J.
    #[derive(Copy, Default, Serialize, Deserialize)]
    pub struct Account: output {
        /// Work of both couplers since the start
        couplers: "work.couplers", JOULE;
        /// Work of the drives since the start
        traction: "work.traction", JOULE;
        /// Work of the resistance since the start.
        ///
        /// Negative as a rule.
        resistance: "work.resistance", JOULE;
        /// Work of the synchronising force since the start
        synchronisation: "work.sync", JOULE;
        /// Heat in the friction brake since the start
        brake_heat: "heat.brake", JOULE;
        /// Heat in the suspension since the start
        suspension_heat: "heat.suspension", JOULE;
        /// Heat by creep since the start
        friction_heat: "heat.friction", JOULE;
        /// Heat in the contacts' damping since the start
        contact_heat: "heat.contact", JOULE;
        /// Heat in the support of the rails since the start
        track_heat: "heat.track", JOULE;
        /// Work of the irregularities, which move the rails, since the start
        irregularities: "work.irregularities", JOULE;
    }
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

impl Stored {
    /// All of it, J.
    pub fn sum(&self) -> f64 {
        self.kinetic + self.elastic + self.gravity
    }
}
