//! The heat model that the parameter `model` chooses.

use std::ops::{Deref, DerefMut};

use serde::{Deserialize, Serialize};

use crate::energy::{self, EnergyModel};
use crate::heat_model::HeatModel;
use crate::paper::{self, PaperModel};

/// One of the heat models.
pub(crate) enum ChosenModel {
    /// `model = "paper"`
    Paper(Box<PaperModel>),
    /// `model = "energy"`
    Energy(Box<EnergyModel>),
}

/// The state of one of the heat models.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum State {
    /// Of `model = "paper"`.
    Paper(Box<paper::State>),
    /// Of `model = "energy"`.
    Energy(Box<energy::State>),
}

impl ChosenModel {
    /// Keeps the rise of the whole section at some elements, if the model has a section.
    pub fn keep_sections(&mut self, elements: &[usize], field_side_is_right: bool) {
        if let Self::Energy(model) = self {
            model.keep_sections(elements, field_side_is_right);
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
}

impl Deref for ChosenModel {
    type Target = dyn HeatModel;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Paper(model) => model.as_ref(),
            Self::Energy(model) => model.as_ref(),
        }
    }
}

impl DerefMut for ChosenModel {
    fn deref_mut(&mut self) -> &mut Self::Target {
        match self {
            Self::Paper(model) => model.as_mut(),
            Self::Energy(model) => model.as_mut(),
        }
    }
}
