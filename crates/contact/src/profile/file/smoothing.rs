//! An outline without the roughness that a measurement has.
//!
//! Lateral coordinate and height are functions of the length s along the outline. At each point both
//! are fitted by a parabola over s, with the weights of a Gauss curve
//!
//! ```text
//! w = exp(−(s − s_i)²/(2 σ²)) Δs,   σ = 0.2916 λ                                                   (P1)
//! ```
//!
//! (a Gaussian regression filter of second order, ISO 16610-31 without its robust weights). Of a wave
//! of the length L it leaves (1 + q) exp(−q) with q = (2 π σ/L)²/2: half at the cut-off wavelength λ, as
//! ISO 16610-21 defines it, 97 % at 2.6 λ and 1 % at 0.5 λ. The filter of that standard, the plain mean
//! with Gauss's weights (σ = 0.187 λ), would lift a flange root of R 13 mm by σ²/(2 R), 22 µm at
//! λ = 4 mm; a parabola has no such error, and where an arc of 13 mm meets a plane it leaves 5 µm.

use crate::profile::spline::lengths;

/// σ over the cut-off wavelength: half of the amplitude where (1 + q) exp(−q) = 1/2, q = 1.678 347.
const SIGMA: f64 = 0.291_595;

/// How far the weights reach, in σ.
const REACH: f64 = 4.0;

/// Least determinant of a fit, of the cube of the weights: with less the points do not tell a parabola.
const LEAST_DETERMINANT: f64 = 1e-6;

/// What smoothing took away, as distances from the outline.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Roughness {
    /// Root of the mean square, m.
    pub rms: f64,
    /// Largest distance, m.
    pub largest: f64,
    /// Lateral coordinate at which it is, m.
    pub at: f64,
}

/// The outline without waves shorter than the cut-off `wavelength` (m), and what was taken away.
pub(super) fn smoothed(points: &[[f64; 2]], wavelength: f64) -> (Vec<[f64; 2]>, Roughness) {
    if wavelength <= 0.0 {
        return (points.to_vec(), Roughness::default());
    }
    let sigma = SIGMA * wavelength;
    // Roughness makes the line longer: the length is that of the line smoothed once.
    let once = fitted(points, &lengths(points), sigma);
    let smooth = fitted(points, &lengths(&once), sigma);
    let roughness = roughness(points, &smooth);
    (smooth, roughness)
}

/// The parabolas' values at each point.
fn fitted(points: &[[f64; 2]], lengths: &[f64], sigma: f64) -> Vec<[f64; 2]> {
    let last = lengths.len() - 1;
    let share = |i: usize| 0.5 * (lengths[(i + 1).min(last)] - lengths[i.saturating_sub(1)]);
    let (mut begin, mut end) = (0, 0);
    let fit = |i: usize| {
        while lengths[i] - lengths[begin] > REACH * sigma {
            begin += 1;
        }
        while end <= last && lengths[end] - lengths[i] <= REACH * sigma {
            end += 1;
        }
        let (mut moments, mut sums) = ([0.0; 5], [[0.0; 3]; 2]);
        for j in begin..end {
            let u = (lengths[j] - lengths[i]) / sigma;
            let weight = libm::exp(-0.5 * u * u) * share(j);
            let powers = [1.0, u, u * u, u * u * u, u * u * u * u];
            for (moment, power) in moments.iter_mut().zip(powers) {
                *moment += weight * power;
            }
            for (sum, (value, centre)) in sums.iter_mut().zip(points[j].iter().zip(points[i])) {
                for (part, power) in sum.iter_mut().zip(powers) {
                    *part += weight * power * (value - centre);
                }
            }
        }
        let [m0, m1, m2, m3, m4] = moments;
        let cofactors = [m2 * m4 - m3 * m3, m2 * m3 - m1 * m4, m1 * m3 - m2 * m2];
        let determinant = m0 * cofactors[0] + m1 * cofactors[1] + m2 * cofactors[2];
        if determinant <= LEAST_DETERMINANT * m0 * m0 * m0 {
            return points[i];
        }
        let value = |k: usize| {
            let dot: f64 = sums[k].iter().zip(cofactors).map(|(sum, by)| sum * by).sum();
            points[i][k] + dot / determinant
        };
        [value(0), value(1)]
    };
    (0..=last).map(fit).collect()
}

/// How far the points lie from the smooth outline.
fn roughness(points: &[[f64; 2]], smooth: &[[f64; 2]]) -> Roughness {
    let last = smooth.len() - 1;
    let mut found = Roughness::default();
    for (i, (point, on)) in points.iter().zip(smooth).enumerate() {
        let (before, after) = (smooth[i.saturating_sub(1)], smooth[(i + 1).min(last)]);
        let (along, down) = (after[0] - before[0], after[1] - before[1]);
        let across = (point[1] - on[1]) * along - (point[0] - on[0]) * down;
        let distance = across.abs() / libm::hypot(along, down).max(f64::MIN_POSITIVE);
        found.rms += distance * distance;
        if distance > found.largest {
            (found.largest, found.at) = (distance, on[0]);
        }
    }
    found.rms = (found.rms / points.len() as f64).sqrt();
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    const WAVELENGTH: f64 = 4e-3;

    /// A wave on a level outline keeps the share of (P1)'s transmission. Tolerance: the ends.
    #[test]
    fn analytic_what_a_wave_keeps_of_its_amplitude() {
        for (length, kept) in [(4e-3, 0.5), (10.4e-3, 0.97), (2e-3, 0.0098)] {
            let wave = |y: f64| 1e-7 * (TAU * y / length).sin();
            let points: Vec<_> =
                (0..1000).map(|i| f64::from(i) * 1e-4).map(|y| [y, wave(y)]).collect();
            let (smooth, _) = smoothed(&points, WAVELENGTH);
            let dot = |heights: &[[f64; 2]]| -> f64 {
                heights[200..800].iter().map(|p| p[1] * wave(p[0])).sum()
            };
            let share = dot(&smooth) / dot(&points);
            assert!((share - kept).abs() < 5e-3, "{share} of {length} m");
        }
    }

    /// A parabola over the length is fitted exactly, an arc but for σ⁴/R³; so no radius grows.
    #[test]
    fn analytic_arcs_keep_their_radius() {
        for (radius, tolerance) in [(0.013, 1e-7), (0.3, 1e-11)] {
            let point = |i: i32| {
                let angle = 1e-4 * f64::from(i - 100) / radius;
                [radius * angle.sin(), radius * (1.0 - angle.cos())]
            };
            let points: Vec<[f64; 2]> = (0..=200).map(point).collect();
            let (smooth, roughness) = smoothed(&points, WAVELENGTH);
            for [y, z] in &smooth {
                let distance = y.hypot(radius - z) - radius;
                assert!(distance.abs() < 10.0 * tolerance, "{distance} m off R {radius} m");
            }
            assert!(roughness.rms < 5.0 * tolerance);
        }
    }

    /// Points farther apart than the weights reach stay as they are.
    #[test]
    fn property_few_points_are_kept() {
        let points = [[0.0, 0.0], [0.01, 1e-3], [0.02, 0.0], [0.03, 2e-3], [0.04, 1e-3]];
        assert_eq!(smoothed(&points, WAVELENGTH).0, points);
    }

    #[test]
    fn what_is_taken_away_is_told() {
        let mut points: Vec<[f64; 2]> = (0..400).map(|i| [2.5e-4 * f64::from(i), 0.0]).collect();
        points[100][1] = 20e-6;
        let (_, roughness) = smoothed(&points, WAVELENGTH);
        assert!((15e-6..20e-6).contains(&roughness.largest), "{roughness:?}");
        assert!((roughness.at - 0.025).abs() < 1e-4);
        assert!((0.7e-6..1.1e-6).contains(&roughness.rms));
    }
}
