//! The chosen heat model.

use serde::{Deserialize, Serialize};

use crate::contact::Wheel;
use crate::line::Highest;
use crate::{energy, paper};

/// One of the models.
pub(crate) enum Heat {
    /// `model = "paper"`
    Paper(Box<paper::Paper>),
    /// `model = "energy"`
    Energy(Box<energy::Energy>),
}

/// The state of one of the models.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum State {
    /// Of `model = "paper"`.
    Paper(Box<paper::State>),
    /// Of `model = "energy"`.
    Energy(Box<energy::State>),
}

/// The elements along the track.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span {
    pub begin: f64,
    pub element_length: f64,
    pub elements: usize,
}

impl Span {
    /// Chainage at which the last element ends, m.
    pub fn end(&self) -> f64 {
        self.begin + self.elements as f64 * self.element_length
    }

    /// Chainage of the middle of an element, m.
    pub fn chainage(&self, element: usize) -> f64 {
        self.begin + (element as f64 + 0.5) * self.element_length
    }
}

impl Heat {
    /// Its name, as the parameter `model` has it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Paper(_) => "paper",
            Self::Energy(_) => "energy",
        }
    }

    /// One step; each model sees of the weather what it knows.
    pub fn step(
        &mut self,
        wheels: &[Wheel],
        weather: &Weather,
        start: f64,
        length: f64,
    ) -> Option<Stray> {
        match self {
            Self::Paper(model) => {
                let weather =
                    paper::Weather { ambient: weather.ambient, irradiance: weather.direct };
                model.step(wheels, &weather, start, length)
            }
            Self::Energy(model) => model.step(wheels, weather, start, length),
        }
    }

    /// All that changes, for saving.
    pub fn state(&self) -> State {
        match self {
            Self::Paper(model) => State::Paper(Box::new(model.state().clone())),
            Self::Energy(model) => State::Energy(Box::new(model.state().clone())),
        }
    }

    /// Puts a saved state back. The instance builds the model of the state's parameters first,
    /// so that the two are of one kind.
    pub fn restore(&mut self, state: State) {
        match (self, state) {
            (Self::Paper(model), State::Paper(state)) => model.restore(*state),
            (Self::Energy(model), State::Energy(state)) => model.restore(*state),
            (Self::Paper(_), State::Energy(_)) | (Self::Energy(_), State::Paper(_)) => {}
        }
    }

    /// The elements along the track.
    pub fn span(&self) -> Span {
        let (begin, element_length, elements) = match self {
            Self::Paper(model) => {
                let grid = &model.parameters().grid;
                (grid.begin, grid.element_length, grid.elements)
            }
            Self::Energy(model) => {
                let line = &model.parameters().line;
                (line.begin, line.element_length, line.elements)
            }
        };
        Span { begin, element_length, elements }
    }

    /// Temperature of the running surface at the start, K.
    pub fn initial_temperature(&self) -> f64 {
        match self {
            Self::Paper(model) => model.parameters().initial_temperature,
            Self::Energy(model) => model.initial_temperature(),
        }
    }

    /// Depths of a snapshot's values, m.
    pub fn depths(&self) -> Vec<f64> {
        match self {
            Self::Paper(model) => {
                let grid = &model.parameters().grid;
                (0..grid.cells).map(|cell| grid.depth(cell)).collect()
            }
            Self::Energy(model) => model.depths().to_vec(),
        }
    }

    /// Writes the rises into `values`, the depths of the first element first.
    pub fn snapshot(&self, values: &mut [f32]) {
        match self {
            Self::Paper(model) => model.rail().snapshot(&model.parameters().grid, values),
            Self::Energy(model) => model.snapshot(values),
        }
    }

    /// The rise of an element at the surface, the depths of the file and the foot, K.
    pub fn rise(&self, element: usize, level: usize) -> f64 {
        match self {
            Self::Paper(model) => model.rail().rise(element, &model.levels()[level]),
            Self::Energy(model) => model.rise(element, level),
        }
    }

    /// The highest rise at each level.
    pub fn highest(&self) -> &[Highest] {
        match self {
            Self::Paper(model) => model.highest(),
            Self::Energy(model) => model.highest(),
        }
    }

    /// The highest flash rise of any wheel in the last step, K.
    pub fn highest_flash(&self) -> f64 {
        match self {
            Self::Paper(model) => model.highest_flash(),
            Self::Energy(model) => model.highest_flash(),
        }
    }

    /// The rise of the surface where no wheel has been, K.
    pub fn untouched_surface(&self) -> f64 {
        match self {
            Self::Paper(model) => model.rail().untouched_surface(),
            Self::Energy(model) => model.untouched_surface(),
        }
    }

    /// Heat above the initial state per metre of rail at an element, J/m.
    pub fn heat_per_metre(&self, element: usize) -> f64 {
        match self {
            Self::Paper(model) => model.heat_per_metre(element),
            Self::Energy(model) => model.heat_per_metre(element),
        }
    }
}
