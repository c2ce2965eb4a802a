//! Curve resistance of a vehicle.
//!
//! ```text
//! R_c = k m / R      k = 6116 N m/t      (theory, eq. 10)
//! ```
//!
//! at the vehicle's own place, the chainage of its middle. The usual constant is 0.8 lb for each
//! long ton and degree of curve (Cole, Hay). Valid for curves wider than about 150 m.
//!
//! It is an output of its own: a three-dimensional vehicle makes its curve resistance itself, by
//! the creep of its wheels, and must not be given this one on top.

/// Curve resistance proportional to the curvature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveResistance {
    /// Force times radius, N m.
    strength: f64,
}

impl CurveResistance {
    /// The curve resistance of a vehicle.
    pub fn new(vehicle: &stock::Vehicle) -> Self {
        let tonnes = vehicle.mass_kg * 1e-3;
        Self { strength: vehicle.resistance.curve_n_m_per_t * tonnes }
    }

    /// Greatest force against the motion where the track has a curvature, 1/m, in N.
    pub fn force(&self, curvature: f64) -> f64 {
        self.strength * curvature.abs()
    }
}
