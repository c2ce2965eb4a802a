//! What a set of creepages does in one contact: force, friction power and flash temperature.

use contact::hertz::UnitContact;
use contact::kalker::CreepCoefficients;
use contact::{
    ContactPatch, CreepForces, CreepLaw, FallingFriction, ModifiedFastsim, Polach, Reduction,
    STEEL, SlipVelocity,
};
use railheat::contact::{Contact, Material, flash_rise};

use super::arguments::{CreepArguments, Law};
use crate::error::{ToolError, ensure};

const MM: f64 = 1e-3;

/// Share of the friction heat that flows into the rail: half, for equal steels.
const PARTITION: f64 = 0.5;

/// What one set of creepages does.
pub(super) struct Row {
    /// Longitudinal and lateral creepage, and spin in 1/m.
    pub creepages: [f64; 3],
    pub forces: CreepForces,
    /// Highest rise of the rail's surface, K.
    pub flash: f64,
}

/// A row for each set of creepages.
pub(super) fn rows(arguments: &CreepArguments) -> Result<Vec<Row>, ToolError> {
    let patch = patch(arguments)?;
    let law = law(arguments);
    let lists = [&arguments.longitudinal, &arguments.lateral, &arguments.spin];
    let count = lists.iter().map(|list| list.len()).max().unwrap_or(0);
    ensure(
        lists.iter().all(|list| list.len() == 1 || list.len() == count),
        "the lists of creepages must have the same length, or one value for all rows",
    )?;
    let speed = arguments.speed;
    let rows = (0..count).map(|i| {
        let creepages = lists.map(|list| list[i.min(list.len() - 1)]);
        let [longitudinal, lateral, spin] = creepages.map(|creepage| speed * creepage);
        let forces = law.force(&patch, &SlipVelocity { longitudinal, lateral, spin }, speed);
        Row { creepages, forces, flash: flash(&patch, forces.friction_power, speed) }
    });
    Ok(rows.collect())
}

/// The contact ellipse, given or by Hertz.
fn patch(arguments: &CreepArguments) -> Result<ContactPatch, ToolError> {
    let (a, b) = match (&arguments.semi_axes_mm, &arguments.radii_m) {
        (Some(axes), None) => (axes[0] * MM, axes[1] * MM),
        (None, Some(radii)) => {
            let hertz = UnitContact::new(0.5 / radii[0], 0.5 / radii[1], &STEEL);
            let scale = arguments.load.cbrt();
            (hertz.semi_axis_rolling * scale, hertz.semi_axis_lateral * scale)
        }
        _ => {
            let wanted = "give either --semi-axes-mm A B or --radii-m RX RY";
            return Err(ToolError::Options(wanted.to_owned()));
        }
    };
    let kalker = CreepCoefficients::new(a / b, STEEL.poisson_ratio);
    Ok(ContactPatch { normal_force: arguments.load, a, b, kalker })
}

fn law(arguments: &CreepArguments) -> CreepLaw {
    let friction = FallingFriction {
        static_coefficient: arguments.friction,
        limit_ratio: arguments.limit_ratio,
        decay: arguments.decay,
    };
    let reduction = Reduction {
        initial: arguments.reduction[0],
        remaining: arguments.reduction[1],
        fall: arguments.reduction[2],
    };
    match arguments.law {
        Law::ModifiedFastsim => CreepLaw::Fastsim(ModifiedFastsim::by_table(reduction, friction)),
        Law::FastsimOnLine => {
            CreepLaw::Fastsim(ModifiedFastsim::on_line(reduction, friction, 20, 100))
        }
        Law::Polach => CreepLaw::Polach(Polach {
            adhesion_factor: arguments.factors[0],
            slip_factor: arguments.factors[1],
            friction,
        }),
        Law::ShenHedrickElkins => CreepLaw::ShenHedrickElkins(friction),
        Law::KalkerLinear => CreepLaw::KalkerLinear,
    }
}

/// Highest rise of the rail's surface behind the contact, in K.
fn flash(patch: &ContactPatch, friction_power: f64, speed: f64) -> f64 {
    let contact = Contact { normal_force: patch.normal_force, a: patch.a, b: patch.b };
    // Power by speed is the energy on a metre: force times creepage.
    flash_rise(&contact, friction_power / speed, 1.0, speed, PARTITION, &Material::PAPER)
}
