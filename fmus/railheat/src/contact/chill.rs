//! Conduction between a wheel and a rail of different temperature (rail chill).
//!
//! While two half-spaces touch, q = β_eff ΔT/√(π t) flows with β_eff = β_r β_w/(β_r + β_w).
//! Integrated over the elliptic patch, in which each point stays 2a √(1-(y/b)²)/v
//! (`docs/theory/railheat/energy.md#eq-19`):
//!
//! ```text
//! G = 3.49608 β_eff b √(2 a v/π),    W/K
//! ```
//!
//! An upper limit: oxide, roughness and sand reduce it, which a factor takes into account. The
//! narrowing of the flow in the tread of the wheel (20 to 25 %) is not in it.
//! Validated by `benchmark_chill_conductance`.

use std::f64::consts::PI;

/// 2 ∫ (1-u²)^¼ du over -1 to 1 = 2 √π Γ(5/4)/Γ(7/4).
const PATCH: f64 = 3.496_076_8;

/// Conductance of the contact between a wheel and a rail of one steel, W/K.
///
/// The steel has the thermal penetration coefficient `penetration` in W·√s/(m²·K); the semi-axes
/// `a` and `b` are in m, the speed in m/s.
pub fn conductance(penetration: f64, a: f64, b: f64, speed: f64) -> f64 {
    PATCH * 0.5 * penetration * b * (2.0 * a * speed.abs() / PI).sqrt()
}
