//! The rail's temperatures at the start, from which all rises count.

use crate::section::Modes;
use crate::weather::Surface;

/// Temperatures of the surface at the start, and what they do by themselves.
#[derive(Clone, Debug, PartialEq)]
pub struct Initial {
    /// Temperature of each piece of the surface, K.
    pub temperatures: Vec<f64>,
    /// Flux into each piece that conduction balances at the start, W/m².
    pub balanced: Vec<f64>,
    /// Sources of the modes by which the section evens out, W/m; zero in equilibrium.
    pub evening_out: Vec<f64>,
}

impl Initial {
    /// A rail of one temperature in K.
    pub fn uniform(untouched: &Untouched, modes: &Modes, temperature: f64) -> Self {
        let pieces = untouched.surface().facets().len();
        Self {
            temperatures: vec![temperature; pieces],
            balanced: vec![0.0; pieces],
            evening_out: vec![0.0; modes.width()],
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
        let facets = surface.facets();
        let distance = |i: &usize| facets[*i].middle().y.hypot(facets[*i].middle().z);
        let nearest = (0..facets.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.map_or(f64::NAN, |piece| self.temperatures[piece])
    }
}
