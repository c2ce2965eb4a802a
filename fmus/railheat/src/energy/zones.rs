//! The directions in which the track runs.
//!
//! The sun lights a rail differently where the track turns, so that rail which no wheel has touched is
//! not the same everywhere. Elements whose directions differ by less than [`SECTOR`] share one state of
//! untouched rail, at the mean of their directions. A straight track has a single zone.

use std::f64::consts::TAU;

use super::elements::Extra;
use super::initial::Initial;
use super::untouched::{self, Untouched};
use crate::section::{Modes, dot};
use crate::weather::Light;

/// Directions that differ by less than this share one state of untouched rail: 5°.
///
/// The sunlight on a surface is off by at most 0.044 times the irradiance.
pub const SECTOR: f64 = TAU / 72.0;

/// Azimuth of the running direction, from north over east, rad.
#[derive(Clone, Debug, PartialEq)]
pub enum Azimuth {
    /// The same everywhere.
    Constant(f64),
    /// Of each element.
    Along(Vec<f64>),
}

/// Elements that run in about the same direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Sector {
    /// Mean azimuth, rad.
    pub azimuth: f64,
    /// Number of elements.
    pub elements: usize,
    /// The first of them.
    pub first: usize,
}

/// The sectors of a track, and the sector of each element.
pub fn sectors(azimuth: &Azimuth, elements: usize) -> (Vec<Sector>, Vec<u8>) {
    let along = match azimuth {
        Azimuth::Constant(azimuth) => {
            let all = Sector { azimuth: *azimuth, elements, first: 0 };
            return (vec![all], vec![0; elements]);
        }
        Azimuth::Along(along) => along,
    };
    let reference = along[0];
    let mut sectors: Vec<Sector> = vec![];
    let mut steps: Vec<i64> = vec![];
    let of_element = along.iter().enumerate().map(|(element, azimuth)| {
        let turned = (azimuth - reference) / SECTOR;
        let step = (turned.round() as i64).rem_euclid(72);
        // Nearest direction of the sector's own turn round the compass.
        let deviation = SECTOR * (turned - turned.round());
        let index = steps.iter().position(|known| *known == step).unwrap_or_else(|| {
            steps.push(step);
            sectors.push(Sector { azimuth: 0.0, elements: 0, first: element });
            steps.len() - 1
        });
        let sector = &mut sectors[index];
        sector.elements += 1;
        sector.azimuth += (deviation - sector.azimuth) / sector.elements as f64;
        index as u8
    });
    let of_element = of_element.collect();
    for (sector, step) in sectors.iter_mut().zip(&steps) {
        sector.azimuth += reference + SECTOR * *step as f64;
    }
    (sectors, of_element)
}

/// Untouched rail in one direction, and what it has in common with touched rail there.
#[derive(Clone, Debug)]
pub(crate) struct Zone {
    pub sector: Sector,
    pub initial: Initial,
    pub light: Light,
    pub extra: Extra,
    /// Conductance to the air that the modes have, W/(m²·K).
    pub in_modes: f64,
    /// Temperature of the crown when heat was conducted last, K.
    pub crown: f64,
    /// Rise of untouched rail at each level when heat was conducted last, K.
    pub rises: Vec<f64>,
}

impl Zone {
    /// Reads the state of untouched rail at levels, the first of which is the surface.
    pub fn read(&mut self, state: &untouched::State, levels: &[Vec<f64>], untouched: &Untouched) {
        for (rise, level) in self.rises.iter_mut().zip(levels) {
            *rise = dot(level, &state.amplitudes);
        }
        self.crown = self.initial.crown(untouched.surface()) + self.rises[0];
    }

    /// Heat of untouched rail above the initial state, summed over the zone's elements, J/m.
    pub fn stored(&self, state: &untouched::State, modes: &Modes) -> f64 {
        self.sector.elements as f64 * dot(&modes.content, &state.amplitudes)
    }
}
