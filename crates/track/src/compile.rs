//! From the track file to the compiled track.

use files::{Check, Mistake};
use numerics::{Interpolation, Piecewise};

use crate::content::{Content, Element};
use crate::track::{Piece, Track, TrackPoint};

/// Distance between the middles of the two rail heads over which cant is measured, m.
const CANT_BASE: f64 = 1.5;

/// Points of a function of the chainage: chainages, m, and values.
type Points = (Vec<f64>, Vec<f64>);

impl Content {
    pub(crate) fn compile(&self, check: &Check) -> Result<Track, Mistake> {
        let function = |key: &'static str, (chainages, values): Points, between: Interpolation| {
            if let [first, second, ..] = chainages[..]
                && first == second
            {
                let wanted = "a step needs a point before it, from which its first value holds";
                return Err(check.error(&format!("{key}[2].chainage_m"), second, wanted));
            }
            Piecewise::new(chainages, &values, between)
                .map_err(|error| check.refuse(key, error.to_string()))
        };
        let (curvature, cant) = self.curvature_and_cant();
        let between = self.curvature_interpolation.into();
        let curvature = function("curvature", curvature, between)?;
        let cant = function("curvature", cant, between)?;
        let between = self.gradient_interpolation.into();
        let gradient = function("gradient", self.gradient(), between)?;

        let mut begins = [curvature.x(), cant.x(), gradient.x()].concat();
        begins.sort_by(f64::total_cmp);
        begins.dedup();
        let mut pieces: Vec<Piece> = Vec::with_capacity(begins.len());
        for (i, &begin) in begins.iter().enumerate() {
            let before = match i {
                0 => TrackPoint::default(),
                _ => pieces[i - 1].at(begin - begins[i - 1]),
            };
            let functions = [&curvature, &cant, &gradient];
            let [curvature, cant_angle, gradient] = functions.map(|f| f.expansion(begin, &mut 0));
            let uniform = [curvature, cant_angle, gradient].iter().all(|c| c[1..] == [0.0; 3]);
            pieces.push(Piece {
                heading: before.heading,
                heading_integral: before.heading_integral,
                elevation: before.elevation,
                elevation_integral: before.elevation_integral,
                curvature,
                cant_angle,
                gradient,
                uniform,
            });
        }
        let before = pieces[0].as_at_its_beginning();
        Ok(Track { begins, pieces, before })
    }

    fn gradient(&self) -> Points {
        match self.gradient.len() {
            0 => (vec![self.start_m], vec![0.0]),
            _ => self.gradient.iter().map(|p| (p.chainage_m, p.permille * 1e-3)).unzip(),
        }
    }

    fn curvature_and_cant(&self) -> (Points, Points) {
        let angle = |cant_mm: f64| libm::asin(cant_mm * 1e-3 / CANT_BASE);
        if self.curvature.is_empty() {
            let curvature = |element: &Element| element.radius_m.map_or(0.0, |radius| 1.0 / radius);
            return (self.elements(curvature), self.elements(|e| angle(e.cant_mm)));
        }
        let points = self.curvature.iter();
        (
            points.clone().map(|p| (p.chainage_m, p.per_km * 1e-3)).unzip(),
            points.map(|p| (p.chainage_m, angle(p.cant_mm))).unzip(),
        )
    }

    /// The ends of the elements with the value there: constant in an element, linear in a
    /// transition, a step where two constant elements of different value meet.
    fn elements(&self, value: impl Fn(&Element) -> f64) -> Points {
        let constant = |i: Option<usize>| {
            let element = i.and_then(|i| self.alignment.get(i)).filter(|e| !e.transition);
            element.map_or(0.0, &value)
        };
        let (mut chainages, mut values) = (vec![self.start_m], vec![0.0]);
        for (i, element) in self.alignment.iter().enumerate() {
            let (from, to) = match element.transition {
                true => (constant(i.checked_sub(1)), constant(Some(i + 1))),
                false => (constant(Some(i)), constant(Some(i))),
            };
            let begin = chainages[chainages.len() - 1];
            if i == 0 {
                values[0] = from;
            } else if values[values.len() - 1] != from {
                chainages.push(begin);
                values.push(from);
            }
            chainages.push(begin + element.length_m);
            values.push(to);
        }
        (chainages, values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn track(text: &str) -> Track {
        Track::from_toml(text, "track.toml").unwrap()
    }

    fn at(track: &Track, chainage: f64) -> TrackPoint {
        track.at(chainage, &mut 0)
    }

    fn assert_close(found: f64, expected: f64, tolerance: f64) {
        assert!((found - expected).abs() <= tolerance, "{found}, expected {expected}");
    }

    /// A right-hand curve of 500 m and a left-hand one of 750 m, with cant and transitions.
    const S_CURVE: &str = "alignment = [
        { length_m = 80, transition = true },
        { length_m = 200, radius_m = 500, cant_mm = 90 },
        { length_m = 120, transition = true },
        { length_m = 300, radius_m = -750, cant_mm = -60 }]";

    /// The clothoid: curvature s/(R l), heading s²/(2 R l), offset from the tangent s³/(6 R l).
    /// Rounding.
    #[test]
    fn analytic_clothoid_from_the_straight() {
        let track = track(S_CURVE);
        for s in [0.0, 10.0, 40.0, 80.0] {
            let (point, radius_length) = (at(&track, s), 500.0 * 80.0);
            assert_close(point.curvature, s / radius_length, 1e-17);
            assert_close(
                point.curvature_slope,
                if s < 80.0 { 1.0 / radius_length } else { 0.0 },
                1e-18,
            );
            assert_close(point.heading, s * s / (2.0 * radius_length), 1e-15);
            assert_close(point.heading_integral, s.powi(3) / (6.0 * radius_length), 1e-13);
        }
    }

    /// A clothoid from one hand to the other turns by the mean of its curvatures times its length.
    /// It is straight where they cancel, (1/500) l/(1/500 + 1/750) behind its beginning.
    #[test]
    fn analytic_clothoid_between_two_hands() {
        let track = track(S_CURVE);
        let turned = at(&track, 400.0).heading - at(&track, 280.0).heading;
        assert_close(turned, 120.0 * (1.0 / 500.0 - 1.0 / 750.0) / 2.0, 1e-14);
        let inflection = 280.0 + 120.0 * (1.0 / 500.0) / (1.0 / 500.0 + 1.0 / 750.0);
        assert_close(at(&track, inflection).curvature, 0.0, 1e-17);
        assert!(at(&track, 500.0).curvature < 0.0);
    }

    /// Cant h over the base of 1.5 m is the angle asin(h/1.5 m), positive with the right rail lower.
    /// Over a transition it rises linearly. Rounding.
    #[test]
    fn analytic_cant_ramp() {
        let track = track(S_CURVE);
        let (right, left) = ((0.09 / 1.5_f64).asin(), -(0.06 / 1.5_f64).asin());
        assert_close(at(&track, 20.0).cant_angle, right / 4.0, 1e-17);
        assert_close(at(&track, 20.0).cant_angle_slope, right / 80.0, 1e-18);
        assert_close(at(&track, 200.0).cant_angle, right, 1e-17);
        assert_eq!(at(&track, 200.0).cant_angle_slope, 0.0);
        assert_close(at(&track, 340.0).cant_angle, (right + left) / 2.0, 1e-16);
        assert_close(at(&track, 340.0).cant_angle_slope, (left - right) / 120.0, 1e-17);
        assert_close(at(&track, 600.0).cant_angle, left, 1e-17);
    }

    /// Without a transition curvature and cant step from one value to the other.
    #[test]
    fn analytic_a_curve_without_transition_begins_with_a_step() {
        let track = track(
            "start_m = 10
            alignment = [{ length_m = 5 }, { length_m = 20, radius_m = 300, cant_mm = 30 }]",
        );
        assert_eq!(at(&track, 14.999_999).curvature, 0.0);
        assert_eq!(at(&track, 15.0).curvature, 1.0 / 300.0);
        assert_close(at(&track, 15.0).cant_angle, (0.03 / 1.5_f64).asin(), 1e-17);
    }

    /// A parabolic vertical curve from 8 ‰ up to 12 ‰ down over 400 m: the rise to s is
    /// g₁ s + (g₂ − g₁) s²/(2 l), so that the crest stands at 160 m, 0.64 m up. Rounding.
    #[test]
    fn analytic_vertical_curve_over_a_crest() {
        let track = track(
            "gradient = [{ chainage_m = 0, permille = 8 }, { chainage_m = 400, permille = -12 }]",
        );
        for s in [100.0, 160.0, 400.0] {
            let rise = 8e-3 * s - 20e-3 * s * s / 800.0;
            assert_close(at(&track, s).elevation, rise, 1e-14);
            let integral = 4e-3 * s * s - 20e-3 * s.powi(3) / 2400.0;
            assert_close(at(&track, s).elevation_integral, integral, 1e-12);
        }
        let crest = at(&track, 160.0);
        assert_close(crest.gradient, 0.0, 1e-17);
        assert_close(crest.elevation, 0.64, 1e-15);
        assert_close(crest.gradient_slope, -20e-3 / 400.0, 1e-18);
        // Beyond the last point its gradient holds.
        assert_close(at(&track, 500.0).elevation, -0.8 - 1.2, 1e-14);
    }

    /// The profile has both values of a step, and those of the outermost pieces.
    #[test]
    fn the_profile_has_the_ends_of_all_pieces() {
        let steps = "alignment = [{ length_m = 10, radius_m = 200 }, { length_m = 10 }]";
        let profile = track(steps).profile(100);
        let curvatures: Vec<_> = profile.iter().map(|(s, at)| (*s, at.curvature)).collect();
        let curved = [(0.0, 5e-3), (0.0, 5e-3), (10.0, 5e-3), (10.0, 0.0)];
        assert_eq!(curvatures[..4], curved);
        assert!(curvatures[4..].iter().all(|(_, curvature)| *curvature == 0.0), "{curvatures:?}");
        assert!(track(S_CURVE).profile(4).len() < track(S_CURVE).profile(100).len());
    }
}
