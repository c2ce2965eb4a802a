//! How slippery the rails are along the track: points `[[friction]]` of a track file.
//!
//! ```toml
//! [[friction]]                         # left out: 1 everywhere
//! chainage_m = 1000.0                  # a chainage that stands twice is a step
//! factor = 1.0
//! [[friction]]
//! chainage_m = 1000.0                  # from here on wet
//! factor = 0.5                         # times the friction coefficient of the vehicle
//! ```
//!
//! Linear between the points, constant outside them; the same for both rails.

use files::{Check, Mistake};
use numerics::{Interpolation, Piecewise};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::chainages::check_order;

/// Factor of the friction coefficient along the track.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Friction(Option<Piecewise>);

/// A point as it stands in the file.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Point {
    /// Where, m.
    chainage_m: f64,
    /// Factor of the vehicles' friction coefficient.
    factor: f64,
}

impl Friction {
    /// The friction by points, if their values are possible.
    pub(crate) fn compile(points: &[Point], check: &Check) -> Result<Self, Mistake> {
        if points.is_empty() {
            return Ok(Self(None));
        }
        for (i, point) in points.iter().enumerate() {
            check.element("friction", i).between("factor", point.factor, 0.05, 3.0)?;
        }
        check_order(check, "friction", points.iter().map(|point| point.chainage_m))?;
        let (chainages, factors): (Vec<f64>, Vec<f64>) =
            points.iter().map(|point| (point.chainage_m, point.factor)).unzip();
        let factor = Piecewise::new(chainages, &factors, Interpolation::Linear);
        factor.map(Some).map(Self).map_err(|error| check.refuse("friction", error.to_string()))
    }

    /// The factor at a chainage; `index` is any number at first and that of the last lookup later.
    #[inline]
    pub fn factor(&self, chainage: f64, index: &mut usize) -> f64 {
        self.0.as_ref().map_or(1.0, |factor| factor.value(chainage, index))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TrackFile;

    fn friction(text: &str) -> Result<Friction, Mistake> {
        TrackFile::new(text, "t.toml")?.friction()
    }

    #[test]
    fn analytic_a_wet_stretch_dries() {
        let text = "friction = [
            { chainage_m = 100.0, factor = 1.0 }, { chainage_m = 100.0, factor = 0.5 },
            { chainage_m = 200.0, factor = 0.5 }, { chainage_m = 300.0, factor = 1.0 }]";
        let wet = friction(text).unwrap();
        let at = |chainage| wet.factor(chainage, &mut 0);
        assert_eq!([0.0, 150.0, 250.0, 400.0].map(at), [1.0, 0.5, 0.75, 1.0]);
        assert_eq!(friction("").unwrap().factor(7.0, &mut 0), 1.0);
    }

    /// Three zones with a leaf film between them: the factor at the middle of each piece is the mean
    /// of its ends, and outside the outermost holds.
    #[test]
    fn analytic_zones_along_the_track() {
        let text = "friction = [
            { chainage_m = 0.0, factor = 1.0 }, { chainage_m = 40.0, factor = 0.2 },
            { chainage_m = 60.0, factor = 0.2 }, { chainage_m = 60.0, factor = 1.4 },
            { chainage_m = 100.0, factor = 0.8 }]";
        let zones = friction(text).unwrap();
        let expected = [
            (-1e6, 1.0),
            (20.0, 0.6),
            (50.0, 0.2),
            (60.0, 1.4),
            (80.0, 1.1),
            (100.0, 0.8),
            (1e6, 0.8),
        ];
        let mut index = 3;
        for (chainage, factor) in expected {
            let found = zones.factor(chainage, &mut index);
            assert!((found - factor).abs() < 1e-15, "{found} at {chainage} m, not {factor}");
        }
    }

    #[test]
    fn zones_that_go_back_are_refused() {
        let text =
            "friction = [{ chainage_m = 9.0, factor = 1.0 }, { chainage_m = 8.0, factor = 1.0 }]";
        let message = friction(text).unwrap_err().to_string();
        assert!(
            message.contains("friction[2].chainage_m = 8.0: must not be less than 9"),
            "{message}"
        );
    }

    #[test]
    fn a_factor_of_zero_is_refused_with_its_key() {
        let text = "friction = [{ chainage_m = 0.0, factor = 0.0 }]";
        let message = friction(text).unwrap_err().to_string();
        assert!(
            message.contains("t.toml:1:42: friction[1].factor = 0.0: must lie between 0.05 and 3"),
            "{message}"
        );
    }
}
