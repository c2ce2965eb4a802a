//! Rail that no wheel has touched: one section that feels the weather alone.
//!
//! Its rise above the initial state is solved in the modes of the section; what of the weather's
//! exchange is not linear, or has changed since the start, is a source:
//!
//! ```text
//! s = L (q(T) - q_0 + H r),    T = T_0 + r
//! ```
//!
//! with the flux q_0 that the initial temperatures T_0 balance (theory eq. 12). In equilibrium
//! s = 0 and r = 0 to the last bit, so that rail without wheels stays as it is.

use serde::{Deserialize, Serialize};

use super::propagator::Propagator;
use super::weather::{Exchange, Surface, Weather};
use crate::section::{Modes, dot};

/// Longest step with one source, s: the weather's part is of first order in it.
const LONGEST: f64 = 10.0;

/// What changes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Amplitudes of the rise above the initial state.
    pub amplitudes: Vec<f64>,
    /// Heat since the start from the weather, J/m.
    pub weather: f64,
}

/// Untouched rail: what stays.
#[derive(Clone, Debug)]
pub struct Untouched {
    surface: Surface,
    exchange: Exchange,
    /// Conductance of each piece in the modes, W/(m²·K).
    linear: Vec<f64>,
    /// Shapes at each piece of the surface.
    shapes: Vec<f64>,
    /// Temperature of each piece at the start, K.
    initial: Vec<f64>,
    /// Flux that the initial temperatures balance, W/m².
    balanced: Vec<f64>,
    propagator: Propagator,
    source: Vec<f64>,
}

impl Untouched {
    /// Rail of one temperature in K at the start.
    pub fn uniform(
        surface: Surface,
        exchange: Exchange,
        linear: Vec<f64>,
        modes: &Modes,
        temperature: f64,
    ) -> Self {
        let pieces = surface.facets().len();
        let shapes =
            surface.facets().iter().flat_map(|facet| modes.at(facet.cell)).copied().collect();
        Self {
            shapes,
            initial: vec![temperature; pieces],
            balanced: vec![0.0; pieces],
            source: vec![0.0; modes.width()],
            propagator: Propagator::new(modes, LONGEST),
            surface,
            exchange,
            linear,
        }
    }

    /// Lets the rail come into equilibrium with a weather that absorbs so much in each piece.
    pub fn settle(&mut self, modes: &Modes, weather: &Weather, absorbed: &[f64]) {
        if modes.rates[0] <= 0.0 {
            return;
        }
        let base = self.initial.clone();
        let mut amplitudes = vec![0.0; modes.width()];
        for _ in 0..200 {
            self.sources(&amplitudes, weather, absorbed);
            let mut change = 0.0_f64;
            for ((a, source), rate) in
                amplitudes.iter_mut().zip(&self.source).zip(&modes.rates[..modes.count])
            {
                let next = source / rate;
                change = change.max((next - *a).abs());
                *a = next;
            }
            let size = amplitudes.iter().fold(0.0_f64, |size, a| size.max(a.abs()));
            if change <= 1e-14 * size {
                break;
            }
        }
        for (piece, base) in base.into_iter().enumerate() {
            self.initial[piece] = base + self.rise(piece, &amplitudes);
            self.balanced[piece] = self.flux(piece, self.initial[piece], weather, absorbed);
        }
    }

    /// Takes the rail over a time in s.
    pub fn step(
        &mut self,
        state: &mut State,
        modes: &Modes,
        weather: &Weather,
        absorbed: &[f64],
        time: f64,
    ) {
        let steps = (time / LONGEST).ceil().max(1.0);
        self.propagator.set_time(modes, time / steps);
        for _ in 0..steps as usize {
            let heat = self.sources(&state.amplitudes, weather, absorbed);
            let time = self.propagator.time();
            self.source.iter_mut().for_each(|source| *source *= time);
            let lost = dot(&self.propagator.lost, &state.amplitudes)
                + dot(&self.propagator.lost_at_once, &self.source);
            let dropped = heat * time - dot(&modes.content, &self.source);
            self.propagator.decay(&mut state.amplitudes);
            self.propagator.add(&mut state.amplitudes, &self.source);
            state.weather += heat * time - lost - dropped;
        }
    }

    /// Fills the sources of the modes and gives their heat, W/m.
    fn sources(&mut self, amplitudes: &[f64], weather: &Weather, absorbed: &[f64]) -> f64 {
        self.source.fill(0.0);
        let width = amplitudes.len();
        let mut heat = 0.0;
        for (piece, facet) in self.surface.facets().iter().enumerate() {
            let rise = self.rise(piece, amplitudes);
            let flux = self.flux(piece, self.initial[piece] + rise, weather, absorbed);
            let source = facet.length * (flux - self.balanced[piece] + self.linear[piece] * rise);
            heat += source;
            crate::section::add(&mut self.source, source, &self.shapes[piece * width..][..width]);
        }
        heat
    }

    fn flux(&self, piece: usize, temperature: f64, weather: &Weather, absorbed: &[f64]) -> f64 {
        absorbed[piece] + self.surface.exchanged(piece, &self.exchange, weather, temperature)
    }

    fn rise(&self, piece: usize, amplitudes: &[f64]) -> f64 {
        let width = amplitudes.len();
        dot(&self.shapes[piece * width..][..width], amplitudes)
    }

    /// The present temperature of each piece of the surface, K.
    pub fn temperatures<'s>(&'s self, state: &'s State) -> impl Iterator<Item = f64> + 's {
        (0..self.initial.len())
            .map(|piece| self.initial[piece] + self.rise(piece, &state.amplitudes))
    }

    /// Mean temperature of the surface at the start, K.
    pub fn initial_mean(&self) -> f64 {
        let facets = self.surface.facets();
        let sum: f64 = facets.iter().zip(&self.initial).map(|(f, t)| f.length * t).sum();
        sum / facets.iter().map(|facet| facet.length).sum::<f64>()
    }

    /// Temperature at the start of the piece of surface at the middle of the crown, K.
    pub fn initial_crown(&self) -> f64 {
        let facets = self.surface.facets();
        let distance = |i: &usize| facets[*i].middle().y.hypot(facets[*i].middle().z);
        let nearest = (0..facets.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.map_or(f64::NAN, |piece| self.initial[piece])
    }

    /// The surface.
    pub fn surface(&self) -> &Surface {
        &self.surface
    }

    /// How it exchanges heat.
    pub fn exchange(&self) -> &Exchange {
        &self.exchange
    }

    /// Shapes at a piece of the surface.
    pub fn shape(&self, piece: usize, width: usize) -> &[f64] {
        &self.shapes[piece * width..][..width]
    }
}
