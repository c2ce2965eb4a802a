//! Temperature rise of the surface under a passing wheel.
//!
//! A half-space that a band of heat crosses fast (Péclet number v a / 2α > 10), so that heat flows
//! downwards only. With a flux that is spread as Hertz's pressure, which is that of full slip, the
//! highest rise is (`docs/theory/railheat/paper.md#eq-4`)
//!
//! ```text
//! ΔT = C ε (q₀/β) √(a/v),   q₀ = 1.5 P/(π a b)
//!    = 1.5 C/π · ε (P/v) √(v/a) / (b β)
//! ```
//!
//! with C = 1.2346198, the maximum of ∫ √(1-u²)/√(s-u) du / √π over u from -1 to s, at 0.652 a
//! behind the middle of the contact. Where only a part of the contact slips the same power makes a
//! higher peak: by the factor [`CreepForces::flash_factor`](crate::CreepForces::flash_factor).

use std::f64::consts::PI;

/// Highest rise behind a semi-elliptic flux, in units of ε (q₀/β) √(a/v).
pub const HERTZ_PEAK: f64 = 1.234_619_8;

/// Highest temperature rise of the surface by heat that is spread as Hertz's pressure, K.
///
/// `energy_per_metre` (J/m) flows into this body on the way through a contact with the semi-axes `a` and
/// `b` (m) at `speed` (m/s, either sign); `penetration` is β = √(k ρ c) in W √s/(m² K).
#[inline]
pub fn flash_rise(energy_per_metre: f64, a: f64, b: f64, speed: f64, penetration: f64) -> f64 {
    1.5 * HERTZ_PEAK / PI * energy_per_metre * (speed.abs() / a).sqrt() / (b * penetration)
}
