//! One exact step of the modes.
//!
//! a' = -λ a + s with constant s over a time Δt (`docs/theory/railheat/energy.md#eq-11`):
//!
//! ```text
//! a ← e^(-λΔt) a + g S,    S = s Δt,    g = (1 - e^(-λΔt))/(λΔt)
//! ∫ a dt = g Δt a + (1 - g)/λ S
//! ```
//!
//! The integral gives the heat that the surface lost meanwhile.

use super::modes::Modes;

/// Amplitudes below this are nothing: less than 1e-20 K in any cell. A mode that has decayed so far costs nothing.
const NOTHING: f64 = 1e-20;

/// The factors for a step.
#[derive(Clone, Debug, PartialEq)]
pub struct Propagator {
    time: f64,
    decay: Vec<f64>,
    gain: Vec<f64>,
    /// Heat lost by an amplitude of one at the beginning, J/m.
    pub(crate) lost: Vec<f64>,
    /// Heat lost of what a source of one brings, J/m.
    pub(crate) lost_at_once: Vec<f64>,
}

impl Propagator {
    /// The factors for a step of `time` in s.
    pub fn new(modes: &Modes, time: f64) -> Self {
        let width = modes.width();
        let mut propagator = Self {
            time: f64::NAN,
            decay: vec![0.0; width],
            gain: vec![0.0; width],
            lost: vec![0.0; width],
            lost_at_once: vec![0.0; width],
        };
        propagator.set_time(modes, time);
        propagator
    }

    /// Makes the factors those of another step, if it is another; tells whether it is.
    pub fn set_time(&mut self, modes: &Modes, time: f64) -> bool {
        if time == self.time {
            return false;
        }
        self.time = time;
        for k in 0..modes.width() {
            let x = modes.rates[k] * time;
            // Series where the difference of nearly equal numbers would lose digits.
            let (gain, rest) = if x < 1e-3 {
                (1.0 - x / 2.0 + x * x / 6.0, 0.5 - x / 6.0 + x * x / 24.0)
            } else {
                let gain = -libm::expm1(-x) / x;
                (gain, (1.0 - gain) / x)
            };
            self.decay[k] = libm::exp(-x);
            self.gain[k] = gain;
            self.lost[k] = modes.loss[k] * gain * time;
            self.lost_at_once[k] = modes.loss[k] * rest * time;
        }
        true
    }

    /// The time of the step, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// What is left of heat at the end of the step over which it comes in evenly.
    pub(crate) fn gain(&self) -> &[f64] {
        &self.gain
    }

    /// Lets amplitudes decay.
    #[inline]
    pub fn decay(&self, amplitudes: &mut [f64]) {
        for (a, decay) in amplitudes.iter_mut().zip(&self.decay) {
            let next = *a * decay;
            *a = if next.abs() < NOTHING { 0.0 } else { next };
        }
    }

    /// Adds what a source in J/m, spread evenly over the step, brings.
    #[inline]
    pub fn add(&self, amplitudes: &mut [f64], source: &[f64]) {
        for ((a, gain), source) in amplitudes.iter_mut().zip(&self.gain).zip(source) {
            *a += gain * source;
        }
    }
}
