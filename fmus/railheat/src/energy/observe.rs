//! What is read after each conduction: highest rises, the ledger, what cameras see of the foot.

use super::answer::Finding;
use super::ledger::{Ledger, Sources};
use super::model::Energy;
use crate::rail::Highest;
use crate::section::dot;

impl Energy {
    /// Reads the levels and counts the heat of all elements.
    pub(super) fn read(&mut self) {
        let Self { readings, modes, surface, parameters, state, .. } = self;
        let line = &parameters.line;
        let nowhere = Highest { rise: 0.0, chainage: line.chainage(0) };
        state.highest.fill(nowhere);
        let (mut stored, mut sources) = (0.0, Sources::default());
        for (element, surface) in surface.iter_mut().enumerate() {
            if !state.elements.is_touched(element) {
                continue;
            }
            let amplitudes = state.elements.amplitudes(element);
            stored += dot(&modes.content, amplitudes);
            sources += state.elements.sources(element);
            *surface = dot(readings.surface(), amplitudes);
            for (place, highest) in state.highest.iter_mut().enumerate() {
                let excess =
                    if place == 0 { *surface } else { dot(&readings.levels[place], amplitudes) };
                if excess > highest.rise {
                    *highest = Highest { rise: excess, chainage: line.chainage(element) };
                }
            }
        }
        let untouched = &state.untouched;
        for (highest, level) in state.highest.iter_mut().zip(&readings.levels) {
            highest.rise += dot(level, &untouched.amplitudes);
        }
        let elements = line.elements as f64;
        sources.weather += elements * untouched.weather;
        stored += elements * dot(&modes.content, &untouched.amplitudes);
        let length = line.element_length;
        state.ledger = Ledger { stored: stored * length, sources: sources.times(length) };
    }

    /// What cameras see of the foot.
    pub(super) fn find(&mut self) {
        let Self { readings, parameters, state, places, .. } = self;
        let line = &parameters.line;
        let foot = state.highest[state.highest.len() - 1];
        let rise = foot.rise - dot(readings.foot(), &state.untouched.amplitudes);
        let time = state.conducted;
        let finding = Finding { rise, chainage: foot.chainage, time };
        state.answer.note(finding, parameters.threshold);
        let last = places.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        if let Some(element) = line.element(last) {
            let rise = dot(readings.foot(), state.elements.amplitudes(element));
            state.answer.note_from_train(Finding { rise, chainage: last, time });
        }
    }
}
