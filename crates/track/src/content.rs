//! The track file: TOML, an alignment of elements, and gradients and curvatures by points.
//!
//! ```toml
//! start_m = 300.0            # chainage at which the first element begins
//! [[alignment]]
//! length_m = 50.0
//! transition = true          # curvature and cant go linearly to the next element's
//! [[alignment]]
//! length_m = 600.0
//! radius_m = 800.0           # positive: right-hand curve; left out: straight
//! cant_mm = 60.0
//! [[alignment]]
//! length_m = 50.0
//! transition = true
//! [[gradient]]               # constant outside the points
//! chainage_m = 0.0
//! permille = 2.0
//! ```
//!
//! Instead of the alignment, the curvature may be given by points, `[[curvature]]` with
//! `chainage_m`, `per_km` (1000 m over the radius) and `cant_mm`. Between the points the values go
//! linearly, or, with `gradient_interpolation = "cubic"` or `curvature_interpolation = "cubic"`, by a
//! cubic spline. A chainage that stands twice is a step, and the end of a spline.
//!
//! The sections `[irregularity]`, `[support]`, `[[friction]]` and `[[speed_limit]]` are those of
//! `irregularity/file.rs`, `support.rs`, `friction.rs` and `speed_limit.rs`.

use numerics::Interpolation;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::speed_limit::SpeedLimit;
use crate::{friction, irregularity, support};

/// What a track file says.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Content {
    /// Chainage at which the first element of the alignment begins, m.
    #[serde(default)]
    pub start_m: f64,
    /// Elements of the designed line, one behind the other; instead of `curvature`.
    #[serde(default)]
    pub alignment: Vec<Element>,
    /// Curvature and cant by points; instead of `alignment`.
    #[serde(default)]
    pub curvature: Vec<CurvaturePoint>,
    /// What lies between the points of the curvature.
    #[serde(default)]
    pub curvature_interpolation: Between,
    /// Gradient by points; constant before the first and behind the last.
    #[serde(default)]
    pub gradient: Vec<GradientPoint>,
    /// What lies between the points of the gradient.
    #[serde(default)]
    pub gradient_interpolation: Between,
    /// Irregularities of the rails.
    #[serde(default)]
    pub irregularity: irregularity::Section,
    /// What the rails give way on; left out: they do not give way.
    pub support: Option<support::Section>,
    /// How slippery the rails are, by points.
    #[serde(default)]
    pub friction: Vec<friction::Point>,
    #[serde(default)]
    pub speed_limit: Vec<SpeedLimit>,
}

/// An element of the alignment.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Element {
    /// Length, m.
    pub length_m: f64,
    /// Whether curvature and cant go linearly to the next element's.
    #[serde(default)]
    pub transition: bool,
    /// Radius, m, positive in a right-hand curve; left out: straight.
    pub radius_m: Option<f64>,
    /// Cant, mm.
    #[serde(default)]
    pub cant_mm: f64,
}

/// A point of the curvature.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct CurvaturePoint {
    /// Where, m.
    pub chainage_m: f64,
    /// 1000 m over the radius, 1/km, positive in a right-hand curve.
    pub per_km: f64,
    /// Cant, mm.
    #[serde(default)]
    pub cant_mm: f64,
}

/// A point of the gradient.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct GradientPoint {
    /// Where, m.
    pub chainage_m: f64,
    /// Rise of the track, ‰, positive uphill.
    pub permille: f64,
}

/// What lies between two points.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Between {
    /// A straight line.
    #[default]
    Linear,
    /// A cubic spline.
    Cubic,
}

impl From<Between> for Interpolation {
    fn from(between: Between) -> Self {
        match between {
            Between::Linear => Self::Linear,
            Between::Cubic => Self::Cubic,
        }
    }
}
