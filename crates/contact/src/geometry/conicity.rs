//! Equivalent conicity of a wheelset on its rails.
//!
//! A wheelset with the difference Δr(y) of its rolling radii (right less left) runs free of forces as
//!
//! ```text
//! d²y/ds² = -Δr(y)/(2 e r0)                                                                        (G4)
//! ```
//!
//! and the cone that has the same wavelength at the amplitude A has the equivalent conicity. Equation G4
//! is integrated once by its energy and once over a quarter of the wave; e and r0 drop out:
//!
//! ```text
//! G(y) = integral of Δr from y to A,   I = integral of dy/sqrt(G) from 0 to A,   γ = (π/(2 I))²     (G5)
//! ```
//!
//! A cone has Δr = 2 γ y and gets γ. Source: the definition of EN 15302 (UIC 519), whose integration of
//! G4 along the track is done here in closed form; for profiles that are alike on both sides.

use super::pair::ProfilePair;
use super::wheelset::wheelset_geometry;
use crate::error::ContactError;
use std::f64::consts::FRAC_PI_2;

/// Distance of the displacements at which the radii are sought, in m.
const STEP: f64 = 1e-4;

/// Intervals of the integral over a quarter of the wave.
const INTERVALS: usize = 400;

/// Equivalent conicity over the amplitude.
#[derive(Clone, Debug)]
pub struct EquivalentConicity {
    step: f64,
    /// Δr in m at multiples of the step.
    difference: Vec<f64>,
    /// Integral of Δr from 0, in m².
    integral: Vec<f64>,
}

impl EquivalentConicity {
    /// Of a pair of profiles, for amplitudes up to `greatest` metres.
    ///
    /// # Errors
    /// When a dimension of the pair is out of range or a wheel stands beside its rail.
    pub fn new(pair: &ProfilePair, greatest: f64) -> Result<Self, ContactError> {
        let count = (greatest / STEP).ceil() as usize;
        let radii = |i| wheelset_geometry(pair, i as f64 * STEP, 0.0);
        let difference = (0..=count).map(|i| radii(i).map(|g| g.radius_difference()));
        Ok(Self::of_radii(STEP, difference.collect::<Result<_, _>>()?))
    }

    /// Of differences of the rolling radii (m) at multiples of `step` (m), the first in the middle.
    fn of_radii(step: f64, difference: Vec<f64>) -> Self {
        let mut sum = 0.0;
        let mut integral = vec![0.0];
        for pair in difference.windows(2) {
            sum += 0.5 * step * (pair[0] + pair[1]);
            integral.push(sum);
        }
        Self { step, difference, integral }
    }

    /// The equivalent conicity at an `amplitude` in m, if there is one.
    ///
    /// There is none without amplitude, beyond the greatest one, or where the radii do not steer the
    /// wheelset back.
    pub fn at(&self, amplitude: f64) -> Option<f64> {
        let greatest = (self.difference.len() - 1) as f64 * self.step;
        if amplitude.is_nan() || amplitude <= 0.0 || amplitude > greatest * (1.0 + 1e-12) {
            return None;
        }
        let end = self.integral_to(amplitude);
        let mut sum = 0.0;
        for i in 0..INTERVALS {
            // y = A sin t takes the infinity at the turning point out of the integral.
            let (sine, cosine) = libm::sincos((i as f64 + 0.5) * FRAC_PI_2 / INTERVALS as f64);
            let energy = end - self.integral_to(amplitude * sine);
            if energy <= 0.0 {
                return None;
            }
            sum += amplitude * cosine / energy.sqrt();
        }
        let quarter = sum * FRAC_PI_2 / INTERVALS as f64;
        Some((FRAC_PI_2 / quarter).powi(2))
    }

    /// Integral of Δr, linear between its values, from 0 to `y` metres.
    fn integral_to(&self, y: f64) -> f64 {
        let position = y / self.step;
        let i = (position as usize).min(self.difference.len().saturating_sub(2));
        let share = position - i as f64;
        let rise = self.difference.get(i + 1).map_or(0.0, |next| next - self.difference[i]);
        self.integral[i] + self.step * share * (self.difference[i] + 0.5 * share * rise)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(radii: impl Fn(f64) -> f64) -> EquivalentConicity {
        EquivalentConicity::of_radii(STEP, (0..=80).map(|i| radii(f64::from(i) * STEP)).collect())
    }

    /// A cone has its own conicity at every amplitude. The integrand is constant: rounding.
    #[test]
    fn analytic_a_cone_has_its_own_conicity() {
        let cone = of(|y| 2.0 * 0.05 * y);
        for amplitude in [1e-4, 3e-3, 7.77e-3] {
            assert!((cone.at(amplitude).unwrap() / 0.05 - 1.0).abs() < 1e-9);
        }
    }

    /// Δr = k y³: I = 2/(sqrt(k) A) times the integral of du/sqrt(1 - u⁴), 1.311 028 777 (Gauss's
    /// lemniscate constant by 2), so γ = 0.358 885 k A². Tolerance 1e-3: the polyline through Δr.
    #[test]
    fn analytic_a_cubic_difference_of_the_radii() {
        let cubic = of(|y| 1e3 * y * y * y);
        for amplitude in [3e-3, 6e-3] {
            let lemniscate = 1.311_028_777;
            let expected = (FRAC_PI_2 / (2.0 * lemniscate)).powi(2) * 1e3 * amplitude * amplitude;
            assert!((cubic.at(amplitude).unwrap() / expected - 1.0).abs() < 1e-3);
        }
    }

    #[test]
    fn no_conicity_without_amplitude_or_where_nothing_steers_back() {
        let cone = of(|y| 0.1 * y);
        assert!(cone.at(0.0).is_none() && cone.at(9e-3).is_none() && cone.at(f64::NAN).is_none());
        assert!(of(|y| -0.1 * y).at(3e-3).is_none());
    }
}
