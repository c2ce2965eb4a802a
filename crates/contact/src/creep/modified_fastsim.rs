//! Creep forces and friction power by modified FASTSIM, as published: a march in every evaluation.
//!
//! `fastsim.rs` has the theory and `flexibility.rs` the modification. Friction falls with the slip
//! velocity of the whole contact. The spin moment is
//!
//! ```text
//! M phi = -mu N phi ((L2/L3) a my - (L1/L3) b mx)                                                  (C8)
//! ```
//!
//! so that force and moment take from the wheel just the power of the slip field (C4): what heats wheel
//! and rail. Where the three flexibilities are one it is the moment of the tractions.

use super::fastsim::{Division, ScaledCreepages, march};
use super::flexibility::{Reduction, Stiffness};
use super::friction::Friction;
use super::{CreepDamping, CreepForces, SlipVelocity, TangentialForce, reference_speed};
use crate::geometry::contact_point::ContactPatch;
use std::f64::consts::{FRAC_PI_2, PI};

/// Initial slope of fx over nx: (2/pi) (8/3).
const INITIAL_SLOPE: f64 = 16.0 / (3.0 * PI);

/// Share of a creepage in the whole below which its secant is that of the initial slope.
const SMALL: f64 = 1e-6;

/// Modified FASTSIM with falling friction.
#[derive(Clone, Copy, Debug)]
pub struct ModifiedFastsim {
    /// Reduction of the stiffness.
    pub reduction: Reduction,
    /// Friction.
    pub friction: Friction,
    division: Division,
}

/// The law's dimensionless answer.
struct Answer {
    /// Secant of fx over nx.
    longitudinal: f64,
    /// Slope of fy over ny that an implicit step may take; `rest` is what fy has besides.
    lateral: f64,
    rest: f64,
    /// Moments of the tractions.
    moment_x: f64,
    moment_y: f64,
}

impl ModifiedFastsim {
    /// On line: each evaluation marches through `pairs` of strips on either side of the middle, of
    /// `elements` each; 5 pairs of 20 elements come within 1 % of finer ones.
    pub fn on_line(
        reduction: Reduction,
        friction: impl Into<Friction>,
        pairs: usize,
        elements: usize,
    ) -> Self {
        Self { reduction, friction: friction.into(), division: Division { pairs, elements } }
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
        let stiffness = Stiffness::new(&self.reduction, patch, &creepages, limit);
        // a/(mu p0), with the pressure p0 = 2 N/(pi a b).
        let per_traction = FRAC_PI_2 * a * a * b / limit;
        let longitudinal = per_traction * stiffness.longitudinal;
        let lateral = per_traction * stiffness.lateral;
        let scaled = ScaledCreepages {
            longitudinal: longitudinal * creepages.longitudinal,
            lateral: lateral * creepages.lateral,
            spin: per_traction * stiffness.spin * (a * b).sqrt() * creepages.spin,
            a_over_b: a / b,
        };
        let answer = marched(&scaled, self.division);
        let damping = limit * answer.longitudinal * longitudinal * per_speed;
        let lateral_damping = limit * answer.lateral * lateral * per_speed;
        let spin_force = -limit * answer.rest;
        let moment =
            a * answer.moment_y * stiffness.longitudinal - b * answer.moment_x * stiffness.lateral;
        let spin_moment = -direction * limit * stiffness.spin * moment
            / (stiffness.longitudinal * stiffness.lateral);
        let force = spin_force - lateral_damping * across;
        let power = damping * along * along - force * across - spin_moment * slip.spin;
        let found = CreepForces {
            force: TangentialForce { longitudinal: damping * along, lateral: force },
            spin_moment,
            friction_power: power,
            damping: CreepDamping { longitudinal: damping, lateral: lateral_damping },
            spin_force,
            flash_factor: sliding.flash,
        };
        found.within(limit, along)
    }
}

/// The answer of a march through the contact.
fn marched(scaled: &ScaledCreepages, division: Division) -> Answer {
    let forces = march(scaled, division);
    let (nx, ny, nz) = (scaled.longitudinal, scaled.lateral, scaled.spin);
    let size = (nx * nx + ny * ny + nz * nz).sqrt();
    // Steeper than any tangent of the curve there.
    let steep = INITIAL_SLOPE / (1.0 + size * size).sqrt();
    let secant = |force: f64, creepage: f64| {
        if creepage.abs() > SMALL * size { force / creepage } else { steep }
    };
    let longitudinal = secant(forces.longitudinal, nx);
    let (lateral, rest) = match nz == 0.0 {
        true => (secant(forces.lateral, ny), 0.0),
        false => (steep, forces.lateral - steep * ny),
    };
    Answer { longitudinal, lateral, rest, moment_x: forces.moment_x, moment_y: forces.moment_y }
}
