//! The FMU's variables of a contact, and of all contacts of a wheel together.

use fmu::{Declaration, Real, Values, unit};

use crate::wheel_output::ContactOutput;

/// Handles of a contact.
#[derive(Debug)]
pub(super) struct ContactSignals {
    creepage: [Real; 3],
    longitudinal: Real,
    lateral: Real,
    normal: Real,
    friction_power: Real,
    a: Real,
    b: Real,
    rail_lateral: Real,
    angle: Real,
}

impl ContactSignals {
    /// Declares the contact with this `name`, such as `wheelset[1].left`; `whose` tells in the
    /// descriptions which it is.
    pub fn declare(d: &mut Declaration, name: &str, whose: &str) -> Self {
        let mut output = |quantity: &str, unit, description: &str| {
            d.real(format!("{name}.{quantity}"), unit, format!("{description}, {whose}")).output()
        };
        Self {
            creepage: [
                output(
                    "creepage.longitudinal",
                    unit::ONE,
                    "Longitudinal creepage, traction positive",
                ),
                output(
                    "creepage.lateral",
                    unit::ONE,
                    "Lateral creepage, wheel slipping right positive",
                ),
                output("creepage.spin", unit::PER_METRE, "Spin creepage, positive about z down"),
            ],
            longitudinal: output(
                "force.longitudinal",
                unit::NEWTON,
                "Creep force on the wheel along the track, traction positive",
            ),
            lateral: output(
                "force.lateral",
                unit::NEWTON,
                "Creep force on the wheel in the contact plane, positive to the right",
            ),
            normal: output("force.normal", unit::NEWTON, "Normal force"),
            friction_power: output("friction_power", unit::WATT, "Power turned into heat by creep"),
            a: output("contact.a", unit::METRE, "Semi-axis of the contact in rolling direction"),
            b: output("contact.b", unit::METRE, "Semi-axis of the contact across"),
            rail_lateral: output(
                "contact.lateral_position",
                unit::METRE,
                "Contact on the rail head from its top, negative towards the gauge side",
            ),
            angle: output("contact.angle", unit::RADIAN, "Contact angle, positive as on a tread"),
        }
    }

    /// Whether a contact is shown.
    pub fn shows_one(&self, values: &Values) -> bool {
        values[self.normal] != 0.0
    }

    /// Shows the contact.
    pub fn write(&self, contact: &ContactOutput, values: &mut Values) {
        values[self.creepage[0]] = contact.creepages.longitudinal;
        values[self.creepage[1]] = contact.creepages.lateral;
        values[self.creepage[2]] = contact.creepages.spin;
        values[self.longitudinal] = contact.longitudinal;
        values[self.lateral] = contact.lateral;
        values[self.normal] = contact.normal;
        values[self.friction_power] = contact.friction_power;
        values[self.a] = contact.a;
        values[self.b] = contact.b;
        values[self.rail_lateral] = contact.rail_lateral;
        values[self.angle] = contact.angle;
    }
}
