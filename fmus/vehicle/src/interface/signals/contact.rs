//! The FMU's variables of a contact, and of all contacts of a wheel together.

use contact::Creepages;
use fmu::{Declaration, Reals, Values, unit};

use crate::contact::ContactOutput;

/// Handles of a contact, in the order in which they are declared.
#[derive(Debug)]
pub(super) struct ContactSignals {
    all: Reals<11>,
}

/// Place of the normal force among them.
const NORMAL: usize = 5;

impl ContactSignals {
    /// Declares the contact with this `name`, such as `wheelset[1].left`; `whose` tells in the
    /// descriptions which it is.
    pub fn declare(d: &mut Declaration, name: &str, whose: &str) -> Self {
        let mut output = |quantity: &str, unit, description: &str| {
            d.real(format!("{name}.{quantity}"), unit, format!("{description}, {whose}")).output()
        };
        let all = Reals::new([
            output("creepage.longitudinal", unit::ONE, "Longitudinal creepage, traction positive"),
            output(
                "creepage.lateral",
                unit::ONE,
                "Lateral creepage, wheel slipping right positive",
            ),
            output("creepage.spin", unit::PER_METRE, "Spin creepage, positive about z down"),
            output(
                "force.longitudinal",
                unit::NEWTON,
                "Creep force on the wheel along the track, traction positive",
            ),
            output(
                "force.lateral",
                unit::NEWTON,
                "Creep force on the wheel in the contact plane, positive to the right",
            ),
            output("force.normal", unit::NEWTON, "Normal force"),
            output("friction_power", unit::WATT, "Power turned into heat by creep"),
            output("contact.a", unit::METRE, "Semi-axis of the contact in rolling direction"),
            output("contact.b", unit::METRE, "Semi-axis of the contact across"),
            output(
                "contact.lateral_position",
                unit::METRE,
                "Contact on the rail head from its top, negative towards the gauge side",
            ),
            output("contact.angle", unit::RADIAN, "Contact angle, positive as on a tread"),
        ]);
        Self { all }
    }

    /// Whether a contact is shown.
    pub fn shows_one(&self, values: &Values) -> bool {
        values[self.all][NORMAL] != 0.0
    }

    /// Shows the contact.
    pub fn write(&self, contact: &ContactOutput, values: &mut Values) {
        let Creepages { longitudinal, lateral, spin } = contact.creepages;
        values[self.all] = [
            longitudinal,
            lateral,
            spin,
            contact.force.longitudinal,
            contact.force.lateral,
            contact.normal,
            contact.friction_power,
            contact.a,
            contact.b,
            contact.rail_lateral,
            contact.angle,
        ];
    }
}
