//! The rail's temperatures at the start, from which all rises count.
//!
//! Uniform, in equilibrium with a weather, or as a day leaves them that has come again and again
//! (`docs/theory/railheat/energy.md#eq-14`). In the last case u = T - T_b = Φ a₀ is neither uniform
//! nor steady, and evens out by itself while b = a - a₀, the rise since the start, begins at zero:
//!
//! ```text
//! b' = -λ b + φ·L (q(T) + H Φ (a₀ + b)) - λ a₀
//! ```
//!
//! so that φ·L H Φ a₀ - λ a₀ is a constant source. It moves heat within the section and brings none.

use super::initial::Initial;
use super::untouched::{State, Untouched};
use crate::section::{Modes, Outline, add};
use crate::weather::{Light, Weather};

/// A rail whose temperatures change less than this from one day to the next has settled, K.
const SETTLED: f64 = 1e-6;

/// Days after which a rail that has not settled never will.
const MOST_DAYS: usize = 60;

/// The rail does not come to a daily course.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "initial.day: the rail still warms or cools by {change:.1e} K a day after {MOST_DAYS} days of this \
     weather; it must exchange heat with the air (surface.convection, surface.emissivity)"
)]
pub struct NeverSettles {
    /// Change from the last day to the one before, K.
    pub change: f64,
}

/// A day that comes again and again: the weather in the middle of equal steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Day {
    /// The weather, step after step.
    pub weather: Vec<Weather>,
    /// Length of a step, s.
    pub step: f64,
}

impl Initial {
    /// A rail in equilibrium with a weather.
    ///
    /// `absorbed` is the sunlight in each piece of surface, W/m²; `base` is a temperature near the
    /// equilibrium, K.
    pub fn equilibrium(
        untouched: &mut Untouched,
        modes: &Modes,
        weather: &Weather,
        absorbed: &[f64],
        base: f64,
    ) -> Self {
        let mut initial = Self::uniform(untouched.surface().facets().len(), modes, base);
        if modes.rates[0] <= 0.0 {
            return initial;
        }
        let mut amplitudes = vec![0.0; modes.width()];
        for _ in 0..200 {
            untouched.sources(&amplitudes, &initial, weather, absorbed);
            let mut change = 0.0_f64;
            let sources = untouched.last_sources().iter().zip(&modes.rates[..modes.count]);
            for (a, (source, rate)) in amplitudes.iter_mut().zip(sources) {
                let next = source / rate;
                change = change.max((next - *a).abs());
                *a = next;
            }
            let size = amplitudes.iter().fold(0.0_f64, |size, a| size.max(a.abs()));
            if change <= 1e-14 * size {
                break;
            }
        }
        for piece in 0..initial.temperatures.len() {
            let temperature = base + untouched.rise(piece, &amplitudes);
            initial.temperatures[piece] = temperature;
            initial.balanced[piece] = untouched.flux(piece, temperature, weather, absorbed);
        }
        initial
    }

    /// A rail as a day leaves it that has come again and again, on a track of this azimuth.
    ///
    /// `base` is a temperature near that of the rail, K.
    ///
    /// # Errors
    /// When the days do not become alike.
    pub fn after_days(
        untouched: &mut Untouched,
        modes: &Modes,
        outline: &Outline,
        azimuth: f64,
        day: &Day,
        base: f64,
    ) -> Result<Self, NeverSettles> {
        let mut initial = Self::uniform(untouched.surface().facets().len(), modes, base);
        let exchange = *untouched.exchange();
        let light = |weather: &Weather| {
            Light::new(outline, untouched.surface(), &exchange, weather, azimuth)
        };
        let absorbed: Vec<Vec<f64>> =
            day.weather.iter().map(|weather| light(weather).absorbed).collect();
        let mut state = State { amplitudes: vec![0.0; modes.width()], weather: 0.0 };
        let mut change = f64::INFINITY;
        for _ in 0..MOST_DAYS {
            let before = state.amplitudes.clone();
            for (weather, absorbed) in day.weather.iter().zip(&absorbed) {
                untouched.step(&mut state, &initial, modes, weather, absorbed, day.step);
            }
            let since: Vec<f64> =
                state.amplitudes.iter().zip(&before).map(|(now, before)| now - before).collect();
            let pieces = 0..initial.temperatures.len();
            change = pieces.map(|p| untouched.rise(p, &since).abs()).fold(0.0, f64::max);
            if change < SETTLED {
                initial.begin_at(untouched, modes, &state.amplitudes);
                return Ok(initial);
            }
        }
        Err(NeverSettles { change })
    }

    /// Makes a uniform rail one that has these amplitudes over it.
    fn begin_at(&mut self, untouched: &Untouched, modes: &Modes, amplitudes: &[f64]) {
        for (equalising, (rate, a)) in
            self.equalising.iter_mut().zip(modes.rates.iter().zip(amplitudes))
        {
            *equalising = -rate * a;
        }
        for (piece, facet) in untouched.surface().facets().iter().enumerate() {
            let rise = untouched.rise(piece, amplitudes);
            self.temperatures[piece] += rise;
            let source = facet.length * untouched.in_modes(piece) * rise;
            add(&mut self.equalising, source, untouched.shape(piece));
        }
    }
}
