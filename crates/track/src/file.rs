//! The track file: TOML, an alignment of elements and gradients by points.
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
//! [[gradient]]               # linear between points, constant outside
//! chainage_m = 0.0
//! permille = 2.0
//! ```

use std::path::Path;

use serde::Deserialize;

use crate::track::{Piece, Track, TrackPoint};

/// Distance between the middles of the two rail heads over which cant is measured, m.
const CANT_BASE: f64 = 1.5;

/// Why a track file cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum TrackError {
    /// The file cannot be read.
    #[error("track file {file}: {source}")]
    Read {
        /// File name.
        file: String,
        /// Reason.
        source: std::io::Error,
    },
    /// The file is not TOML, or has an unknown key or a wrong type.
    #[error("track file {file}: {source}")]
    Syntax {
        /// File name.
        file: String,
        /// Reason, with line and caret.
        source: Box<toml::de::Error>,
    },
    /// A value is not possible.
    #[error("track file {file}: {key} = {value}: {wanted}")]
    Value {
        /// File name.
        file: String,
        /// Key.
        key: String,
        /// Value found.
        value: f64,
        /// What would be right.
        wanted: &'static str,
    },
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TrackFile {
    #[serde(default)]
    start_m: f64,
    #[serde(default)]
    alignment: Vec<Element>,
    #[serde(default)]
    gradient: Vec<GradientPoint>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Element {
    length_m: f64,
    #[serde(default)]
    transition: bool,
    radius_m: Option<f64>,
    #[serde(default)]
    cant_mm: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct GradientPoint {
    chainage_m: f64,
    permille: f64,
}

/// A value at a chainage, linear up to the next one.
type Polyline = Vec<(f64, f64)>;

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
        Ok(content.compile())
    }
}

impl TrackFile {
    fn check(&self, file: &str) -> Result<(), TrackError> {
        let fail = |key: String, value: f64, wanted: &'static str| {
            Err(TrackError::Value { file: file.to_owned(), key, value, wanted })
        };
        if !self.start_m.is_finite() {
            return fail("start_m".into(), self.start_m, "must be a finite chainage in metres");
        }
        for (i, element) in self.alignment.iter().enumerate() {
            let key = |name: &str| format!("alignment[{}].{name}", i + 1);
            if !(element.length_m.is_finite() && element.length_m > 0.0) {
                return fail(key("length_m"), element.length_m, "must be greater than zero");
            }
            if let Some(radius) = element.radius_m
                && !(radius.is_finite() && radius.abs() >= 50.0)
            {
                let wanted = "must be at least 50 m (negative: left-hand curve); \
                              leave it out for straight track";
                return fail(key("radius_m"), radius, wanted);
            }
            if !(-300.0..=300.0).contains(&element.cant_mm) {
                return fail(key("cant_mm"), element.cant_mm, "must lie between -300 and 300 mm");
            }
            if element.transition && (element.radius_m.is_some() || element.cant_mm != 0.0) {
                let wanted = "a transition takes curvature and cant from its neighbours; \
                              leave radius_m and cant_mm out";
                return fail(key("radius_m"), element.radius_m.unwrap_or_default(), wanted);
            }
        }
        for (i, point) in self.gradient.iter().enumerate() {
            let key = |name: &str| format!("gradient[{}].{name}", i + 1);
            if !(-100.0..=100.0).contains(&point.permille) {
                return fail(key("permille"), point.permille, "must lie between -100 and 100");
            }
            if !point.chainage_m.is_finite()
                || (i > 0 && point.chainage_m <= self.gradient[i - 1].chainage_m)
            {
                let wanted = "must be greater than the chainage of the point before";
                return fail(key("chainage_m"), point.chainage_m, wanted);
            }
        }
        Ok(())
    }

    fn compile(&self) -> Track {
        let curvature =
            self.polyline(|element| element.radius_m.map_or(0.0, |radius| 1.0 / radius));
        let cant = self.polyline(|element| (element.cant_mm * 1e-3 / CANT_BASE).asin());
        let gradient: Polyline = match self.gradient.len() {
            0 => vec![(self.start_m, 0.0)],
            _ => self.gradient.iter().map(|p| (p.chainage_m, p.permille * 1e-3)).collect(),
        };
        let mut begins: Vec<f64> = [&curvature, &cant, &gradient]
            .iter()
            .flat_map(|line| line.iter().map(|p| p.0))
            .collect();
        begins.sort_by(f64::total_cmp);
        begins.dedup();

        let mut pieces: Vec<Piece> = Vec::with_capacity(begins.len());
        for (i, &begin) in begins.iter().enumerate() {
            let (curvature, curvature_slope) = value_and_slope(&curvature, begin);
            let (cant_angle, cant_angle_slope) = value_and_slope(&cant, begin);
            let (gradient, gradient_slope) = value_and_slope(&gradient, begin);
            let before = match i {
                0 => TrackPoint::default(),
                _ => pieces[i - 1].at(begin - begins[i - 1]),
            };
            let at = TrackPoint {
                curvature,
                curvature_slope,
                cant_angle,
                cant_angle_slope,
                gradient,
                gradient_slope,
                ..before
            };
            pieces.push(Piece { at });
        }
        Track { begins, pieces }
    }

    /// The ends of the elements with the value there: constant in an element, linear in a
    /// transition, a step where two constant elements meet (two points at one chainage).
    fn polyline(&self, value: impl Fn(&Element) -> f64) -> Polyline {
        let constant = |i: Option<usize>| {
            let element = i.and_then(|i| self.alignment.get(i)).filter(|e| !e.transition);
            element.map_or(0.0, &value)
        };
        let mut line = vec![];
        let mut chainage = self.start_m;
        for (i, element) in self.alignment.iter().enumerate() {
            let (from, to) = match element.transition {
                true => (constant(i.checked_sub(1)), constant(Some(i + 1))),
                false => (constant(Some(i)), constant(Some(i))),
            };
            line.push((chainage, from));
            chainage += element.length_m;
            line.push((chainage, to));
        }
        if line.is_empty() {
            line.push((self.start_m, 0.0));
        }
        line
    }
}

/// Value and slope of a polyline just after `chainage`; constant outside its points.
fn value_and_slope(line: &Polyline, chainage: f64) -> (f64, f64) {
    let after = line.partition_point(|point| point.0 <= chainage);
    match (after.checked_sub(1).map(|i| line[i]), line.get(after)) {
        (Some((x0, y0)), Some(&(x1, y1))) => {
            let slope = (y1 - y0) / (x1 - x0);
            (y0 + slope * (chainage - x0), slope)
        }
        (Some((_, y)), None) | (None, Some(&(_, y))) => (y, 0.0),
        (None, None) => (0.0, 0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
