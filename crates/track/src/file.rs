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
//! The sections `[irregularity]`, `[support]` and `[[friction]]` are those of `irregularity/file.rs`,
//! `support.rs` and `friction.rs`.

use std::path::Path;

use numerics::Interpolation;
use serde::Deserialize;

use crate::error::TrackError;
use crate::track::Track;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct TrackFile {
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
    /// Read by [`crate::Irregularity`]; stands here so that a wrong key in it is refused.
    #[serde(default, rename = "irregularity")]
    pub _irregularity: Option<crate::irregularity::Section>,
    /// Read by [`crate::Support`].
    #[serde(default, rename = "support")]
    pub _support: Option<crate::support::Section>,
    /// Read by [`crate::Friction`].
    #[serde(default, rename = "friction")]
    pub _friction: Vec<crate::friction::Point>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Element {
    pub length_m: f64,
    #[serde(default)]
    pub transition: bool,
    pub radius_m: Option<f64>,
    #[serde(default)]
    pub cant_mm: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CurvaturePoint {
    pub chainage_m: f64,
    pub per_km: f64,
    #[serde(default)]
    pub cant_mm: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct GradientPoint {
    pub chainage_m: f64,
    pub permille: f64,
}

/// What lies between two points.
#[derive(Clone, Copy, Default, Deserialize)]
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

impl Track {
    /// Reads a track file.
    ///
    /// # Errors
    /// When the file cannot be read or a value in it is not possible.
    pub fn from_file(file: &Path) -> Result<Self, TrackError> {
        let name = file.display().to_string();
        let text = std::fs::read_to_string(file)
            .map_err(|source| TrackError::Read { file: name.clone(), source })?;
        Self::from_toml(&text, &name)
    }

    /// Compiles the text of a track file; `name` stands in the error messages.
    ///
    /// # Errors
    /// When a value is not possible.
    pub fn from_toml(text: &str, name: &str) -> Result<Self, TrackError> {
        let content: TrackFile = toml::from_str(text).map_err(|source| TrackError::Syntax {
            file: name.to_owned(),
            source: Box::new(source),
        })?;
        content.check(name)?;
        content.compile(name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::track::TrackPoint;

    const CURVE: &str = "
        start_m = 300.0
        alignment = [
            { length_m = 50.0, transition = true },
            { length_m = 600.0, radius_m = 800.0, cant_mm = 75.0 },
            { length_m = 50.0, transition = true },
        ]
        gradient = [
            { chainage_m = 0.0, permille = 0.0 },
            { chainage_m = 100.0, permille = 10.0 },
        ]";

    fn at(track: &Track, chainage: f64) -> TrackPoint {
        track.at(chainage, &mut 0)
    }

    /// A transition of length l to radius R turns the heading by l/2R (clothoid).
    #[test]
    fn analytic_heading_of_a_curve_with_transitions() {
        let track = Track::from_toml(CURVE, "curve").unwrap();
        assert_eq!(at(&track, 299.0).curvature, 0.0);
        assert!((at(&track, 325.0).curvature - 0.5 / 800.0).abs() < 1e-15);
        assert!((at(&track, 350.0).heading - 25.0 / 800.0).abs() < 1e-15);
        assert!((at(&track, 2000.0).heading - 650.0 / 800.0).abs() < 1e-12);
        assert_eq!(at(&track, 1001.0).curvature, 0.0);
        assert_eq!(track.curves(), [[300.0, 1000.0]]);
        assert!((at(&track, 500.0).cant_angle - 0.05_f64.asin()).abs() < 1e-15);
    }

    /// In a circle the lateral offset from the tangent is s²/2R (small angles).
    #[test]
    fn analytic_offset_from_the_tangent() {
        let track = Track::from_toml(CURVE, "curve").unwrap();
        let (from, to) = (at(&track, 500.0), at(&track, 510.0));
        let offset = to.heading_integral - from.heading_integral - 10.0 * from.heading;
        assert!((offset - 100.0 / 1600.0).abs() < 1e-12);
    }

    #[test]
    fn analytic_elevation_is_the_integral_of_the_gradient() {
        let track = Track::from_toml(CURVE, "curve").unwrap();
        assert!((at(&track, 100.0).elevation - 0.5).abs() < 1e-12);
        assert!((at(&track, 1100.0).elevation - 10.5).abs() < 1e-12);
        assert_eq!(at(&track, -100.0).elevation, 0.0);
    }

    /// A spline through (0, 0), (100, 10), (300, 0) permille, and a step to 5 permille.
    #[test]
    fn analytic_gradient_by_a_spline_and_a_step() {
        let text = "gradient_interpolation = 'cubic'
            gradient = [
                { chainage_m = 0, permille = 0 }, { chainage_m = 100, permille = 10 },
                { chainage_m = 300, permille = 0 }, { chainage_m = 300, permille = 5 },
            ]";
        let track = Track::from_toml(text, "spline").unwrap();
        // By hand: the slopes at the ends are 0.1 and -0.05, so the slope m at 100 m follows from
        // 0.1/100 + 2 m (1/100 + 1/200) - 0.05/200 = 3 (0.1/100 - 0.05/200): m = 0.05 permille/m.
        let slope = at(&track, 100.0).gradient_slope;
        assert!((slope - 0.05e-3).abs() < 1e-15, "{slope}");
        assert!((at(&track, 100.0).gradient - 10e-3).abs() < 1e-15);
        assert_eq!(at(&track, 300.0).gradient, 5e-3);
        // The elevation is the integral of the gradient: Simpson's rule is exact for a cubic.
        let mean = |a: f64, b: f64| {
            let at = |x: f64| at(&track, x).gradient;
            (at(a) + 4.0 * at((a + b) / 2.0) + at(b)) / 6.0
        };
        let expected = mean(100.0, 250.0) * 150.0;
        let rise = at(&track, 250.0).elevation - at(&track, 100.0).elevation;
        assert!((rise - expected).abs() < 1e-13);
    }

    /// The mean elevation over a length is what a vehicle's potential energy needs.
    #[test]
    fn analytic_elevation_integral_of_a_constant_slope() {
        let track = Track::from_toml(CURVE, "curve").unwrap();
        let (from, to) = (at(&track, 200.0), at(&track, 300.0));
        let mean = (to.elevation_integral - from.elevation_integral) / 100.0;
        assert!((mean - at(&track, 250.0).elevation).abs() < 1e-12);
    }

    #[test]
    fn analytic_curvature_by_points() {
        let text = "curvature = [
            { chainage_m = -50, per_km = 0 }, { chainage_m = 0, per_km = 2, cant_mm = 75 },
            { chainage_m = 100, per_km = 2, cant_mm = 75 }, { chainage_m = 150, per_km = 0 }]";
        let track = Track::from_toml(text, "points").unwrap();
        assert!((at(&track, -25.0).curvature - 1e-3).abs() < 1e-15);
        assert_eq!(at(&track, 50.0).curvature, 2e-3);
        assert!((at(&track, 50.0).cant_angle - 0.05_f64.asin()).abs() < 1e-15);
        assert!((at(&track, 200.0).heading - 0.3).abs() < 1e-14);
        assert_eq!(track.curves(), [[-50.0, 150.0]]);
    }

    #[test]
    fn curvature_twice_is_refused() {
        let text = "alignment = [{ length_m = 1 }]\ncurvature = [{ chainage_m = 0, per_km = 1 }]";
        let message = Track::from_toml(text, "t.toml").err().unwrap().to_string();
        assert!(message.contains("curvature[1].per_km = 1: leave either"), "{message}");
    }

    #[test]
    fn a_step_at_the_first_point_is_refused() {
        let text =
            "gradient = [{ chainage_m = 0, permille = 1 }, { chainage_m = 0, permille = 2 }]";
        let message = Track::from_toml(text, "t.toml").err().unwrap().to_string();
        assert!(message.contains("gradient[2].chainage_m = 0: a step needs"), "{message}");
    }

    #[test]
    fn a_chainage_that_goes_back_is_refused() {
        let text =
            "gradient = [{ chainage_m = 9, permille = 1 }, { chainage_m = 8, permille = 1 }]";
        let message = Track::from_toml(text, "t.toml").err().unwrap().to_string();
        assert!(message.contains("gradient: row 2: "), "{message}");
    }

    #[test]
    fn radius_of_zero_is_refused_with_key_and_remedy() {
        let error = Track::from_toml("alignment = [{ length_m = 1.0, radius_m = 0.0 }]", "t.toml");
        let message = error.unwrap_err().to_string();
        assert!(message.starts_with("track file t.toml: alignment[1].radius_m = 0: must be"));
    }

    #[test]
    fn unknown_key_is_refused_with_its_line() {
        let error = Track::from_toml("start_m = 0.0\nlenght = 3\n", "t.toml");
        assert!(error.unwrap_err().to_string().contains("line 2"));
    }
}
