//! Rail that no wheel has touched: one section that feels the weather alone.
//!
//! Its rise above the initial state is solved in the modes of the section; what of the weather's
//! exchange is not linear, or has changed since the start, is a source:
//!
//! ```text
//! s = L (q(T) - q_0 + H r),    T = T_0 + r
//! ```
//!
//! with the flux q_0 that the initial temperatures T_0 balance
//! (`docs/theory/railheat/energy.md#eq-13`). In equilibrium s = 0 and r = 0 to the last bit, so
//! that rail without wheels stays as it is. Where the initial temperatures are neither uniform nor
//! in equilibrium, they even out meanwhile (`initial.rs`).

use serde::{Deserialize, Serialize};

use super::initial::Initial;
use crate::section::{Modes, Propagator, dot};
use crate::weather::{Exchange, Surface, Weather};

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

/// Untouched rail: what stays, and is the same in all directions of the track.
#[derive(Clone, Debug)]
pub struct Untouched {
    surface: Surface,
    exchange: Exchange,
    /// Conductance of each piece in the modes, W/(m²·K).
    linear: Vec<f64>,
    /// Shapes at each piece of the surface.
    shapes: Vec<f64>,
    width: usize,
    propagator: Propagator,
    source: Vec<f64>,
}

impl Untouched {
    /// Rail whose modes have this conductance of each piece of surface in W/(m²·K).
    pub fn new(surface: Surface, exchange: Exchange, linear: Vec<f64>, modes: &Modes) -> Self {
        let shapes =
            surface.facets().iter().flat_map(|facet| modes.at(facet.cell)).copied().collect();
        Self {
            shapes,
            width: modes.width(),
            source: vec![0.0; modes.width()],
            propagator: Propagator::new(modes, LONGEST),
            surface,
            exchange,
            linear,
        }
    }

    /// Takes the rail over a time in s in equal steps of at most 10 s.
    pub fn step(
        &mut self,
        state: &mut State,
        initial: &Initial,
        modes: &Modes,
        weather: &Weather,
        absorbed: &[f64],
        time: f64,
    ) {
        let steps = (time / LONGEST).ceil().max(1.0);
        self.propagator.set_time(modes, time / steps);
        for _ in 0..steps as usize {
            let heat = self.sources(&state.amplitudes, initial, weather, absorbed);
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
    pub(super) fn sources(
        &mut self,
        amplitudes: &[f64],
        initial: &Initial,
        weather: &Weather,
        absorbed: &[f64],
    ) -> f64 {
        self.source.copy_from_slice(&initial.equalising);
        let mut heat = 0.0;
        for (piece, facet) in self.surface.facets().iter().enumerate() {
            let rise = self.rise(piece, amplitudes);
            let flux = self.flux(piece, initial.temperatures[piece] + rise, weather, absorbed);
            let source =
                facet.length * (flux - initial.balanced[piece] + self.linear[piece] * rise);
            heat += source;
            let shape = &self.shapes[piece * self.width..][..self.width];
            crate::section::add(&mut self.source, source, shape);
        }
        heat
    }

    /// The sources of the modes that were filled last, W/m.
    pub(super) fn last_sources(&self) -> &[f64] {
        &self.source
    }

    /// Heat flux into a piece of a temperature in K, W/m².
    pub(super) fn flux(
        &self,
        piece: usize,
        temperature: f64,
        weather: &Weather,
        absorbed: &[f64],
    ) -> f64 {
        absorbed[piece] + self.surface.exchanged(piece, &self.exchange, weather, temperature)
    }

    /// The rise of a piece of surface by amplitudes, K.
    pub(super) fn rise(&self, piece: usize, amplitudes: &[f64]) -> f64 {
        dot(self.shape(piece), amplitudes)
    }

    /// Conductance of a piece that the modes have, W/(m²·K).
    pub(super) fn in_modes(&self, piece: usize) -> f64 {
        self.linear[piece]
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
    pub fn shape(&self, piece: usize) -> &[f64] {
        &self.shapes[piece * self.width..][..self.width]
    }
}
