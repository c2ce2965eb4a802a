//! What the values of a track file must be.

use crate::error::TrackError;
use crate::file::{CurvaturePoint, Element, GradientPoint, TrackFile};

/// Greatest curvature, 1/km: that of the smallest radius, 50 m.
const GREATEST_CURVATURE: f64 = 20.0;

/// Refuses the value of a key of `file` unless it is possible.
fn ensure(
    file: &str,
    possible: bool,
    key: impl FnOnce() -> String,
    value: f64,
    wanted: &'static str,
) -> Result<(), TrackError> {
    match possible {
        true => Ok(()),
        false => Err(TrackError::Value { file: file.to_owned(), key: key(), value, wanted }),
    }
}

impl TrackFile {
    pub(crate) fn check(&self, file: &str) -> Result<(), TrackError> {
        let wanted = "must be a finite chainage in metres";
        ensure(file, self.start_m.is_finite(), || "start_m".into(), self.start_m, wanted)?;
        for (i, element) in self.alignment.iter().enumerate() {
            element.check(file, |name| format!("alignment[{}].{name}", i + 1))?;
        }
        for (i, point) in self.curvature.iter().enumerate() {
            point.check(file, |name| format!("curvature[{}].{name}", i + 1))?;
        }
        for (i, point) in self.gradient.iter().enumerate() {
            point.check(file, |name| format!("gradient[{}].{name}", i + 1))?;
        }
        match (self.alignment.is_empty(), self.curvature.first()) {
            (false, Some(point)) => {
                let wanted = "leave either [[alignment]] or [[curvature]] out";
                ensure(file, false, || "curvature[1].per_km".into(), point.per_km, wanted)
            }
            _ => Ok(()),
        }
    }
}

impl Element {
    fn check(&self, file: &str, key: impl Fn(&str) -> String) -> Result<(), TrackError> {
        let Self { length_m, transition, radius_m, cant_mm } = *self;
        let possible = length_m.is_finite() && length_m > 0.0;
        ensure(file, possible, || key("length_m"), length_m, "must be greater than zero")?;
        if let Some(radius) = radius_m {
            let possible = radius.is_finite() && radius.abs() >= 50.0;
            let wanted = "must be at least 50 m (negative: left-hand curve); \
                          leave it out for straight track";
            ensure(file, possible, || key("radius_m"), radius, wanted)?;
        }
        check_cant(file, cant_mm, &key)?;
        let neighbours = "a transition takes curvature and cant from its neighbours; \
                          leave radius_m and cant_mm out";
        let possible = !transition || (radius_m.is_none() && cant_mm == 0.0);
        let radius = radius_m.unwrap_or_default();
        ensure(file, possible, || key("radius_m"), radius, neighbours)
    }
}

impl CurvaturePoint {
    fn check(&self, file: &str, key: impl Fn(&str) -> String) -> Result<(), TrackError> {
        let possible = self.per_km.abs() <= GREATEST_CURVATURE;
        let wanted = "must lie between -20 and 20, the curvature of a radius of 50 m";
        ensure(file, possible, || key("per_km"), self.per_km, wanted)?;
        check_cant(file, self.cant_mm, key)
    }
}

impl GradientPoint {
    fn check(&self, file: &str, key: impl Fn(&str) -> String) -> Result<(), TrackError> {
        let possible = (-100.0..=100.0).contains(&self.permille);
        let wanted = "must lie between -100 and 100";
        ensure(file, possible, || key("permille"), self.permille, wanted)
    }
}

fn check_cant(file: &str, cant_mm: f64, key: impl Fn(&str) -> String) -> Result<(), TrackError> {
    let possible = (-300.0..=300.0).contains(&cant_mm);
    ensure(file, possible, || key("cant_mm"), cant_mm, "must lie between -300 and 300 mm")
}
