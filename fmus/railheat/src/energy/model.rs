//! What happens in which order.
//!
//! In every conduction interval
//! 1. the wheels leave heat of friction, conduction and bending in the elements they pass, and
//!    change their own temperature;
//! 2. untouched rail feels the weather;
//! 3. the elements that were touched conduct their excess over untouched rail, within the section and,
//!    if wanted, along the track.
//!
//! A step of the co-simulation may be shorter or longer than the interval. Without wheels on the
//! rail the intervals are up to [`LONGEST_IDLE`] and reach the end of the step: the modes decay
//! exactly.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::along::Along;
use super::answer::Answer;
use super::elements::{Elements, Section};
use super::followers::Followers;
use super::kept_elements::{KeptElement, Sections};
use super::ledger::{Ledger, Sources};
use super::parameters::Parameters;
use super::untouched::{self, Untouched};
use super::zones::Zone;
use crate::contact::Wheel;
use crate::line::Highest;
use crate::section::{Cells, Crown, Modes, Propagator, Readings};
use crate::weather::Weather;

/// Slack in comparing times, s: steps are sums of rounded numbers.
const SAME_TIME: f64 = 1e-9;

/// Longest interval without wheels, s.
pub const LONGEST_IDLE: f64 = 60.0;

/// All that changes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    pub(super) elements: Elements,
    /// Where the rise of the whole section is kept.
    pub(super) kept_elements: Vec<KeptElement>,
    /// Untouched rail in each direction of the track.
    pub(super) untouched: Vec<untouched::State>,
    /// Until when heat has been conducted, s.
    pub(super) conducted: f64,
    /// Where each wheel was at the end of the last step, m.
    pub(super) positions: Vec<Option<f64>>,
    /// Temperature of each wheel, K.
    pub(super) wheels: Vec<f64>,
    pub(super) ledger: Ledger,
    pub(super) highest: Vec<Highest>,
    pub(super) highest_flash: f64,
    pub(super) answer: Answer,
    pub(super) stray_warned: bool,
}

/// The model of one rail.
pub struct EnergyModel {
    pub(super) parameters: Parameters,
    pub(super) cells: Cells,
    pub(super) modes: Modes,
    pub(super) crown: Crown,
    pub(super) readings: Readings,
    pub(super) followers: Followers,
    /// Amplitudes by bending heat of 1 J/m.
    pub(super) bending: Vec<f64>,
    /// Heat of hysteresis by a wheel load of one, over the square of the load, J/(m·N²).
    pub(super) hysteresis: f64,
    pub(super) untouched: Untouched,
    pub(super) propagator: Propagator,
    /// Directions of the track.
    pub(super) zones: Vec<Zone>,
    /// The direction of each element.
    pub(super) zone_of: Vec<u8>,
    /// Conduction along the track, if wanted.
    pub(super) along: Option<Along>,
    /// What is needed where the rise of the whole section is kept.
    pub(super) sections: Option<Sections>,
    /// Wheels of each vehicle.
    pub(super) vehicles: Vec<Range<usize>>,
    /// Excess of the crown of each element when heat was conducted last, K.
    pub(super) surface: Vec<f64>,
    /// Highest excess of the foot when heat was conducted last.
    pub(super) foot: Highest,
    /// Where each loaded wheel is when heat is conducted, m.
    pub(super) chainages: Vec<Option<f64>>,
    pub(super) source: Vec<f64>,
    pub(super) state: State,
}

impl EnergyModel {
    /// Takes the rail and the wheels over a step; see [`HeatModel::step`](crate::HeatModel::step).
    pub(super) fn advance(&mut self, wheels: &[Wheel], weather: &Weather, start: f64, length: f64) {
        for (position, wheel) in self.state.positions.iter_mut().zip(wheels) {
            position.get_or_insert(wheel.position - wheel.speed * length);
        }
        self.state.highest_flash = self.flash(wheels);
        let interval = self.interval(wheels, start + length);
        let mut done = 0.0;
        loop {
            let next = self.state.conducted + interval;
            if next > start + length + SAME_TIME {
                break;
            }
            let share = ((next - start) / length).clamp(done, 1.0);
            self.pass(wheels, weather, length, done, share);
            self.conduct(wheels, weather, next, share);
            done = share;
        }
        if done < 1.0 {
            self.pass(wheels, weather, length, done, 1.0);
        }
        for (position, wheel) in self.state.positions.iter_mut().zip(wheels) {
            *position = wheel.present_position();
        }
    }

    /// Length of the conduction intervals of a step that ends at `end`, s.
    ///
    /// Without wheels on the rail a whole number of them reaches the end.
    fn interval(&self, wheels: &[Wheel], end: f64) -> f64 {
        let interval = self.parameters.interval;
        let left = end - self.state.conducted;
        if left < interval || self.any_wheel(wheels) {
            return interval;
        }
        left / (left / LONGEST_IDLE.max(interval)).ceil()
    }

    /// Highest flash rise of the wheels on the rail.
    fn flash(&self, wheels: &[Wheel]) -> f64 {
        let Parameters { wheel: heat, material, line, .. } = &self.parameters;
        let on_line = wheels.iter().filter(|wheel| line.element(wheel.position).is_some());
        on_line.map(|wheel| heat.flash(wheel, material)).fold(0.0, f64::max)
    }

    /// Whether a wheel is or was on the modelled rail in this step.
    fn any_wheel(&self, wheels: &[Wheel]) -> bool {
        let line = &self.parameters.line;
        let on_line = |position: f64| line.element(position).is_some();
        wheels.iter().zip(&self.state.positions).any(|(wheel, before)| {
            wheel.contact.normal_force > 0.0
                && (on_line(wheel.position) || before.is_some_and(on_line))
        })
    }

    /// The wheels go from one share of the step to another and leave heat where they pass.
    fn pass(&mut self, wheels: &[Wheel], weather: &Weather, length: f64, from: f64, to: f64) {
        let Parameters { line, material, wheel: heat, .. } = &self.parameters;
        let time = length * (to - from);
        for (index, wheel) in wheels.iter().enumerate() {
            if wheel.is_absent() {
                self.state.wheels[index] = weather.ambient + heat.initial_rise;
                continue;
            }
            let temperature = self.state.wheels[index];
            let mut gained = heat.gain(wheel, temperature, weather.ambient, time);
            let load = wheel.contact.normal_force;
            if load > 0.0 {
                let begin = self.state.positions[index].unwrap_or(wheel.position);
                let [start, end] = [from, to].map(|share| between(begin, wheel.position, share));
                let friction = heat.partition * wheel.friction_power * time;
                let conductance = heat.conductance(wheel, material) * time;
                let bending = self.hysteresis * load * load * (end - start).abs();
                for (element, share) in line.shares(start, end) {
                    let rail = self.zones[usize::from(self.zone_of[element])].crown;
                    let over = temperature - rail - self.surface[element];
                    let left = Sources {
                        friction: friction * share,
                        chill: conductance * over * share,
                        bending: bending * share,
                        weather: 0.0,
                    };
                    gained -= left.chill;
                    self.state.elements.deposit(element, &wheel.into(), left, line.element_length);
                }
            }
            self.state.wheels[index] += gained / heat.capacity;
        }
    }

    /// Weather and conduction until a time, at which the wheels have done a share of the step.
    fn conduct(&mut self, wheels: &[Wheel], weather: &Weather, until: f64, share: f64) {
        let time = until - self.state.conducted;
        let begins = &self.state.positions;
        for ((chainage, wheel), begin) in self.chainages.iter_mut().zip(wheels).zip(begins) {
            let loaded = begin.filter(|_| wheel.contact.normal_force > 0.0);
            *chainage = loaded.map(|begin| between(begin, wheel.position, share));
        }
        let mut weather = *weather;
        if let Some(ephemeris) = &self.parameters.ephemeris {
            weather.sun = ephemeris.at(until - 0.5 * time);
        }
        self.cover(&weather, time);
        if self.propagator.set_time(&self.modes, time) {
            self.followers.set_time(&self.propagator);
        }
        for (zone, state) in self.zones.iter_mut().zip(&mut self.state.untouched) {
            let Zone { light, initial, sector, .. } = zone;
            let (outline, azimuth) = (&self.parameters.outline, sector.azimuth);
            let (surface, exchange) = (self.untouched.surface(), self.untouched.exchange());
            light.update(outline, surface, exchange, &weather, azimuth);
            let absorbed = &light.absorbed;
            self.untouched.step(state, initial, &self.modes, &weather, absorbed, time);
        }
        self.update_extra(wheels, &weather);
        self.step_sections(time);
        // Half before and half after, so that heat which comes in meanwhile flows half the time.
        self.conduct_along(0.5 * time);
        let elements = &mut self.state.elements;
        for element in 0..elements.count() {
            if elements.is_touched(element) {
                let section = Section {
                    modes: &self.modes,
                    followers: &self.followers,
                    crown: &self.crown,
                    bending: &self.bending,
                    propagator: &self.propagator,
                    extra: &self.zones[usize::from(self.zone_of[element])].extra,
                };
                elements.step(element, &section, &mut self.source);
            }
        }
        self.conduct_along(0.5 * time);
        self.state.conducted = until;
        self.read();
        self.note_findings();
    }

    /// Conduction along the track for a time, if wanted.
    fn conduct_along(&mut self, time: f64) {
        if let Some(along) = &mut self.along {
            let length = self.parameters.line.element_length;
            let number = self.parameters.material.diffusivity() * time / (length * length);
            along.conduct(&mut self.state.elements, &self.modes, number);
        }
    }
}

/// The chainage at a share of the distance from `begin` to `end`; exactly `end` at the end.
fn between(begin: f64, end: f64, share: f64) -> f64 {
    if share < 1.0 { begin + share * (end - begin) } else { end }
}
