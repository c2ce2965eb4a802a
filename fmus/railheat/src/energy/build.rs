//! The model at its start, and what can be read of it.

use std::ops::Range;

use super::answer::Answer;
use super::crown::Crown;
use super::elements::{Elements, Extra};
use super::ledger::{Ledger, Sources};
use super::light::Light;
use super::model::{Energy, State};
use super::parameters::{Parameters, Resolution, Start};
use super::propagator::Propagator;
use super::readings::Readings;
use super::untouched::{self, Untouched};
use super::weather::{Surface, Weather};
use crate::rail::Highest;
use crate::section::{Cells, Modes, NoModes, dot};
use crate::wheels::Wheel;

impl Energy {
    /// A rail at its start, with so many wheels on each vehicle.
    ///
    /// # Errors
    /// When the section has too few or too many cells.
    pub fn new(
        parameters: Parameters,
        wheelsets: &[usize],
        weather: &Weather,
        start_time: f64,
    ) -> Result<Self, NoModes> {
        let Parameters { outline, material, exchange, cell_size, .. } = &parameters;
        let cells = match parameters.resolution {
            Resolution::Column => Cells::column(outline, *cell_size),
            Resolution::Plane => Cells::grid(outline, *cell_size),
        };
        let surface = Surface::new(&cells);
        let light = Light::new(outline, &surface, exchange, weather);
        let temperature = match parameters.start {
            Start::Uniform(temperature) => temperature,
            Start::Equilibrium => surface.balance(exchange, weather, &light.absorbed),
        };
        let linear = surface.conductances(exchange, weather.wind, temperature);
        let modes = Modes::new(&cells, material, &linear, parameters.shortest, *cell_size)?;
        let mean = modes.weighted(surface.shares());
        let mut untouched = Untouched::uniform(surface, *exchange, linear, &modes, temperature);
        if parameters.start == Start::Equilibrium {
            untouched.settle(&modes, weather, &light.absorbed);
        }
        let readings = Readings::new(&cells, &modes, &parameters.depths);
        let wheels = wheelsets.iter().sum();
        let initial =
            State::new(&parameters, &readings, modes.width(), wheels, weather, start_time);
        Ok(Self {
            in_modes: exchange.coefficient(weather.wind)
                + exchange.radiation(untouched.initial_mean()),
            crown: Crown::new(&cells, &modes),
            bending: bending_shape(&cells, &modes, &parameters),
            propagator: Propagator::new(&modes, parameters.interval),
            extra: Extra::none(mean),
            surface: vec![0.0; parameters.line.elements],
            places: vec![None; wheels],
            source: vec![0.0; modes.width()],
            vehicles: vehicles(wheelsets),
            state: initial,
            light,
            untouched,
            readings,
            modes,
            parameters,
        })
    }

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
        let shape = &self.readings.levels[level];
        dot(shape, &self.state.untouched.amplitudes) + self.excess(element, level)
    }

    /// The rise of an element over untouched rail at a level, K.
    pub fn excess(&self, element: usize, level: usize) -> f64 {
        dot(&self.readings.levels[level], self.state.elements.amplitudes(element))
    }

    /// The rise at the surface where no wheel has been, K.
    pub fn untouched_surface(&self) -> f64 {
        dot(self.readings.surface(), &self.state.untouched.amplitudes)
    }

    /// Temperature of the middle of the crown at the start, K.
    pub fn initial_temperature(&self) -> f64 {
        self.untouched.initial_crown()
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
        dot(&self.modes.content, &self.state.untouched.amplitudes)
            + self.state.elements.heat(element, &self.modes)
    }

    /// Heat by source per metre of rail at an element, J/m.
    pub fn sources_per_metre(&self, element: usize) -> Sources {
        let mut sources = self.state.elements.sources(element);
        sources.weather += self.state.untouched.weather;
        sources
    }

    /// Reversible temperature change of the foot at a chainage by the bending under all wheels, K.
    pub fn thermoelastic(&self, chainage: f64, wheels: &[Wheel]) -> f64 {
        let Parameters { beam, material, .. } = &self.parameters;
        let moment: f64 = wheels
            .iter()
            .map(|wheel| beam.moment(wheel.contact.normal_force, wheel.position - chainage))
            .sum();
        beam.thermoelastic(moment, self.untouched.initial_mean(), material.heat_capacity())
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
                *value = (dot(row, &self.state.untouched.amplitudes) + excess) as f32;
            }
        }
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
    }
}

impl State {
    fn new(
        parameters: &Parameters,
        readings: &Readings,
        width: usize,
        wheels: usize,
        weather: &Weather,
        start_time: f64,
    ) -> Self {
        let nowhere = Highest { rise: 0.0, chainage: parameters.line.chainage(0) };
        Self {
            elements: Elements::new(parameters.line.elements, width),
            untouched: untouched::State { amplitudes: vec![0.0; width], weather: 0.0 },
            conducted: start_time,
            positions: vec![None; wheels],
            wheels: vec![weather.ambient + parameters.wheel.initial_rise; wheels],
            ledger: Ledger::default(),
            highest: vec![nowhere; readings.levels.len()],
            highest_flash: 0.0,
            answer: Answer::default(),
            stray_told: false,
        }
    }
}

/// Amplitudes by 1 J/m of hysteresis heat: with the square of the distance from the neutral axis.
fn bending_shape(cells: &Cells, modes: &Modes, parameters: &Parameters) -> Vec<f64> {
    let axis = parameters.outline.properties().centroid;
    let weight = |cell: &crate::section::Cell| cell.area * (cell.middle.z - axis).powi(2);
    let sum: f64 = cells.cells.iter().map(weight).sum();
    modes.weighted(cells.cells.iter().enumerate().map(|(i, cell)| (i, weight(cell) / sum)))
}

/// The wheels of each vehicle in the order of all wheels.
fn vehicles(wheelsets: &[usize]) -> Vec<Range<usize>> {
    let mut first = 0;
    let range = |count: &usize| {
        let range = first..first + count;
        first += count;
        range
    };
    wheelsets.iter().map(range).collect()
}
