//! What the FMU shows of a contact at the end of a step.

use contact::{Creepages, SlipVelocity};

use super::end_forces::EndForces;
use super::patch::Patch;

fmu::variables! {
    /// One contact, or all of a wheel, at the end of a step; all zero without contact.
    #[derive(Copy, Default)]
    pub struct ContactOutput: output {
        /// Creepages.
        creepages: "creepage", group(CreepageOutput);
        /// Forces on the wheel.
        force: "force", group(ContactForce);
        /// Power turned into heat by creep, {}
        friction_power: "friction_power", WATT;
        /// Where it lies and how large it is.
        ellipse: "contact", group(ContactEllipse);
    }

    /// Creepages of a contact.
    #[derive(Copy, Default)]
    pub struct CreepageOutput: output {
        /// Longitudinal creepage, traction positive, {}
        longitudinal: "longitudinal", ONE;
        /// Lateral creepage, wheel slipping right positive, {}
        lateral: "lateral", ONE;
        /// Spin creepage, positive about z down, {}
        spin: "spin", PER_METRE;
    }

    /// Forces of a contact on the wheel.
    #[derive(Copy, Default)]
    pub struct ContactForce: output {
        /// Creep force on the wheel along the track, traction positive, {}
        longitudinal: "longitudinal", NEWTON;
        /// Creep force on the wheel in the contact plane, positive to the right, {}
        lateral: "lateral", NEWTON;
        /// Normal force, {}
        normal: "normal", NEWTON;
    }

    /// Size and position of a contact.
    #[derive(Copy, Default)]
    pub struct ContactEllipse: output {
        /// Semi-axis of the contact in rolling direction, {}
        a: "a", METRE;
        /// Semi-axis of the contact across, {}
        b: "b", METRE;
        /// Highest flash temperature by that of the same friction power spread as the pressure, {}
        flash_factor: "flash_factor", ONE;
        /// Contact on the rail head from its top, negative towards the gauge side, {}
        lateral_position: "lateral_position", METRE;
        /// Contact angle, positive as on a tread, {}
        angle: "angle", RADIAN;
    }
}

impl ContactOutput {
    /// The contact with these forces and this slip.
    #[inline]
    pub(super) fn new(patch: &Patch, end: &EndForces, slip: &SlipVelocity, speed: f64) -> Self {
        let Creepages { longitudinal, lateral, spin } = slip.creepages(speed);
        Self {
            creepages: CreepageOutput { longitudinal, lateral, spin },
            force: ContactForce {
                longitudinal: end.creep.longitudinal,
                lateral: end.creep.lateral,
                normal: end.normal,
            },
            friction_power: end.heat(slip),
            ellipse: ContactEllipse {
                a: patch.forces.a,
                b: patch.forces.b,
                flash_factor: patch.forces.creep.flash_factor,
                lateral_position: patch.rail_lateral,
                angle: patch.angle(),
            },
        }
    }

    /// Adds a contact, with `weight` in the means.
    #[inline]
    pub(super) fn add(&mut self, patch: &Self, weight: f64) {
        self.force.longitudinal += patch.force.longitudinal;
        self.force.lateral += patch.force.lateral;
        self.force.normal += patch.force.normal;
        self.friction_power += patch.friction_power;
        self.creepages.longitudinal += weight * patch.creepages.longitudinal;
        self.creepages.lateral += weight * patch.creepages.lateral;
        self.creepages.spin += weight * patch.creepages.spin;
        self.ellipse.a += weight * patch.ellipse.a;
        self.ellipse.b += weight * patch.ellipse.b;
        self.ellipse.flash_factor += weight * patch.ellipse.flash_factor;
        self.ellipse.lateral_position += weight * patch.ellipse.lateral_position;
        self.ellipse.angle += weight * patch.ellipse.angle;
    }

    /// Makes means of the sums weighted by `weights` in all.
    #[inline]
    pub(super) fn divide(&mut self, weights: f64) {
        let share = 1.0 / weights;
        self.creepages.longitudinal *= share;
        self.creepages.lateral *= share;
        self.creepages.spin *= share;
        self.ellipse.a *= share;
        self.ellipse.b *= share;
        self.ellipse.flash_factor *= share;
        self.ellipse.lateral_position *= share;
        self.ellipse.angle *= share;
    }
}
