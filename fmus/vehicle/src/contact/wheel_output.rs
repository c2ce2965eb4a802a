//! What a wheel does to its rail, and feels, at the end of a step.

use contact::{Creepages, SlipVelocity, TangentialForce};

use super::patch::Patch;
use super::rows::{ContactMotion, Linearised};
use super::six::Six;
use super::wheel::{PATCHES, Standing, Wheel};

/// Friction power that a contact has at least for its weight in a wheel's means, W for each N of
/// normal force: far below any that heats, so that it counts only where nothing slips.
const LEAST_POWER: f64 = 1e-9;

/// One contact, or all of a wheel, at the end of a step; all zero without contact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactOutput {
    /// Creepages.
    pub creepages: Creepages,
    /// Creep force on the wheel.
    pub force: TangentialForce,
    /// Normal force, N.
    pub normal: f64,
    /// Power turned into heat, W.
    pub friction_power: f64,
    /// Semi-axis of the contact in the rolling direction, m.
    pub a: f64,
    /// Semi-axis across, m.
    pub b: f64,
    /// Contact on the rail head, m from its top, negative towards the gauge side.
    pub rail_lateral: f64,
    /// Contact angle, rad, positive as on a tread.
    pub angle: f64,
}

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

/// Forces of a contact at the end of a step, N.
struct EndForces {
    creep: TangentialForce,
    normal: f64,
    /// Moment about the normal, N m.
    spin_moment: f64,
}

impl EndForces {
    /// The forces after a `change` of the motion.
    fn new(forces: &Linearised, change: &ContactMotion) -> Self {
        let creep = &forces.creep;
        Self {
            creep: TangentialForce {
                longitudinal: creep.force.longitudinal
                    + creep.damping.longitudinal * change.slip.longitudinal,
                lateral: creep.force.lateral - creep.damping.lateral * change.slip.lateral,
            },
            normal: forces.normal + forces.normal_damping * change.approach,
            spin_moment: creep.spin_moment,
        }
    }

    /// Power that creep takes from the wheelset at this slip, W.
    fn heat(&self, slip: &SlipVelocity) -> f64 {
        let Self { creep, spin_moment, .. } = self;
        creep.longitudinal * slip.longitudinal
            - creep.lateral * slip.lateral
            - spin_moment * slip.spin
    }
}

/// Heat that arises in a step's contacts, W: by creep, and by damping along the normals.
#[derive(Clone, Copy, Debug, Default)]
pub struct Heat {
    /// By creep.
    pub friction: f64,
    /// By damping.
    pub damping: f64,
}

impl WheelOutput {
    /// Becomes the wheel at the end of a step in which its wheelset's velocities change by `change`
    /// and after which it travels at `speed`; gives the heat by the motion in the step's middle. (In
    /// place, as copying it took a good part of a step.)
    pub fn take(&mut self, wheel: &Wheel, change: &Six, speed: f64) -> Heat {
        let mut heat = Heat::default();
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
            let weight = shown.friction_power.max(0.0) + LEAST_POWER * shown.normal;
            total.add(shown, weight);
            weights += weight;
        }
        if weights > 0.0 {
            total.divide(weights);
        } else {
            total.rail_lateral = wheel.nearest();
        }
        (self.total, self.guiding, self.vertical) = (total, guiding, vertical);
        (self.elastic_energy, self.standing) = (elastic_energy, wheel.standing());
        heat
    }

    /// Forgets the contacts of the last step; those that were not there are zero already.
    fn clear_patches(&mut self) {
        for patch in self.patches.iter_mut().filter(|patch| patch.normal != 0.0) {
            *patch = ContactOutput::default();
        }
    }
}

impl ContactOutput {
    /// The contact with these forces and this slip.
    #[inline]
    fn new(patch: &Patch, end: &EndForces, slip: &SlipVelocity, speed: f64) -> Self {
        Self {
            creepages: slip.creepages(speed),
            force: end.creep,
            normal: end.normal,
            friction_power: end.heat(slip),
            a: patch.forces.a,
            b: patch.forces.b,
            rail_lateral: patch.rail_lateral,
            angle: patch.angle(),
        }
    }

    /// Adds a contact, with `weight` in the means.
    #[inline]
    fn add(&mut self, patch: &Self, weight: f64) {
        self.force.longitudinal += patch.force.longitudinal;
        self.force.lateral += patch.force.lateral;
        self.normal += patch.normal;
        self.friction_power += patch.friction_power;
        self.creepages.longitudinal += weight * patch.creepages.longitudinal;
        self.creepages.lateral += weight * patch.creepages.lateral;
        self.creepages.spin += weight * patch.creepages.spin;
        self.a += weight * patch.a;
        self.b += weight * patch.b;
        self.rail_lateral += weight * patch.rail_lateral;
        self.angle += weight * patch.angle;
    }

    /// Makes means of the sums weighted by `weights` in all.
    #[inline]
    fn divide(&mut self, weights: f64) {
        let share = 1.0 / weights;
        self.creepages.longitudinal *= share;
        self.creepages.lateral *= share;
        self.creepages.spin *= share;
        self.a *= share;
        self.b *= share;
        self.rail_lateral *= share;
        self.angle *= share;
    }
}
