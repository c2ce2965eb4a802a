//! Polach's creep force law.
//!
//! With creepages xi (positive in traction) and eta, spin phi, friction mu, load N, semi-axes a and b,
//! and shear modulus G:
//!
//! ```text
//! eta_C = eta + phi a  if that is larger in magnitude, else eta          s_C = sqrt(xi^2 + eta_C^2)
//! C     = (3/8) (G/a) sqrt((C11 xi/s_C)^2 + (C22 eta_C/s_C)^2)
//! eps   = (2/3) C pi a^2 b s_C/(mu N)
//! F     = (2 mu N/pi) (kA eps/(1 + (kA eps)^2) + atan(kS eps))
//! Fx    = F xi/s_C
//! Fy    = -F eta/s_C + Fs
//! Fs    = (9/16) a mu N KM (1 + 6.3 (1 - exp(-a/b))) phi/s_C
//! KM    = |eps_S| (d^3/3 - d^2/2 + 1/6) - (1/3) sqrt((1 - d^2)^3),  d = (eps_S^2 - 1)/(eps_S^2 + 1)
//! eps_S = (8/3) G b sqrt(a b) C23 eta_C/(mu N (1 + 6.3 (1 - exp(-a/b))))
//! ```
//!
//! KM is negative, so that Fs starts as Kalker's -G (a b)^(3/2) C23 phi. Sources: Polach, A fast
//! wheel-rail forces calculation computer code, VSD 33 Suppl. (1999) 728-739 (law and spin), and Wear
//! 258 (2005) 992-1000, eqs 4, 9, 11, 12 (kA, kS and falling friction).
//!
//! Beyond the sources:
//! - C is taken in the direction of (xi, eta_C) rather than of (xi, eta), so that pure spin has one;
//!   without spin both agree.
//! - The resultant is cut at mu N where lateral force and spin together would exceed it.
//! - The spin moment, which Polach leaves out, is the one that is reciprocal to Fs (as C23 serves
//!   both in Kalker's theory), plus Kalker's -G (a b)^2 C33 phi reduced as F is. So friction power is
//!   never negative.

use super::friction::{FallingFriction, Friction};
use super::{CreepDamping, CreepForces, SlipVelocity, TangentialForce, reference_speed};
use crate::geometry::contact_point::ContactPatch;
use crate::material::STEEL;
use std::f64::consts::FRAC_PI_4;

/// Creepage below which C takes its lateral value: too little to matter, enough to divide by.
const LEAST_CREEPAGE: f64 = 1e-9;

/// Parameters of Polach's law.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize)]
#[serde(deny_unknown_fields)]
pub struct Polach {
    /// kA: reduction of Kalker's stiffness in the area of adhesion, 0 < kS <= kA <= 1.
    pub adhesion_factor: f64,
    /// kS: reduction in the area of slip.
    pub slip_factor: f64,
    /// Friction.
    pub friction: Friction,
}

impl Polach {
    /// Dry rail, Polach 2005, table 2.
    pub const DRY: Self = Self {
        adhesion_factor: 1.0,
        slip_factor: 0.4,
        friction: Friction::Falling(FallingFriction {
            static_coefficient: 0.55,
            limit_ratio: 0.4,
            decay: 0.6,
        }),
    };

    /// Wet rail, Polach 2005, table 2.
    pub const WET: Self = Self {
        adhesion_factor: 0.3,
        slip_factor: 0.1,
        friction: Friction::Falling(FallingFriction {
            static_coefficient: 0.3,
            limit_ratio: 0.4,
            decay: 0.2,
        }),
    };

    /// Forces on the wheel in a loaded contact that slips, while it rolls at `speed` (m/s).
    ///
    /// Without load or friction all is zero. Lateral slip and force lie in the contact plane.
    pub fn force(&self, patch: &ContactPatch, slip: &SlipVelocity, speed: f64) -> CreepForces {
        let slip_squared = slip.longitudinal * slip.longitudinal + slip.lateral * slip.lateral;
        let sliding = self.friction.sliding(patch, slip, speed);
        let limit = sliding.coefficient * patch.normal_force;
        if limit.is_nan() || limit <= 0.0 {
            return CreepForces::default();
        }
        let per_speed = 1.0 / reference_speed(speed);
        let (xi, eta) = (slip.longitudinal * per_speed, slip.lateral * per_speed);
        // Material enters the contact at the end towards which the wheel rolls.
        let direction = 1.0_f64.copysign(speed);
        let phi = direction * slip.spin * per_speed;
        let leading = eta + phi * patch.a;
        let eta_c = if leading.abs() > eta.abs() { leading } else { eta };

        let secants = self.secants(patch, limit, xi, eta_c);
        let coupling = spin_coupling(patch, limit, xi, eta_c);
        let (fx, fy) = (secants.slide * xi, secants.slide * eta + coupling * phi);
        let resultant = (fx * fx + fy * fy).sqrt();
        let cut = if resultant > limit { limit / resultant } else { 1.0 };

        let damping = cut * secants.slide * per_speed;
        let spin_damping = cut * secants.spin * per_speed;
        let spin_force = -cut * coupling * phi;
        CreepForces {
            force: TangentialForce {
                longitudinal: damping * slip.longitudinal,
                lateral: spin_force - damping * slip.lateral,
            },
            spin_moment: direction * cut * coupling * eta - spin_damping * slip.spin,
            friction_power: damping * slip_squared + spin_damping * slip.spin * slip.spin,
            damping: CreepDamping { longitudinal: damping, lateral: damping },
            spin_force,
            flash_factor: sliding.flash,
        }
    }

    /// F/s_C and the spin moment by spin; `limit` is mu N.
    fn secants(&self, patch: &ContactPatch, limit: f64, xi: f64, eta_c: f64) -> Secants {
        let area = patch.a * patch.b;
        let (c11, c22) = (patch.kalker.c11 * xi, patch.kalker.c22 * eta_c);
        // The larger coefficient where nothing slips: then force over slip never rises with slip.
        let least = patch.kalker.c11.max(patch.kalker.c22) * LEAST_CREEPAGE;
        let creepage_squared = xi * xi + eta_c * eta_c;
        let coefficient = ((c11 * c11 + c22 * c22 + least * least)
            / (creepage_squared + LEAST_CREEPAGE * LEAST_CREEPAGE))
            .sqrt();
        // (2/3) C pi a^2 b = (pi/4) G a b coefficient, Kalker's stiffness times pi/4.
        let kalker = STEEL.shear_modulus * area * coefficient;
        let eps = (FRAC_PI_4 * kalker * creepage_squared.sqrt() / limit).max(LEAST_CREEPAGE);
        let adhesion = self.adhesion_factor * eps;
        let reduction = 0.5
            * (self.adhesion_factor / (1.0 + adhesion * adhesion)
                + libm::atan(self.slip_factor * eps) / eps);
        Secants {
            slide: reduction * kalker,
            spin: reduction * STEEL.shear_modulus * area * area * patch.kalker.c33,
        }
    }
}

/// Secants of the creep curve against creepage, in N and N m^2.
struct Secants {
    slide: f64,
    spin: f64,
}

/// -Fs/phi in N m.
///
/// With d = (e^2 - 1)/(e^2 + 1) Polach's KM is -(2/3) |e|/(1 + e^2)^2, and so
/// Fs = -G (a b)^(3/2) C23 phi (|eta_C|/s_C)/(1 + eps_S^2)^2.
fn spin_coupling(patch: &ContactPatch, limit: f64, xi: f64, eta_c: f64) -> f64 {
    let (a, b) = (patch.a, patch.b);
    let creepage = (xi * xi + eta_c * eta_c).sqrt();
    if creepage < LEAST_CREEPAGE * LEAST_CREEPAGE {
        return 0.0;
    }
    let kalker = STEEL.shear_modulus * b * (a * b).sqrt() * patch.kalker.c23;
    let shape = 1.0 + 6.3 * (1.0 - libm::exp(-a / b));
    let eps = 8.0 / 3.0 * kalker * eta_c / (limit * shape);
    let fall = 1.0 + eps * eps;
    a * kalker * (eta_c.abs() / creepage) / (fall * fall)
}
