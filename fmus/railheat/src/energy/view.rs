//! What can be read of the model.

use super::answer::Answer;
use super::ledger::{Ledger, Sources};
use super::model::{EnergyModel, State};
use super::parameters::Parameters;
use super::untouched;
use super::zones::Zone;
use crate::contact::Wheel;
use crate::heat_model::{HeatModel, KeptSections};
use crate::line::{Highest, Line, Stray};
use crate::section::{Modes, dot};
use crate::weather::Weather;

impl EnergyModel {
    /// The model's constants.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// The modes of the section.
    pub fn modes(&self) -> &Modes {
        &self.modes
    }

    /// Number of amplitudes that are kept for each element; modes beyond follow the heat.
    pub fn kept(&self) -> usize {
        self.state.elements.width()
    }

    /// Number of levels at which the rise is read: surface, the parameters' depths, foot.
    pub fn levels(&self) -> usize {
        self.readings.levels.len()
    }

    /// The rise of an element over untouched rail at a level, K.
    pub fn excess(&self, element: usize, level: usize) -> f64 {
        self.state.elements.read(element, &self.readings, level)
    }

    fn zone(&self, element: usize) -> &Zone {
        &self.zones[usize::from(self.zone_of[element])]
    }

    fn untouched_state(&self, element: usize) -> &untouched::State {
        &self.state.untouched[usize::from(self.zone_of[element])]
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
            *surface = self.state.elements.read(element, &self.readings, 0);
        }
        self.read_untouched();
    }
}

impl HeatModel for EnergyModel {
    fn name(&self) -> &'static str {
        "energy"
    }

    fn step(
        &mut self,
        wheels: &[Wheel],
        weather: &Weather,
        start: f64,
        length: f64,
    ) -> Option<Stray> {
        self.advance(wheels, weather, start, length);
        self.parameters.line.first_stray(wheels, &mut self.state.stray_warned)
    }

    fn line(&self) -> &Line {
        &self.parameters.line
    }

    fn initial_temperature(&self) -> f64 {
        self.zones[0].initial.crown(self.untouched.surface())
    }

    fn depths(&self) -> Vec<f64> {
        self.readings.depths.clone()
    }

    fn snapshot(&self, values: &mut [f32]) {
        let Self { readings, state, .. } = self;
        let levels = readings.levels.len();
        let of_zone = |zone: &untouched::State| -> Vec<f64> {
            readings.rows.iter().map(|row| dot(row, &zone.amplitudes)).collect()
        };
        let untouched: Vec<Vec<f64>> = state.untouched.iter().map(of_zone).collect();
        let columns = values.chunks_exact_mut(readings.rows.len());
        for ((element, column), zone) in columns.enumerate().zip(&self.zone_of) {
            let untouched = &untouched[usize::from(*zone)];
            if !state.elements.is_touched(element) {
                column.iter_mut().zip(untouched).for_each(|(value, rise)| *value = *rise as f32);
                continue;
            }
            for (row, (value, rise)) in column.iter_mut().zip(untouched).enumerate() {
                *value = (rise + state.elements.read(element, readings, levels + row)) as f32;
            }
        }
    }

    fn kept_sections(&self) -> Option<KeptSections<'_>> {
        self.kept_sections()
    }

    fn sections(&self, values: &mut [f32]) {
        values.iter_mut().zip(self.section_rises()).for_each(|(value, rise)| *value = rise as f32);
    }

    fn warmest_section(&self, values: &mut [f32]) -> f64 {
        let (chainage, rises) = self.warmest_section();
        values.iter_mut().zip(rises).for_each(|(value, rise)| *value = rise as f32);
        chainage
    }

    fn rise(&self, element: usize, level: usize) -> f64 {
        self.zone(element).rises[level] + self.excess(element, level)
    }

    fn highest(&self) -> &[Highest] {
        &self.state.highest
    }

    fn highest_flash(&self) -> f64 {
        self.state.highest_flash
    }

    fn untouched_surface(&self) -> f64 {
        self.zones[0].rises[0]
    }

    fn heat_per_metre(&self, element: usize) -> f64 {
        dot(&self.modes.content, &self.untouched_state(element).amplitudes)
            + self.state.elements.heat(element, &self.modes)
    }
}
