//! What a wheel does to its rail, and its contacts, at the end of a step.

use super::contact_output::ContactOutput;
use super::end_forces::{ContactHeat, EndForces};
use super::six::Six;
use super::wheel::{PATCHES, Standing, Wheel};

/// Least friction power in a contact's weight in a wheel's means, W for each N of normal force.
///
/// It is far below any power that heats, so that it counts only where nothing slips.
const LEAST_POWER: f64 = 1e-9;

/// A wheel with all its contacts at the end of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WheelOutput {
    /// All contacts together. Forces and power are sums; the rest are means weighted by the friction
    /// power, as they say where the heat arises.
    pub total: ContactOutput,
    /// Lateral force on the wheel in the plane of the rails, N, positive to the right.
    pub guiding: f64,
    /// Force of the rail on the wheel upwards, square to the plane of the rails, N.
    pub vertical: f64,
    /// Elastic energy of the contacts, J.
    pub elastic_energy: f64,
    /// How the wheel stands on its rail.
    pub standing: Standing,
    /// The contacts by their number in the geometry table: tread first, then towards the flange.
    pub patches: [ContactOutput; PATCHES],
}

impl WheelOutput {
    /// Becomes the wheel at the end of a step; gives the heat by the motion in the step's middle.
    ///
    /// The wheelset's velocities change by `change`, and it travels at `speed` (m/s) afterwards. The
    /// output is overwritten, as copying it took a good part of a step.
    pub fn update(&mut self, wheel: &Wheel, change: &Six, speed: f64) -> ContactHeat {
        let mut heat = ContactHeat::default();
        let mut total = ContactOutput::default();
        let (mut guiding, mut vertical, mut elastic_energy, mut weights) = (0.0, 0.0, 0.0, 0.0);
        self.clear_patches();
        for patch in wheel.patches() {
            elastic_energy += patch.elastic_energy;
            if patch.forces.normal <= 0.0 {
                continue;
            }
            let change = patch.rows.motion(change);
            let end = EndForces::new(&patch.forces, &change);
            let middle = patch.motion.after(0.5, &change);
            heat.friction += end.heat(&middle.slip);
            heat.damping += (end.normal - patch.elastic_force) * middle.approach;
            guiding += patch.rows.across(end.creep.lateral, end.normal);
            vertical += patch.rows.upwards(end.creep.lateral, end.normal);
            let shown = &mut self.patches[patch.number];
            *shown = ContactOutput::new(patch, &end, &patch.motion.after(1.0, &change).slip, speed);
            let weight = shown.friction_power.max(0.0) + LEAST_POWER * shown.force.normal;
            total.add(shown, weight);
            weights += weight;
        }
        if weights > 0.0 {
            total.divide(weights);
        } else {
            total.ellipse.lateral_position = wheel.nearest();
        }
        (self.total, self.guiding, self.vertical) = (total, guiding, vertical);
        (self.elastic_energy, self.standing) = (elastic_energy, wheel.standing());
        heat
    }

    /// Forgets the contacts of the last step; those that were not there are zero already.
    fn clear_patches(&mut self) {
        for patch in self.patches.iter_mut().filter(|patch| patch.force.normal != 0.0) {
            *patch = ContactOutput::default();
        }
    }
}
