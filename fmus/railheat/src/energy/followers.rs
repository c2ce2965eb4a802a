//! Modes that are so fast that they follow the heat that comes in.
//!
//! At the end of an interval Δt a mode has g S (`docs/theory/railheat/energy.md#eq-11`) of the heat
//! S that came in meanwhile and e^(-λΔt) of what it had before. Where λΔt is over five the second
//! is next to nothing. Such modes, half or more of all with cells of 2.5 mm, are not kept for each
//! element; what they add to its readings is kept, until the next interval ends. Left out
//! altogether they would be missed: they cancel at the foot what the others show there while heat
//! comes in, some tenths of a millikelvin under a train in a curve. Validated by
//! `property_fast_modes_do_not_matter_at_the_foot`.

use std::ops::Range;

use crate::section::{Crown, Modes, Propagator, Readings, add};

/// Decays of a mode in an interval from which on it follows.
pub const DECAYS: f64 = 5.0;

/// What the modes that follow add to the readings of an element.
#[derive(Clone, Debug)]
pub struct Followers {
    modes: Range<usize>,
    /// Shapes at each reading: the levels, then the rows.
    readings: Vec<Vec<f64>>,
    /// Shapes of each source: the strips of the crown, bending, the exposed surface.
    sources: Vec<Vec<f64>>,
    /// Readings by heat of 1 J/m from each source in the present interval, K, source after source.
    by_source: Vec<f64>,
    gain: Vec<f64>,
}

impl Followers {
    /// The even modes from number `kept` on.
    pub fn new(
        modes: &Modes,
        kept: usize,
        readings: &Readings,
        crown: &Crown,
        [bending, exposed]: [&[f64]; 2],
    ) -> Self {
        let range = kept..modes.even_width();
        let part = |shape: &[f64]| shape[range.clone()].to_vec();
        let strips = (0..crown.strips()).map(|strip| crown.shape(strip));
        let sources: Vec<_> = strips.chain([bending, exposed]).map(part).collect();
        let readings: Vec<_> =
            readings.levels.iter().chain(&readings.rows).map(|shape| part(shape)).collect();
        Self {
            by_source: vec![0.0; sources.len() * readings.len()],
            gain: vec![0.0; range.len()],
            modes: range,
            readings,
            sources,
        }
    }

    /// Makes the readings those of an interval of another length.
    pub fn set_time(&mut self, propagator: &Propagator) {
        self.gain.copy_from_slice(&propagator.gain()[self.modes.clone()]);
        let count = self.readings.len();
        for (row, source) in self.by_source.chunks_exact_mut(count).zip(&self.sources) {
            for (sum, reading) in row.iter_mut().zip(&self.readings) {
                *sum = held(reading, &self.gain, source);
            }
        }
    }

    /// Number of readings.
    pub fn count(&self) -> usize {
        self.readings.len()
    }

    /// Adds what heat in J/m on a strip of the crown does to the readings.
    pub fn add_strip(&self, readings: &mut [f64], strip: usize, heat: f64) {
        self.add(readings, strip, heat);
    }

    /// Adds what heat of bending in J/m does to the readings.
    pub fn add_bending(&self, readings: &mut [f64], heat: f64) {
        self.add(readings, self.sources.len() - 2, heat);
    }

    /// Adds what heat in J/m, spread evenly over the exposed surface, does to the readings.
    pub fn add_exposed(&self, readings: &mut [f64], heat: f64) {
        self.add(readings, self.sources.len() - 1, heat);
    }

    fn add(&self, readings: &mut [f64], source: usize, heat: f64) {
        let count = self.readings.len();
        add(readings, heat, &self.by_source[source * count..][..count]);
    }

    /// The readings by a source with a part `shape` in each mode.
    pub fn read(&self, readings: &mut [f64], shape: &[f64]) {
        let shape = &shape[self.modes.clone()];
        for (sum, reading) in readings.iter_mut().zip(&self.readings) {
            *sum = held(reading, &self.gain, shape);
        }
    }
}

/// A reading of what the modes hold of a source at the end of an interval.
fn held(reading: &[f64], gain: &[f64], source: &[f64]) -> f64 {
    let of_mode = reading.iter().zip(gain).zip(source);
    of_mode.map(|((reading, gain), source)| reading * gain * source).sum()
}
