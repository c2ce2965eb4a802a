//! Curve resistance of a vehicle.
//!
//! ```text
//! R_c = k m |κ|                                      k = 6116 N m/t
//! R_c = 0.0004 m g D                                 D = 1746.4 |κ| degrees over 100 ft
//! R_c = 650/(R − 55) or 500/(R − 30) N/kN times m g  R ≥ 300 m, or below
//! R_c = table(|κ|) m                                 (theory, eq. 10)
//! ```
//!
//! with the curvature κ = 1/R under the vehicle. The constant 6116 is 0.8 lb for each long
//! ton and degree of curve (Cole, Hay), the second line the same for each short ton (Train Propulsion
//! Simulator), the third is Roeckl's. Valid for curves wider than about 150 m.
//!
//! It is an output of its own: a three-dimensional vehicle makes its curve resistance itself, by
//! the creep of its wheels, and must not be given this one on top.

use numerics::constants::STANDARD_GRAVITY;
use numerics::{LinearTable, TableError};
use stock::CurveFormula;

/// Degrees of curve over a chord of 100 ft (30.48 m) in a curvature of 1/m.
const DEGREES: f64 = 30.48 * 180.0 / std::f64::consts::PI;

/// Smallest radius at which Roeckl's second formula is evaluated, m.
const SMALLEST_RADIUS: f64 = 50.0;

/// Curve resistance by curvature.
#[derive(Clone, Debug, PartialEq)]
pub enum CurveResistance {
    /// Force over curvature, N m.
    Proportional(f64),
    /// Roeckl's formula for a weight, kN.
    Roeckl(f64),
    /// Force over curvature, N over 1/m.
    Table(LinearTable),
}

impl CurveResistance {
    /// The curve resistance of a vehicle.
    ///
    /// # Errors
    /// When its table cannot be used.
    pub fn new(vehicle: &stock::Vehicle) -> Result<Self, TableError> {
        let (file, tonnes) = (&vehicle.resistance, vehicle.mass_kg * 1e-3);
        let weight = vehicle.mass_kg * STANDARD_GRAVITY;
        Ok(match (file.curve_formula, &file.curve_table) {
            (CurveFormula::Degree, _) => Self::Proportional(0.0004 * weight * DEGREES),
            (CurveFormula::Roeckl, _) => Self::Roeckl(weight * 1e-3),
            (CurveFormula::Table, Some(table)) => Self::Table(LinearTable::new(
                table.per_km.iter().map(|k| k * 1e-3).collect(),
                table.resistance_n_per_t.iter().map(|r| r * tonnes).collect(),
            )?),
            (CurveFormula::Radius | CurveFormula::Table, _) => {
                Self::Proportional(file.curve_n_m_per_t * tonnes)
            }
        })
    }

    /// Greatest force against the motion where the track has a curvature, 1/m, in N.
    #[inline]
    pub fn force(&self, curvature: f64) -> f64 {
        let curvature = curvature.abs();
        match self {
            Self::Proportional(strength) => strength * curvature,
            Self::Roeckl(_) if curvature == 0.0 => 0.0,
            Self::Roeckl(weight) => match 1.0 / curvature {
                radius if radius >= 300.0 => weight * 650.0 / (radius - 55.0),
                radius => weight * 500.0 / (radius.max(SMALLEST_RADIUS) - 30.0),
            },
            Self::Table(table) => table.value(curvature, &mut 0),
        }
    }
}
