//! Random irregularities by power spectral densities, the same ones for the same seed.
//!
//! Densities over the wavenumber Ω (rad/m), form and constants of ERRI B176 as Claus and Schiehlen
//! (1998) give them (from memory of the field, not re-read; eqs 36, 37):
//!
//!   vertical, lateral    S = A Ωc²/((Ω² + Ωr²)(Ω² + Ωc²))
//!   cross level          S = A_v/b² Ωc² Ω²/((Ω² + Ωr²)(Ω² + Ωc²)(Ω² + Ωs²))   (as an angle)
//!
//! with Ωr = 0.0206, Ωc = 0.8246, Ωs = 0.4380 rad/m, b = 0.75 m. The variance is (1/π) ∫ S dΩ, and
//! the sum of N waves has the amplitudes √(2 S ΔΩ/π) and random phases.

use std::f64::consts::{PI, TAU};

use schemars::JsonSchema;
use serde::Deserialize;

use super::grid::{Grid, Row};

const OMEGA_R: f64 = 0.0206;
const OMEGA_C: f64 = 0.8246;
const OMEGA_S: f64 = 0.4380;

/// Half distance of the rails in the cross level's density, m.
const HALF_BASE: f64 = 0.75;

/// Distance of the rows, m.
const DISTANCE: f64 = 0.25;

/// Number of waves of each kind.
const WAVES: usize = 200;

/// Length over which the irregularities set in and fade out, m.
const FADING: f64 = 20.0;

/// A quality of track.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
pub(super) enum Quality {
    /// Low irregularities of ERRI B176.
    #[serde(rename = "erri-low")]
    Low,
    /// High irregularities of ERRI B176.
    #[serde(rename = "erri-high")]
    High,
}

/// Random irregularities on a piece of track.
#[derive(Clone, Debug)]
pub(super) struct Spectrum {
    pub quality: Quality,
    pub seed: u64,
    pub begin: f64,
    pub length: f64,
    /// Shortest and longest wave, m.
    pub wavelengths: [f64; 2],
}

impl Quality {
    /// A of the vertical and of the lateral density, rad m.
    fn constants(self) -> [f64; 2] {
        match self {
            Self::Low => [4.032e-7, 2.119e-7],
            Self::High => [1.080e-6, 6.125e-7],
        }
    }
}

impl Spectrum {
    /// The irregularities, made once.
    pub fn grid(&self) -> Grid {
        let count = (self.length / DISTANCE).ceil() as usize + 1;
        let mut random = Random(self.seed);
        let [vertical, lateral] = self.quality.constants();
        let smooth = |a: f64| move |omega: f64| a * falling(omega);
        let cross = |omega: f64| {
            let square = omega * omega;
            vertical / (HALF_BASE * HALF_BASE) * falling(omega) * square
                / (square + OMEGA_S * OMEGA_S)
        };
        let heights = self.waves(count, &mut random, smooth(vertical));
        let sides = self.waves(count, &mut random, smooth(lateral));
        let angles = self.waves(count, &mut random, cross);
        let rows = (0..count).map(|i| -> Row {
            let (side, down, tilt) = (sides[i], heights[i], HALF_BASE * angles[i]);
            let faded = self.fading(i as f64 * DISTANCE);
            [side, down - tilt, side, down + tilt].map(|value| faded * value)
        });
        Grid::new(self.begin, DISTANCE, rows.collect())
    }

    /// A sum of waves with this density.
    fn waves(&self, count: usize, random: &mut Random, density: impl Fn(f64) -> f64) -> Vec<f64> {
        let [shortest, longest] = self.wavelengths;
        let (low, high) = (TAU / longest, TAU / shortest);
        let band = (high - low) / WAVES as f64;
        let mut values = vec![0.0; count];
        for n in 0..WAVES {
            // At random within its band, so that the sum does not repeat after 2 pi/band.
            let omega = low + band * (n as f64 + random.unit());
            let amplitude = (2.0 * density(omega) * band / PI).sqrt();
            let phase = TAU * random.unit();
            for (i, value) in values.iter_mut().enumerate() {
                *value += amplitude * libm::cos(omega * i as f64 * DISTANCE + phase);
            }
        }
        values
    }

    /// 0 at both ends, 1 between.
    fn fading(&self, from_begin: f64) -> f64 {
        let from_end = from_begin.min(self.length - from_begin);
        let share = (from_end / FADING).clamp(0.0, 1.0);
        0.5 * (1.0 - libm::cos(PI * share))
    }
}

/// Density of the vertical and lateral irregularities for A = 1.
fn falling(omega: f64) -> f64 {
    let square = omega * omega;
    let corner = OMEGA_C * OMEGA_C;
    corner / ((square + OMEGA_R * OMEGA_R) * (square + corner))
}

/// Random numbers of the generator SplitMix64 (Steele, Lea & Flood 2014).
struct Random(u64);

impl Random {
    /// From 0 up to 1.
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bits ^= bits >> 31;
        (bits >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spectrum(seed: u64) -> Spectrum {
        Spectrum {
            quality: Quality::Low,
            seed,
            begin: 0.0,
            length: 8000.0,
            wavelengths: [3.0, 80.0],
        }
    }

    /// The variance is (1/pi) ∫ S over the waves that are there, by the trapezoidal rule in this
    /// test. 8 km hold a hundred of the longest waves, so that the sample's variance lies within
    /// 15 %.
    #[test]
    fn analytic_variance_of_the_vertical_irregularities() {
        let grid = spectrum(7).grid();
        let mean = |rails: [crate::RailOffset; 2]| 0.5 * (rails[0].vertical + rails[1].vertical);
        let samples: Vec<f64> = (200..31_800).map(|i| mean(grid.at(0.25 * f64::from(i)))).collect();
        let found = samples.iter().map(|v| v * v).sum::<f64>() / samples.len() as f64;
        let (low, high, n) = (TAU / 80.0, TAU / 3.0, 10_000);
        let width = (high - low) / f64::from(n);
        let density = |i: i32| 4.032e-7 * falling(low + width * (f64::from(i) + 0.5));
        let expected = (0..n).map(density).sum::<f64>() * width / PI;
        assert!((found / expected - 1.0).abs() < 0.15, "{found}, expected {expected}");
    }

    /// ∫ Ω²ᵏ/Π(Ω² + a²) dΩ over the corners a by partial fractions; k is 0 for two and 1 for three.
    ///
    /// The limits are the lowest and the highest wavenumber of `spectrum`.
    fn integral(corners: &[f64]) -> f64 {
        let part = |i: usize| {
            let a = corners[i];
            let others = corners.iter().enumerate().filter(|(j, _)| *j != i);
            let product: f64 = others.map(|(_, b)| b * b - a * a).product();
            let numerator = if corners.len() == 3 { -a * a } else { 1.0 };
            let primitive = |omega: f64| (omega / a).atan() / a;
            numerator / product * (primitive(TAU / 3.0) - primitive(TAU / 80.0))
        };
        (0..corners.len()).map(part).sum()
    }

    /// Parseval: the variance of each kind is (1/π) ∫ S dΩ, in closed form, as the mean over eight
    /// seeds of 4 km each. The sum of squares of 200 amplitudes at random within their bands and a
    /// length that holds no whole waves leave some per cent; tolerance 6 %.
    #[test]
    fn analytic_variances_by_parseval() {
        let mut found = [0.0; 3];
        for seed in 1..=8 {
            let grid = Spectrum { length: 4000.0, ..spectrum(seed) }.grid();
            // Without the ends, where the irregularities fade.
            for i in 100..15_900 {
                let [left, right] = grid.at(0.25 * f64::from(i));
                let mean = 0.5 * (left.vertical + right.vertical);
                let tilt = 0.5 * (right.vertical - left.vertical) / HALF_BASE;
                for (sum, value) in found.iter_mut().zip([mean, left.lateral, tilt]) {
                    *sum += value * value / (8.0 * 15_800.0);
                }
            }
        }
        let [vertical, lateral] = Quality::Low.constants();
        let smooth = OMEGA_C * OMEGA_C * integral(&[OMEGA_R, OMEGA_C]) / PI;
        let cross = OMEGA_C * OMEGA_C * integral(&[OMEGA_R, OMEGA_C, OMEGA_S]) / PI;
        let expected =
            [vertical * smooth, lateral * smooth, vertical / (HALF_BASE * HALF_BASE) * cross];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 0.06, "{found}, expected {expected}");
        }
    }

    #[test]
    fn irregularities_set_in_and_fade_out() {
        let grid = spectrum(3).grid();
        for chainage in [0.0, 8000.0] {
            let [left, right] = grid.at(chainage);
            let values = [left.lateral, left.vertical, right.lateral, right.vertical];
            assert!(values.iter().all(|value| value.abs() < 1e-15), "{values:?}");
        }
        let spectrum = spectrum(3);
        assert!((spectrum.fading(10.0) - 0.5).abs() < 1e-15);
        assert_eq!([20.0, 4000.0, 7980.0].map(|s| spectrum.fading(s)), [1.0; 3]);
    }

    #[test]
    fn property_the_seed_decides() {
        let at = |seed| spectrum(seed).grid().at(1234.5);
        assert_eq!(at(1), at(1));
        assert_ne!(at(1), at(2));
        assert_eq!(at(1)[0].lateral, at(1)[1].lateral);
    }
}
