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
use serde::Deserialize;

use crate::speed_limit::SpeedLimit;
use crate::{friction, irregularity, support};

/// What a track file says.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Content {
    #[serde(default)]
    pub start_m: f64,
    #[serde(default)]
    pub alignment: Vec<Element>,
    #[serde(default)]
    pub curvature: Vec<CurvaturePoint>,
    #[serde(default)]
    pub curvature_interpolation: Between,
    #[serde(default)]
    pub gradient: Vec<GradientPoint>,
    #[serde(default)]
    pub gradient_interpolation: Between,
    #[serde(default)]
    pub irregularity: irregularity::Section,
    pub support: Option<support::Section>,
    #[serde(default)]
    pub friction: Vec<friction::Point>,
    #[serde(default)]
    pub speed_limit: Vec<SpeedLimit>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Element {
    pub length_m: f64,
    #[serde(default)]
    pub transition: bool,
    pub radius_m: Option<f64>,
    #[serde(default)]
    pub cant_mm: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CurvaturePoint {
    pub chainage_m: f64,
    pub per_km: f64,
    #[serde(default)]
    pub cant_mm: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct GradientPoint {
    pub chainage_m: f64,
    pub permille: f64,
}

/// What lies between two points.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Between {
    #[default]
    Linear,
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
