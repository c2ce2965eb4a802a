//! The FMU's variables of one contact patch.

use fmu::{Declaration, Real, Values, unit};

use crate::wheel_output::PatchOutput;

/// Handles of a contact patch.
#[derive(Debug)]
pub(super) struct PatchSignals {
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

impl PatchSignals {
    /// Declares the patch `number`, counted from one, of the `wheel`, such as `wheelset[1].left`.
    pub fn declare(d: &mut Declaration, wheel: &str, number: usize) -> Self {
        let place = match number {
            1 => "the one nearest to the tread".into(),
            _ => format!("number {number} towards the flange"),
        };
        let mut output = |name: &str, unit, description: &str| {
            let name = format!("{wheel}.patch[{number}].{name}");
            d.real(name, unit, format!("{description}; of the contacts {place}")).output()
        };
        Self {
            creepage: [
                output("creepage.longitudinal", unit::ONE, "Longitudinal creepage"),
                output("creepage.lateral", unit::ONE, "Lateral creepage"),
                output("creepage.spin", unit::PER_METRE, "Spin creepage"),
            ],
            longitudinal: output(
                "force.longitudinal",
                unit::NEWTON,
                "Creep force on the wheel along the track",
            ),
            lateral: output(
                "force.lateral",
                unit::NEWTON,
                "Creep force on the wheel across, in the contact plane",
            ),
            normal: output("force.normal", unit::NEWTON, "Normal force"),
            friction_power: output("friction_power", unit::WATT, "Power turned into heat by creep"),
            a: output("contact.a", unit::METRE, "Semi-axis in rolling direction"),
            b: output("contact.b", unit::METRE, "Semi-axis across"),
            rail_lateral: output(
                "contact.lateral_position",
                unit::METRE,
                "Contact on the rail head from its top, negative towards the gauge side",
            ),
            angle: output("contact.angle", unit::RADIAN, "Contact angle, positive as on a tread"),
        }
    }

    /// Shows the patch; one that was not there and still is not costs nothing.
    pub fn write(&self, patch: &PatchOutput, values: &mut Values) {
        if patch.normal == 0.0 && values[self.normal] == 0.0 {
            return;
        }
        values[self.creepage[0]] = patch.creepages.longitudinal;
        values[self.creepage[1]] = patch.creepages.lateral;
        values[self.creepage[2]] = patch.creepages.spin;
        values[self.longitudinal] = patch.longitudinal;
        values[self.lateral] = patch.lateral;
        values[self.normal] = patch.normal;
        values[self.friction_power] = patch.friction_power;
        values[self.a] = patch.a;
        values[self.b] = patch.b;
        values[self.rail_lateral] = patch.rail_lateral;
        values[self.angle] = patch.angle;
    }
}
