//! Error measures of a field.

use field::FieldError;
use numerics::seconds;
use serde::Serialize;

use super::errors::difference;
use super::texts::{percent, shown};

/// How far a variable of a field is from that of another run.
///
/// It is over the snapshots of times that both have. A difference is the other's value less the first's, in K. What is infinite is `null` in JSON.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FieldErrors {
    /// Name of the field, such as `rail.zarr`.
    pub field: String,
    /// Variable: `temperature_rise`, or `section_rise` at the probes.
    pub variable: &'static str,
    /// Number of snapshots of times that both have.
    pub count: usize,
    /// Number of values that are compared.
    pub values: usize,
    /// Largest size of a difference, K.
    pub max_abs: f64,
    /// When it is, s.
    pub at_s: f64,
    /// Where it is along the track, m.
    pub chainage_m: f64,
    /// How far below the running surface, m.
    pub depth_m: f64,
    /// How far to the right of the rail's middle, m; only of a section.
    pub lateral_m: Option<f64>,
    /// Root of the mean square of all differences, K.
    pub rms: f64,
    /// `max_abs` over the largest size in the first run; infinite where that is zero.
    pub relative: f64,
}

/// Where a value of a snapshot lies: chainage, depth, and how far to the right, m.
pub(super) type Position = (f64, f64, Option<f64>);

impl FieldErrors {
    /// The errors of a variable, of its name, whose values lie at these positions at each of the times.
    ///
    /// `rises` gives the first and the other run's values at a time.
    pub(super) fn of(
        (field, variable): (&str, &'static str),
        times: &[f64],
        positions: &[Position],
        rises: impl Fn(f64) -> Result<[Vec<f32>; 2], FieldError>,
    ) -> Result<Self, FieldError> {
        let mut errors = Self {
            field: field.to_owned(),
            variable,
            count: times.len(),
            values: 0,
            max_abs: -1.0,
            at_s: 0.0,
            chainage_m: 0.0,
            depth_m: 0.0,
            lateral_m: None,
            rms: 0.0,
            relative: 0.0,
        };
        let (mut squares, mut scale) = (0.0, 0.0_f64);
        for &time in times {
            let [first, other] = rises(time)?;
            for ((a, b), position) in first.into_iter().zip(other).zip(positions) {
                let (a, b) = (f64::from(a), f64::from(b));
                let difference = difference(a, b);
                if difference.abs() > errors.max_abs {
                    (errors.max_abs, errors.at_s) = (difference.abs(), time);
                    (errors.chainage_m, errors.depth_m, errors.lateral_m) = *position;
                }
                squares += difference * difference;
                scale = if a.is_finite() { scale.max(a.abs()) } else { scale };
                errors.values += 1;
            }
        }
        errors.max_abs = errors.max_abs.max(0.0);
        errors.rms = (squares / errors.values.max(1) as f64).sqrt();
        errors.relative = if errors.max_abs == 0.0 { 0.0 } else { errors.max_abs / scale };
        Ok(errors)
    }

    /// The relative, the largest and the mean square difference as people read them.
    pub fn texts(&self) -> [String; 3] {
        [percent(self.relative), shown(self.max_abs, "K"), shown(self.rms, "K")]
    }

    /// Where and when the difference is largest.
    pub fn position(&self) -> String {
        let beside = match self.lateral_m {
            None => String::new(),
            Some(lateral) => {
                let side = if lateral < 0.0 { "left" } else { "right" };
                format!(", {:.0} mm to the {side} of the middle", 1e3 * lateral.abs())
            }
        };
        let (depth, at) = (1e3 * self.depth_m, seconds(self.at_s));
        format!("chainage {:.1} m, {depth:.0} mm deep{beside}, at {at} s", self.chainage_m)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: differences 0, 1 and -3, 0 at two times.
    #[test]
    fn analytic_errors_of_a_field() {
        let positions = [(10.0, 0.005, None), (10.0, 0.015, None)];
        let errors = FieldErrors::of(("rail.zarr", "rise"), &[0.0, 5.0], &positions, |time| {
            let first = vec![1.0, 6.0];
            Ok([first, if time == 0.0 { vec![1.0, 7.0] } else { vec![-2.0, 6.0] }])
        });
        let errors = errors.unwrap();
        assert_eq!((errors.max_abs, errors.at_s, errors.depth_m), (3.0, 5.0, 0.005));
        assert_eq!((errors.count, errors.values, errors.relative), (2, 4, 0.5));
        assert!((errors.rms - 2.5_f64.sqrt()).abs() < 1e-12);
        assert_eq!(errors.position(), "chainage 10.0 m, 5 mm deep, at 5 s");
    }
}
