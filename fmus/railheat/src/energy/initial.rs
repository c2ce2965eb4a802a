//! The rail's temperatures at the start, from which all rises count.

use crate::section::{Modes, crown_piece};
use crate::weather::Surface;

/// Temperatures of the surface at the start, and what they do by themselves.
#[derive(Clone, Debug, PartialEq)]
pub struct Initial {
    /// Temperature of each piece of the surface, K.
    pub temperatures: Vec<f64>,
    /// Flux into each piece that conduction balances at the start, W/m².
    pub balanced: Vec<f64>,
    /// Sources of the modes by which the section evens out, W/m; zero in equilibrium.
    pub equalising: Vec<f64>,
}

impl Initial {
    /// A rail of one temperature in K, with so many pieces of surface.
    pub fn uniform(pieces: usize, modes: &Modes, temperature: f64) -> Self {
        Self {
            temperatures: vec![temperature; pieces],
            balanced: vec![0.0; pieces],
            equalising: vec![0.0; modes.width()],
        }
    }

    /// Mean temperature of the surface, K.
    pub fn mean(&self, surface: &Surface) -> f64 {
        let facets = surface.facets();
        let sum: f64 = facets.iter().zip(&self.temperatures).map(|(f, t)| f.length * t).sum();
        sum / facets.iter().map(|facet| facet.length).sum::<f64>()
    }

    /// Temperature of the piece of surface at the middle of the crown, K.
    pub fn crown(&self, surface: &Surface) -> f64 {
        self.temperatures[crown_piece(surface.facets())]
    }
}
