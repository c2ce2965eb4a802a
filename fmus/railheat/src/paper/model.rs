//! The paper's model: what happens in which order (section 2.1 of the paper).
//!
//! In every conduction interval
//! 1. each wheel sets the surface of the elements it passes to the temperature of untouched rail
//!    plus its flash rise, unless the surface is hotter already;
//! 2. convection, radiation and the sun act on the surface of all elements;
//! 3. heat is conducted downwards in all elements.
//!
//! Steps of the co-simulation may be shorter or longer than the conduction interval: what wheels
//! do is gathered in between, and a longer step is cut, with the wheels moving evenly.

use serde::{Deserialize, Serialize};

use super::audit::Audit;
use super::column::{Unstable, fourier_number};
use super::rail::{Grid, Level, Rail, SurfaceStep};
use super::running_surface::RunningSurface;
use crate::contact::{Friction, Material, Wheel};
use crate::heat_model::HeatModel;
use crate::line::{Highest, Line, Stray};
use crate::weather::Weather;

/// Slack in comparing times, s: steps are sums of rounded numbers.
const SAME_TIME: f64 = 1e-9;

/// All constants of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// How the rail is cut.
    pub grid: Grid,
    /// Width of the column, m: 75 mm makes Table 4's top area of 0.0075 m² with 0.1 m elements.
    pub width: f64,
    /// Step of weather and conduction, s.
    pub conduction_interval: f64,
    /// Steel of the rail.
    pub material: Material,
    /// Friction of the wheels.
    pub friction: Friction,
    /// Running surface.
    pub surface: RunningSurface,
    /// Temperature of the whole rail at the start, K.
    pub initial_temperature: f64,
    /// Depths at which the highest rise is looked for besides surface and foot, m.
    pub depths: Vec<f64>,
}

/// All that changes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    rail: Rail,
    /// Number of conduction intervals done.
    conducted: u64,
    /// Where each wheel was at the end of the last step, m.
    positions: Vec<Option<f64>>,
    audit: Audit,
    highest: Vec<Highest>,
    highest_flash: f64,
    /// Whether a warning of a stray wheel has been given.
    stray_warned: bool,
}

/// The paper's model of one rail.
pub struct PaperModel {
    parameters: Parameters,
    start_time: f64,
    /// The number s of the conduction.
    number: f64,
    /// RunningSurface, the parameters' depths, foot.
    levels: Vec<Level>,
    /// Heat of a cell that rises by 1 K, J/K.
    cell_capacity: f64,
    /// Flash rise of each wheel in the present step, K.
    flash: Vec<f64>,
    state: State,
}

impl PaperModel {
    /// A rail at its initial temperature, with this many wheels.
    ///
    /// # Errors
    /// When the conduction interval is over the limit of stability.
    pub fn new(parameters: Parameters, wheels: usize, start_time: f64) -> Result<Self, Unstable> {
        let Parameters { grid, material, .. } = &parameters;
        let number = fourier_number(material, parameters.conduction_interval, grid.cell_size)?;
        let volume = grid.cell_size * parameters.width * grid.line.element_length;
        let rail = Rail::new(grid);
        let levels: Vec<Level> = std::iter::once(Level::SURFACE)
            .chain(parameters.depths.iter().map(|depth| Level::at_depth(grid, *depth)))
            .chain([Level::foot(grid)])
            .collect();
        let nowhere = Highest { rise: 0.0, chainage: grid.line.chainage(0) };
        let state = State {
            conducted: 0,
            positions: vec![None; wheels],
            audit: Audit::default(),
            highest: vec![nowhere; levels.len()],
            highest_flash: 0.0,
            stray_warned: false,
            rail,
        };
        Ok(Self {
            number,
            levels,
            cell_capacity: material.heat_capacity() * volume,
            flash: vec![0.0; wheels],
            start_time,
            parameters,
            state,
        })
    }

    /// Computes the flash rise of each wheel, and where new wheels came from.
    fn begin(&mut self, wheels: &[Wheel], length: f64) {
        let Parameters { friction, material, .. } = &self.parameters;
        self.state.highest_flash = 0.0;
        let of_wheels = self.flash.iter_mut().zip(&mut self.state.positions);
        for (wheel, (flash, position)) in wheels.iter().zip(of_wheels) {
            *flash = friction.rise(&wheel.contact, wheel.creepage, wheel.speed, material);
            self.state.highest_flash = self.state.highest_flash.max(*flash);
            position.get_or_insert(wheel.position - wheel.speed * length);
        }
    }

    /// Time at which the next conduction interval ends, s.
    fn next_conduction(&self) -> f64 {
        let intervals = (self.state.conducted + 1) as f64;
        self.start_time + intervals * self.parameters.conduction_interval
    }

    /// The wheels go from one share of the step to another and heat what they pass.
    fn pass(&mut self, wheels: &[Wheel], from: f64, to: f64) {
        let grid = &self.parameters.grid;
        let untouched = self.state.rail.untouched_surface();
        for (index, wheel) in wheels.iter().enumerate() {
            let flash = self.flash[index];
            let Some(begin) = self.state.positions[index].filter(|_| flash > 0.0) else {
                continue;
            };
            let at = |share: f64| begin + share * (wheel.position - begin);
            let end = if to < 1.0 { at(to) } else { wheel.position };
            for element in grid.line.passed(at(from), end).into_iter().flatten() {
                let heated = self.state.rail.heat_surface(element, untouched + flash);
                if heated > 0.0 {
                    self.state.note_heated(heated * self.cell_capacity);
                    self.state.note_surface(untouched + flash, || grid.line.chainage(element));
                }
            }
        }
    }

    /// Weather and conduction over one interval.
    fn conduct(&mut self, weather: &Weather) {
        let Parameters { grid, material, surface, .. } = &self.parameters;
        let exchange = SurfaceStep {
            surface,
            weather,
            initial: self.parameters.initial_temperature,
            rise_per_flux: self.parameters.conduction_interval
                / (material.heat_capacity() * grid.cell_size),
        };
        let state = &mut self.state;
        let sums = state.rail.step(grid, &exchange, self.number, &self.levels, &mut state.highest);
        state.audit.stored = self.cell_capacity * sums.stored;
        state.audit.weather += self.cell_capacity * sums.weather;
        state.conducted += 1;
    }

    /// The model's constants.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// The rail.
    pub fn rail(&self) -> &Rail {
        &self.state.rail
    }

    /// Where the heat came from and where it is.
    pub fn audit(&self) -> Audit {
        self.state.audit
    }

    /// All that changes, for saving.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Puts a saved state back.
    pub fn restore(&mut self, state: State) {
        self.state = state;
    }
}

impl HeatModel for PaperModel {
    fn name(&self) -> &'static str {
        "paper"
    }

    fn step(
        &mut self,
        wheels: &[Wheel],
        weather: &Weather,
        start: f64,
        length: f64,
    ) -> Option<Stray> {
        self.begin(wheels, length);
        let mut done = 0.0;
        loop {
            let next = self.next_conduction();
            if next > start + length + SAME_TIME {
                break;
            }
            // An interval that ends with the step must not, by rounding of the time, leave a rest
            // of it, in which the wheels would heat again what they have just passed.
            let share = match next > start + length - SAME_TIME {
                true => 1.0,
                false => ((next - start) / length).clamp(done, 1.0),
            };
            self.pass(wheels, done, share);
            self.conduct(weather);
            done = share;
        }
        if done < 1.0 {
            self.pass(wheels, done, 1.0);
        }
        for (position, wheel) in self.state.positions.iter_mut().zip(wheels) {
            *position = wheel.present_position();
        }
        self.parameters.grid.line.first_stray(wheels, &mut self.state.stray_warned)
    }

    fn line(&self) -> &Line {
        &self.parameters.grid.line
    }

    fn initial_temperature(&self) -> f64 {
        self.parameters.initial_temperature
    }

    fn depths(&self) -> Vec<f64> {
        let grid = &self.parameters.grid;
        (0..grid.cells).map(|cell| grid.depth(cell)).collect()
    }

    fn snapshot(&self, values: &mut [f32]) {
        self.state.rail.snapshot(&self.parameters.grid, values);
    }

    fn rise(&self, element: usize, level: usize) -> f64 {
        self.state.rail.rise(element, &self.levels[level])
    }

    fn highest(&self) -> &[Highest] {
        &self.state.highest
    }

    fn highest_flash(&self) -> f64 {
        self.state.highest_flash
    }

    fn untouched_surface(&self) -> f64 {
        self.state.rail.untouched_surface()
    }

    fn heat_per_metre(&self, element: usize) -> f64 {
        let of_element = self.state.rail.sum(element) * self.cell_capacity;
        of_element / self.parameters.grid.line.element_length
    }
}

impl State {
    /// Adds the heat in J that a wheel put in.
    fn note_heated(&mut self, heat: f64) {
        self.audit.imposed += heat;
        self.audit.stored += heat;
    }

    /// A surface has been heated to `rise`: keeps the highest up to date between conduction steps.
    fn note_surface(&mut self, rise: f64, chainage: impl Fn() -> f64) {
        if let Some(highest) = self.highest.first_mut().filter(|highest| rise > highest.rise) {
            *highest = Highest { rise, chainage: chainage() };
        }
    }
}
