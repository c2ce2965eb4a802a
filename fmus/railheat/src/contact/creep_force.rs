//! Longitudinal creep force of a wheel on the rail.
//!
//! Polach's law for longitudinal creepage alone and constant friction
//! (`docs/theory/railheat/paper.md#eq-2`,
//! `docs/theory/railheat/paper.md#eq-3`):
//!
//! ```text
//! F = (2 μ N / π) (ε / (1 + ε²) + atan ε),    ε = G π a b C₁₁ |ξ| / (4 μ N)
//! ```
//!
//! Polach, *Wear* 258 (2005) 992-1000, with both reduction factors 1 (clean, dry surfaces),
//! because the paper gives one friction coefficient and nothing about contamination.
//! Against the exact half-space of Vollebregt's program CONTACT the force is within 6.2 %;
//! validated by `benchmark_creep_force_against_contact`.

use std::f64::consts::PI;

/// Shear modulus of wheel and rail steel, Pa (CONTACT's steel, used with ν = 0.28).
const SHEAR_MODULUS: f64 = 82e9;

/// A wheel's contact with the rail.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Contact {
    /// Normal force N, N; zero when the wheel has left the rail.
    pub normal_force: f64,
    /// Semi-axis of the contact ellipse along the rail a, m.
    pub a: f64,
    /// Semi-axis across the rail b, m.
    pub b: f64,
}

/// Magnitude of the longitudinal creep force, N, at a creepage of either sign.
/// It rises with the creepage to the limit `friction · normal_force`.
pub fn creep_force(contact: &Contact, creepage: f64, friction: f64) -> f64 {
    let Contact { normal_force, a, b } = *contact;
    let limit = friction * normal_force;
    let stiffness = SHEAR_MODULUS * a * b * kalker_c11(a / b);
    let e = PI * stiffness * creepage.abs() / (4.0 * limit);
    2.0 / PI * limit * (e / (1.0 + e * e) + libm::atan(e))
}

/// Kalker's coefficient C₁₁ for ν = 0.28 at a ratio a/b of the semi-axes.
///
/// A parabola fitted to the table of Kalker, *Three-Dimensional Elastic Bodies in Rolling Contact*
/// (1990), within 1.7 % for a/b from 0.1 to 10; outside the value at the end is held.
pub fn kalker_c11(ratio: f64) -> f64 {
    let r = ratio.clamp(0.1, 10.0);
    3.286 + 0.975 * r - 0.0119 * r * r
}
