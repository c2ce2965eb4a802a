//! Reduction of the contact's stiffness, and the flexibilities of FASTSIM's foundation.
//!
//! **Reduction** (modified FASTSIM). A contaminated contact is softer than Kalker's from the start and
//! softens further with creep; measured locomotive curves reach their peak at 1 to 3 % for it.
//!
//! ```text
//! k   = k0 (alpha + (1 - alpha)/(1 + beta eps)),   all L become L/k                                (C6)
//! eps = G pi a b k0 C11 w/(4 mu N),   w² = xi² + eta_s²,   eta_s = eta + phi a if larger, else eta
//! ```
//!
//! Source: Spiryagin, Polach and Cole, Creep force modelling for rail traction vehicles based on the
//! Fastsim algorithm, VSD 51 (2013) 1765-1783, as coded in CONTACT. k0 = 1, alpha = 1 is no reduction.
//!
//! **One flexibility at full sliding.** With three of them tractions do not oppose the slip where all
//! slips. So from a third of the creepage of saturation on they go over into their mean
//!
//! ```text
//! L = (xi² + eta² + (phi f)²)/(xi²/L1 + eta²/L2 + (phi f)²/L3),   f = (pi a²/4)/(8 a/3)            (C7)
//! share = min(1, (1/3) sqrt((xi² + eta²)/(xi_c² + eta_c²))),  xi_c = mu N/(G a b C11), eta_c likewise
//! ```
//!
//! Source: Vollebregt, Detailed wheel/rail geometry processing with the conformal contact approach, and
//! the guide of CONTACT (2022).

use super::Creepages;
use crate::geometry::contact_point::ContactPatch;
use crate::material::STEEL;
use std::f64::consts::{FRAC_1_PI, FRAC_PI_4, PI};

/// Reduction of the stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reduction {
    /// k0: initial slope of the creep curve by Kalker's, between 0 and 1.
    pub initial: f64,
    /// alpha: what is left of it at infinite creepage, between 0 and 1.
    pub remaining: f64,
    /// beta: how fast it falls, not negative.
    pub fall: f64,
}

impl Reduction {
    /// No reduction: Kalker's theory as he gave it.
    pub const NONE: Self = Self { initial: 1.0, remaining: 1.0, fall: 0.0 };

    /// Siemens locomotive Eurosprinter 127, as in the examples of CONTACT (k0, alpha, beta).
    pub const EUROSPRINTER: Self = Self { initial: 0.54, remaining: 0.02, fall: 0.62 };

    /// k of equation C6; `limit` is mu N.
    #[inline]
    pub(crate) fn factor(&self, patch: &ContactPatch, creepages: &Creepages, limit: f64) -> f64 {
        let leading = creepages.lateral + creepages.spin * patch.a;
        let lateral = leading.abs().max(creepages.lateral.abs());
        let longitudinal = creepages.longitudinal;
        let creepage = (longitudinal * longitudinal + lateral * lateral).sqrt();
        let kalker = STEEL.shear_modulus * PI * patch.a * patch.b * patch.kalker.c11;
        // eps mu N.
        let force = 0.25 * self.initial * kalker * creepage;
        let falling = (1.0 - self.remaining) * limit / (limit + self.fall * force);
        self.initial * (self.remaining + falling)
    }
}

/// Stiffness 1/L of the foundation, in Pa/m.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stiffness {
    /// 1/L1, for longitudinal creepage.
    pub longitudinal: f64,
    /// 1/L2, for lateral creepage.
    pub lateral: f64,
    /// 1/L3, for spin.
    pub spin: f64,
}

impl Stiffness {
    /// The stiffness with reduction (C6) and the passage to one (C7); `limit` is mu N.
    #[inline]
    pub(crate) fn new(
        reduction: &Reduction,
        patch: &ContactPatch,
        creepages: &Creepages,
        limit: f64,
    ) -> Self {
        let modulus = STEEL.shear_modulus * reduction.factor(patch, creepages, limit) / patch.a;
        let [longitudinal, lateral, spin] = coefficients(patch, creepages, limit);
        Self {
            longitudinal: modulus * longitudinal,
            lateral: modulus * lateral,
            spin: modulus * spin,
        }
    }
}

/// a/(G L) of the three flexibilities without reduction, with the passage to one (C1, C7).
#[inline]
fn coefficients(patch: &ContactPatch, creepages: &Creepages, limit: f64) -> [f64; 3] {
    let (a, b, kalker) = (patch.a, patch.b, &patch.kalker);
    let (c11, c22) = (kalker.c11, kalker.c22);
    let own = [0.375 * c11, 0.375 * c22, 4.0 * FRAC_1_PI * kalker.c23 * (b / a).sqrt()];
    let square = |value: f64| value * value;
    let (xi, eta) = (square(creepages.longitudinal), square(creepages.lateral));
    let spin = square(creepages.spin * a * (FRAC_PI_4 * 0.375));
    let sum = xi + eta + spin;
    if sum == 0.0 {
        return own;
    }
    let saturation = c11 * c22 * STEEL.shear_modulus * a * b / (3.0 * limit);
    let share = saturation * ((xi + eta) / (c11 * c11 + c22 * c22)).sqrt();
    let share = share.min(1.0);
    // The common one is weighted/sum.
    let weighted = xi * own[0] + eta * own[1] + spin * own[2];
    own.map(|own| own * weighted / ((1.0 - share) * weighted + share * sum * own))
}
