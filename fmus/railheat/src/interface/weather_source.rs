//! The weather over time: of a file, or of the inputs.

use std::path::Path;

use fmu::{ModelError, Values, Variables};

use super::inputs::WeatherInputs;
use super::signals::Signals;
use crate::weather::{Weather, WeatherFile};

/// Where the weather comes from.
pub(crate) enum WeatherSource {
    /// A file, linear between its rows.
    File(WeatherFile),
    /// The inputs as they are.
    Inputs,
}

impl WeatherSource {
    /// The file of this name, or the inputs if the name is empty.
    pub(crate) fn open(file: &str) -> Result<Self, ModelError> {
        if file.is_empty() {
            return Ok(Self::Inputs);
        }
        WeatherFile::open(Path::new(file)).map(Self::File).map_err(ModelError::from_error)
    }

    /// The weather at a time in s.
    pub(crate) fn at(
        &self,
        time: f64,
        signals: &Signals,
        values: &Values,
    ) -> Result<Weather, ModelError> {
        match self {
            Self::File(file) => file.at(time).map_err(ModelError::from_error),
            Self::Inputs => Ok(WeatherInputs::read(&signals.weather, values).into()),
        }
    }

    /// Whether it says where the sun stands.
    pub(crate) fn has_sun(&self) -> bool {
        match self {
            Self::File(file) => file.has_sun(),
            Self::Inputs => true,
        }
    }

    /// Refuses a time that a file does not cover.
    pub(crate) fn check_until(&self, time: f64) -> Result<(), ModelError> {
        match self {
            Self::File(file) => file.at(time).map(|_| ()).map_err(ModelError::from_error),
            Self::Inputs => Ok(()),
        }
    }
}
