//! What is read after each conduction: highest rises, the ledger, what cameras see of the foot.

use super::answer::Finding;
use super::ledger::{Ledger, Sources};
use super::model::EnergyModel;
use crate::line::Highest;
use crate::section::dot;

impl EnergyModel {
    /// Reads untouched rail and counts the heat of all elements.
    pub(super) fn read(&mut self) {
        self.read_untouched();
        let Self { readings, modes, surface, parameters, state, zones, zone_of, foot, .. } = self;
        let line = &parameters.line;
        for (level, highest) in state.highest.iter_mut().enumerate() {
            let highest_zone =
                zones.iter().max_by(|a, b| a.rises[level].total_cmp(&b.rises[level]));
            if let Some(zone) = highest_zone {
                let chainage = line.chainage(zone.sector.first);
                *highest = Highest { rise: zone.rises[level], chainage };
            }
        }
        *foot = Highest { rise: 0.0, chainage: line.chainage(0) };
        let (mut stored, mut sources) = (0.0, Sources::default());
        let last = readings.levels.len() - 1;
        for (element, surface) in surface.iter_mut().enumerate() {
            if !state.elements.is_touched(element) {
                continue;
            }
            let amplitudes = state.elements.amplitudes(element);
            let rises = &zones[usize::from(zone_of[element])].rises;
            stored += dot(&modes.content, amplitudes);
            sources += state.elements.sources(element);
            let followed = state.elements.followed(element);
            *surface = dot(&readings.levels[0], amplitudes) + followed[0];
            let chainage = line.chainage(element);
            for (level, highest) in state.highest.iter_mut().enumerate() {
                let excess = match level {
                    0 => *surface,
                    _ => dot(&readings.levels[level], amplitudes) + followed[level],
                };
                if excess + rises[level] > highest.rise {
                    *highest = Highest { rise: excess + rises[level], chainage };
                }
                if level == last && excess > foot.rise {
                    *foot = Highest { rise: excess, chainage };
                }
            }
        }
        for (zone, untouched) in zones.iter().zip(&state.untouched) {
            sources.weather += zone.sector.elements as f64 * untouched.weather;
            stored += zone.stored(untouched, modes);
        }
        let length = line.element_length;
        state.ledger = Ledger { stored: stored * length, sources: sources.times(length) };
    }

    /// Reads untouched rail in all directions.
    pub(super) fn read_untouched(&mut self) {
        let Self { readings, untouched, zones, state, .. } = self;
        for (zone, state) in zones.iter_mut().zip(&state.untouched) {
            zone.read(state, &readings.levels, untouched);
        }
    }

    /// Notes what cameras see of the foot.
    pub(super) fn note_findings(&mut self) {
        let Self { readings, parameters, state, chainages, foot, .. } = self;
        let line = &parameters.line;
        let time = state.conducted;
        let finding = Finding { rise: foot.rise, chainage: foot.chainage, time };
        state.answer.note(finding, parameters.threshold);
        let last = chainages.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        if let Some(element) = line.element(last) {
            let rise = state.elements.read(element, readings, readings.levels.len() - 1);
            state.answer.note_from_train(Finding { rise, chainage: last, time });
        }
    }
}
