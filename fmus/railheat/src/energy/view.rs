//! What can be read of the model.

use super::answer::Answer;
use super::ledger::{Ledger, Sources};
use super::model::{Energy, State};
use super::parameters::Parameters;
use super::untouched;
use super::zones::Zone;
use crate::rail::Highest;
use crate::section::{Modes, dot};
use crate::wheels::Wheel;

impl Energy {
    /// The model's constants.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// The modes of the section.
    pub fn modes(&self) -> &Modes {
        &self.modes
    }

    /// Number of levels at which the rise is read: surface, the parameters' depths, foot.
    pub fn levels(&self) -> usize {
        self.readings.levels.len()
    }

    /// The rise of an element over the initial state at a level, K.
    pub fn rise(&self, element: usize, level: usize) -> f64 {
        self.zone(element).rises[level] + self.excess(element, level)
    }

    /// The rise of an element over untouched rail at a level, K.
    pub fn excess(&self, element: usize, level: usize) -> f64 {
        dot(&self.readings.levels[level], self.state.elements.amplitudes(element))
    }

    /// The rise at the surface where no wheel has been, at the beginning of the track, K.
    pub fn untouched_surface(&self) -> f64 {
        self.zones[0].rises[0]
    }

    /// Temperature of the middle of the crown at the start, at the beginning of the track, K.
    pub fn initial_temperature(&self) -> f64 {
        self.zones[0].initial.crown(self.untouched.surface())
    }

    fn zone(&self, element: usize) -> &Zone {
        &self.zones[usize::from(self.zone_of[element])]
    }

    fn untouched_state(&self, element: usize) -> &untouched::State {
        &self.state.untouched[usize::from(self.zone_of[element])]
    }

    /// The highest rise at each level when heat was conducted last.
    pub fn highest(&self) -> &[Highest] {
        &self.state.highest
    }

    /// The highest flash rise of any wheel in the last step, K.
    pub fn highest_flash(&self) -> f64 {
        self.state.highest_flash
    }

    /// Temperature of each wheel, K.
    pub fn wheel_temperatures(&self) -> &[f64] {
        &self.state.wheels
    }

    /// Where the heat of the whole rail came from and where it was when heat was conducted last.
    pub fn ledger(&self) -> Ledger {
        self.state.ledger
    }

    /// What cameras see of the foot.
    pub fn answer(&self) -> &Answer {
        &self.state.answer
    }

    /// Heat above the initial state per metre of rail at an element, J/m.
    pub fn heat_per_metre(&self, element: usize) -> f64 {
        dot(&self.modes.content, &self.untouched_state(element).amplitudes)
            + self.state.elements.heat(element, &self.modes)
    }

    /// Heat by source per metre of rail at an element, J/m.
    pub fn sources_per_metre(&self, element: usize) -> Sources {
        let mut sources = self.state.elements.sources(element);
        sources.weather += self.untouched_state(element).weather;
        sources
    }

    /// Reversible temperature change of the foot at a chainage by the bending under all wheels, K.
    pub fn thermoelastic(&self, chainage: f64, wheels: &[Wheel]) -> f64 {
        let Parameters { beam, material, .. } = &self.parameters;
        let load = |wheel: &Wheel| (wheel.contact.normal_force, wheel.position - chainage);
        let moment = beam.moment(wheels.iter().map(load));
        let temperature = self.zones[0].initial.mean(self.untouched.surface());
        beam.thermoelastic(moment, temperature, material.heat_capacity())
    }

    /// Depth of each row of a snapshot, m.
    pub fn depths(&self) -> &[f64] {
        &self.readings.depths
    }

    /// Writes the rises on the middle line into `values`, the depths of the first element first.
    pub fn snapshot(&self, values: &mut [f32]) {
        let rows = &self.readings.rows;
        for (element, column) in values.chunks_exact_mut(rows.len()).enumerate() {
            let amplitudes = self.state.elements.amplitudes(element);
            let touched = self.state.elements.is_touched(element);
            for (value, row) in column.iter_mut().zip(rows) {
                let excess = if touched { dot(row, amplitudes) } else { 0.0 };
                *value = (dot(row, &self.untouched_state(element).amplitudes) + excess) as f32;
            }
        }
    }

    /// Number of elements that something has touched; the others cost nothing.
    pub fn touched(&self) -> usize {
        let elements = &self.state.elements;
        (0..elements.count()).filter(|element| elements.is_touched(*element)).count()
    }

    /// All that changes, for saving.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Puts a saved state back.
    pub fn restore(&mut self, state: State) {
        self.state = state;
        for (element, surface) in self.surface.iter_mut().enumerate() {
            *surface = dot(self.readings.surface(), self.state.elements.amplitudes(element));
        }
        self.read_untouched();
    }
}
