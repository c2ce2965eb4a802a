//! The energy account.

use fmu::{Declaration, Real, Values, unit};

use crate::energy::{Account, Stored};

/// Handles of the energy account.
#[derive(Debug)]
pub(super) struct EnergySignals {
    kinetic: Real,
    elastic: Real,
    gravity: Real,
    couplers: Real,
    traction: Real,
    resistance: Real,
    synchronisation: Real,
    brake_heat: Real,
    suspension_heat: Real,
    friction_heat: Real,
    contact_heat: Real,
    track_heat: Real,
    irregularities: Real,
}

impl EnergySignals {
    pub fn declare(d: &mut Declaration) -> Self {
        let mut output = |name: &str, description: &str| {
            d.real(format!("energy.{name}"), unit::JOULE, description).output()
        };
        Self {
            kinetic: output("kinetic", "Kinetic energy"),
            elastic: output("elastic", "Elastic energy of suspension and contacts"),
            gravity: output("gravity", "Energy of height"),
            couplers: output("work.couplers", "Work of both couplers since the start"),
            traction: output("work.traction", "Work of the drives since the start"),
            resistance: output("work.resistance", "Work of the resistance since the start"),
            synchronisation: output("work.sync", "Work of the synchronising force since the start"),
            brake_heat: output("heat.brake", "Heat in the friction brake since the start"),
            suspension_heat: output("heat.suspension", "Heat in the suspension since the start"),
            friction_heat: output("heat.friction", "Heat by creep since the start"),
            contact_heat: output("heat.contact", "Heat in the contacts' damping since the start"),
            track_heat: output("heat.track", "Heat in the support of the rails since the start"),
            irregularities: output(
                "work.irregularities",
                "Work of the irregularities, which move the rails, since the start",
            ),
        }
    }

    /// Shows the account.
    pub fn write(&self, stored: &Stored, account: &Account, values: &mut Values) {
        values[self.kinetic] = stored.kinetic;
        values[self.elastic] = stored.elastic;
        values[self.gravity] = stored.gravity;
        values[self.couplers] = account.couplers;
        values[self.traction] = account.traction;
        values[self.resistance] = account.resistance;
        values[self.synchronisation] = account.synchronisation;
        values[self.brake_heat] = account.brake_heat;
        values[self.suspension_heat] = account.suspension_heat;
        values[self.friction_heat] = account.friction_heat;
        values[self.contact_heat] = account.contact_heat;
        values[self.track_heat] = account.track_heat;
        values[self.irregularities] = account.irregularities;
    }
}
