//! Equivalent conicity of a wheelset on its rails, as EN 15302 (UIC 519) defines it.
//!
//! A wheelset with the difference Δr(y) of its rolling radii (right less left) runs free of forces as
//!
//! ```text
//! d²y/ds² = -Δr(y)/(2 e r0)                                                                        (G4)
//! ```
//!
//! and the cone that has the same wavelength at the amplitude A has the equivalent conicity. y is the
//! displacement of the wheelset **at its contacts, without roll**: both wheels are shifted by it against
//! their rails, in opposite senses. Equation G4 is integrated once by its energy and once over half a
//! wave, from y₁ to y₂ = y₁ + 2 A, between which the wheelset swings; e and r0 drop out:
//!
//! ```text
//! G(y) = integral of Δr from y to y₂,   G(y₁) = 0
//! J = integral of dy/sqrt(G) from y₁ to y₂,   γ = (π/J)²                                           (G5)
//! ```
//!
//! A cone has Δr = 2 γ y and gets γ. Wheels or rails that differ swing about a place beside the middle.

use super::search::{Search, Touch};
use super::wheelset::WheelsetPairs;
use crate::error::ContactError;
use std::f64::consts::PI;

/// Distance of the displacements at which the radii are sought, in m.
const STEP: f64 = 1e-4;

/// How far beyond the greatest amplitude the radii are sought, in m: as far may the middle of a wave lie
/// aside.
const BEYOND: f64 = 0.005;

/// Intervals of the integral over half a wave.
const INTERVALS: usize = 800;

/// Halvings that find the middle of a wave.
const HALVINGS: usize = 60;

/// Conicity below which a wheelset does not swing: it is given as zero.
const LEAST: f64 = 1e-5;

/// Equivalent conicity over the amplitude.
#[derive(Clone, Debug)]
pub struct EquivalentConicity {
    step: f64,
    /// Displacement of the first value, in m.
    begin: f64,
    /// Δr in m at multiples of the step.
    difference: Vec<f64>,
    /// Integral of Δr from the first value, in m².
    integral: Vec<f64>,
}

impl EquivalentConicity {
    /// Of a wheelset, for amplitudes up to `greatest` metres.
    ///
    /// # Errors
    /// When a dimension of a pair is out of range or a wheel stands beside its rail.
    pub fn new(pairs: &WheelsetPairs, greatest: f64) -> Result<Self, ContactError> {
        pairs.check()?;
        let WheelsetPairs { left, right } = pairs;
        let (mut left_search, mut right_search) = (Search::new(left), Search::new(right));
        let mut difference_at = |i: i32| {
            let shift = f64::from(i) * STEP;
            let on_right = first(&right_search.shifted(shift)).ok_or((right, shift))?;
            let on_left = first(&left_search.shifted(-shift)).ok_or((left, -shift))?;
            let nominal = right.nominal_radius - left.nominal_radius;
            Ok::<f64, (&_, f64)>(nominal + on_right - on_left)
        };
        let needed = (greatest / STEP).ceil() as i32;
        let last = needed + (BEYOND / STEP) as i32;
        // Beyond what is needed a wheel may stand beside its rail; both sides end with it.
        let mut sides = [vec![], vec![]];
        for i in 0..=last {
            match [difference_at(-i), difference_at(i)] {
                [Ok(left), Ok(right)] => {
                    sides[0].push(left);
                    sides[1].push(right);
                }
                _ if i > needed => break,
                [Err((pair, shift)), _] | [_, Err((pair, shift))] => {
                    return Err(pair.no_contact(shift));
                }
            }
        }
        let [before, after] = sides;
        let values = before.into_iter().skip(1).rev().chain(after);
        Ok(Self::of_radii(STEP, values.collect()))
    }

    /// Of differences of the rolling radii (m) at multiples of `step` (m), the middle one in the middle.
    fn of_radii(step: f64, difference: Vec<f64>) -> Self {
        let mut sum = 0.0;
        let mut integral = vec![0.0];
        for pair in difference.windows(2) {
            sum += 0.5 * step * (pair[0] + pair[1]);
            integral.push(sum);
        }
        let begin = -0.5 * step * (difference.len() - 1) as f64;
        Self { step, begin, difference, integral }
    }

    /// The equivalent conicity at an `amplitude` in m, if there is one: zero where both wheels roll on the
    /// same radius.
    ///
    /// There is none without amplitude, beyond the greatest one, or where the radii do not steer the
    /// wheelset back.
    pub fn at(&self, amplitude: f64) -> Option<f64> {
        if amplitude.is_nan() || amplitude <= 0.0 || amplitude > -self.begin * (1.0 + 1e-12) {
            return None;
        }
        let waves = self.middles(amplitude).into_iter();
        let conicities = waves.filter_map(|middle| Some((middle, self.of(middle, amplitude)?)));
        let nearest = conicities.min_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        nearest.map(|(_, conicity)| conicity)
    }

    /// Δr/(2 y) at a displacement `y` in m to the right; nothing in the middle and beyond the radii.
    pub fn of_radii_at(&self, y: f64) -> Option<f64> {
        let position = (y - self.begin) / self.step;
        let last = (self.difference.len() - 1) as f64;
        if y == 0.0 || !(0.0..=last * (1.0 + 1e-12)).contains(&position) {
            return None;
        }
        let i = (position as usize).min(self.difference.len() - 2);
        let share = position - i as f64;
        let rise = self.difference[i + 1] - self.difference[i];
        Some((self.difference[i] + share * rise) / (2.0 * y))
    }

    /// Middles of the waves with this amplitude: places with the same energy at both ends.
    fn middles(&self, amplitude: f64) -> Vec<f64> {
        let room = (-self.begin - amplitude).max(0.0);
        let work = |middle: f64| {
            self.integral_to(middle + amplitude) - self.integral_to(middle - amplitude)
        };
        let count = (room / self.step).ceil() as i32;
        let middle_at = |i: i32| room * f64::from(i) / f64::from(count.max(1));
        let mut middles = vec![];
        // That of equal wheels is the middle of the track, but for rounding.
        if work(0.0).abs() <= LEAST * amplitude * amplitude {
            middles.push(0.0);
        }
        for i in -count..count {
            let (mut low, mut high) = (middle_at(i), middle_at(i + 1));
            let rises = work(low) < 0.0;
            if rises == (work(high) < 0.0) {
                continue;
            }
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                if (work(middle) < 0.0) == rises {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            middles.push(0.5 * (low + high));
        }
        middles
    }

    /// The conicity of the wave about `middle`, if the radii steer back to it from both ends.
    fn of(&self, middle: f64, amplitude: f64) -> Option<f64> {
        let end = self.integral_to(middle + amplitude);
        let start = self.integral_to(middle - amplitude);
        let mut sum = 0.0;
        let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        for i in 0..INTERVALS {
            // y = A sin t takes the infinities at the turning points out of the integral.
            let t = (i as f64 + 0.5) * PI / INTERVALS as f64 - 0.5 * PI;
            let (sine, cosine) = libm::sincos(t);
            // What rounding leaves between both ends is shared out.
            let level = 0.5 * (start + end) + 0.5 * sine * (end - start);
            let energy = level - self.integral_to(middle + amplitude * sine);
            let cone = energy / (amplitude * amplitude * cosine * cosine);
            (least, greatest) = (least.min(cone), greatest.max(cone));
            sum += amplitude * cosine / energy.max(0.0).sqrt();
        }
        if least.abs().max(greatest.abs()) <= LEAST {
            return Some(0.0);
        }
        (least > 0.0).then(|| (INTERVALS as f64 / sum).powi(2))
    }

    /// Integral of Δr, linear between its values, from the first one to `y` metres.
    fn integral_to(&self, y: f64) -> f64 {
        let position = (y - self.begin) / self.step;
        let i = (position.max(0.0) as usize).min(self.difference.len().saturating_sub(2));
        let share = position - i as f64;
        let rise = self.difference.get(i + 1).map_or(0.0, |next| next - self.difference[i]);
        self.integral[i] + self.step * share * (self.difference[i] + 0.5 * share * rise)
    }
}

/// Change of the rolling radius at the contact that touches first, in m.
fn first(touches: &[Touch]) -> Option<f64> {
    let first = touches.iter().min_by(|a, b| a.drop.total_cmp(&b.drop));
    first.map(|touch| touch.wheel_height)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(radii: impl Fn(f64) -> f64) -> EquivalentConicity {
        let values = (-80..=80).map(|i| radii(f64::from(i) * STEP));
        EquivalentConicity::of_radii(STEP, values.collect())
    }

    /// A cone has its own conicity at every amplitude. The integrand is constant: rounding.
    #[test]
    fn analytic_a_cone_has_its_own_conicity() {
        let cone = of(|y| 2.0 * 0.05 * y);
        for amplitude in [1e-4, 3e-3, 7.77e-3] {
            assert!((cone.at(amplitude).unwrap() / 0.05 - 1.0).abs() < 1e-9);
        }
    }

    /// Δr = k y³: half of J is 2/(sqrt(k) A) times the integral of du/sqrt(1 - u⁴), 1.311 028 777
    /// (Gauss's lemniscate constant by 2), so γ = 0.358 885 k A². Tolerance 1e-3: the polyline through Δr.
    #[test]
    fn analytic_a_cubic_difference_of_the_radii() {
        let cubic = of(|y| 1e3 * y * y * y);
        for amplitude in [3e-3, 6e-3] {
            let lemniscate = 1.311_028_777;
            let expected = (PI / (4.0 * lemniscate)).powi(2) * 1e3 * amplitude * amplitude;
            assert!((cubic.at(amplitude).unwrap() / expected - 1.0).abs() < 1e-3);
        }
    }

    /// Cones whose radii differ in the middle swing about where they are equal, with the same wavelength.
    #[test]
    fn analytic_unequal_radii_move_the_middle() {
        let aside = of(|y| 0.1 * (y - 2e-3));
        assert!((aside.at(4e-3).unwrap() / 0.05 - 1.0).abs() < 1e-9);
        let middles = aside.middles(4e-3);
        assert!(middles.len() == 1 && (middles[0] - 2e-3).abs() < 1e-9, "{middles:?}");
        assert!(aside.at(7e-3).is_none(), "the wave reaches beyond the radii that are known");
    }

    /// Cones with steeper halves on the outside: γ₁ to the right, γ₂ to the left of the middle. Each half
    /// of the wave takes its own time: 2/sqrt(γ) = 1/sqrt(γ₁) + 1/sqrt(γ₂).
    #[test]
    fn analytic_unequal_halves_share_the_wave() {
        let (right, left): (f64, f64) = (0.04, 0.09);
        let wheels = of(|y| 2.0 * y * if y > 0.0 { right } else { left });
        let expected = (2.0 / (1.0 / right.sqrt() + 1.0 / left.sqrt())).powi(2);
        assert!((wheels.at(4e-3).unwrap() / expected - 1.0).abs() < 1e-3);
    }

    /// Wheels that roll on the same radius everywhere have no wave, and the conicity zero.
    #[test]
    fn analytic_cylinders_have_the_conicity_zero() {
        assert_eq!(of(|_| 0.0).at(3e-3), Some(0.0));
        assert_eq!(of(|y| 1e-10 * (1e4 * y).sin()).at(3e-3), Some(0.0));
    }

    #[test]
    fn no_conicity_without_amplitude_or_where_nothing_steers_back() {
        let cone = of(|y| 0.1 * y);
        assert!(cone.at(0.0).is_none() && cone.at(9e-3).is_none() && cone.at(f64::NAN).is_none());
        assert!(of(|y| -0.1 * y).at(3e-3).is_none());
    }
}
