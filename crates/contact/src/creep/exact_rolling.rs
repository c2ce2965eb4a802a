//! Creep forces and friction power by Kalker's exact theory, with the modification of modified FASTSIM.
//!
//! The forces are those of steady rolling of two half-spaces (`rolling/`), from a table
//! (`rolling_table.rs`). Reduction k (C6) and friction mu act as scalings: all creepages count k times
//! in the table's coordinates nx, ny, nz (C15), as if a layer made the contact softer, and the limit is
//! mu N with the friction of the whole contact.
//!
//! Power is what force and moment take from the slip,
//!
//! ```text
//! P = V (Fx xi + Fy eta + M phi)                                                                   (C16)
//! ```
//!
//! which in steady rolling is the power of the slip field, as elastic bodies give back what they took.

use super::flexibility::Reduction;
use super::friction::Friction;
use super::rolling_table::{RollingTable, ScaledMotion};
use super::{CreepDamping, CreepForces, SlipVelocity, TangentialForce, reference_speed};
use crate::geometry::contact_point::ContactPatch;
use crate::material::STEEL;

/// Exact rolling by table.
#[derive(Clone, Copy, Debug)]
pub struct ExactRolling {
    /// Reduction of the stiffness.
    pub reduction: Reduction,
    /// Friction.
    pub friction: Friction,
    table: &'static RollingTable,
}

impl ExactRolling {
    /// By the table that all in the process share; the first call unpacks it.
    pub fn new(reduction: Reduction, friction: impl Into<Friction>) -> Self {
        Self { reduction, friction: friction.into(), table: RollingTable::shared() }
    }

    /// Forces on the wheel in a loaded contact that slips, while it rolls at `speed` (m/s).
    ///
    /// Without load or friction all is zero. Lateral slip and force lie in the contact plane.
    #[inline]
    pub fn force(&self, patch: &ContactPatch, slip: &SlipVelocity, speed: f64) -> CreepForces {
        let (along, across) = (slip.longitudinal, slip.lateral);
        let sliding = self.friction.sliding(patch, slip, speed);
        let limit = sliding.coefficient * patch.normal_force;
        if limit.is_nan() || limit <= 0.0 {
            return CreepForces::default();
        }
        let (a, b) = (patch.a, patch.b);
        let per_speed = 1.0 / reference_speed(speed);
        // Material enters the contact at the end towards which the wheel rolls.
        let direction = 1.0_f64.copysign(speed);
        let mut creepages = slip.creepages(speed);
        creepages.spin *= direction;
        let factor = self.reduction.factor(patch, &creepages, limit);
        let kalker = patch.kalker.c11 + patch.kalker.c22;
        let per_creepage = factor * STEEL.shear_modulus * a * b * kalker / (6.0 * limit);
        let reach = (a * a + b * b).sqrt();
        let scaled = ScaledMotion {
            longitudinal: per_creepage * creepages.longitudinal,
            lateral: per_creepage * creepages.lateral,
            spin: per_creepage * reach * creepages.spin,
            a_over_b: a / b,
        };
        let ratios = self.table.at(&scaled);
        let per_slip = limit * per_creepage * per_speed;
        let damping = per_slip * ratios.longitudinal;
        let lateral_damping = per_slip * ratios.lateral;
        let spin_force = -limit * ratios.spin * scaled.spin;
        let moment = ratios.moment.0 * scaled.spin + ratios.moment.1 * scaled.lateral;
        let force = spin_force - lateral_damping * across;
        let slide = damping * along * along - force * across;
        // Interpolation may exceed what it must not by a trifle: heat never drives the wheel.
        let spun = (direction * limit * reach * moment * slip.spin).max(-slide);
        let power = slide + spun;
        let spin_moment =
            if slip.spin == 0.0 { -direction * limit * reach * moment } else { -spun / slip.spin };
        let found = CreepForces {
            force: TangentialForce { longitudinal: damping * along, lateral: force },
            spin_moment,
            friction_power: power,
            damping: CreepDamping { longitudinal: damping, lateral: lateral_damping },
            spin_force,
            flash_factor: sliding.flash * ratios.flash,
        };
        found.within(limit, along)
    }
}
