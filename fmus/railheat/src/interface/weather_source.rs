//! The weather over time: of a file, or of the inputs.

use std::path::Path;

use fmu::{ModelError, Values, Variables};

use super::inputs::WeatherInputs;
use super::parameters::site::SiteParameters;
use super::signals::Signals;
use crate::weather::{Ephemeris, Weather, WeatherFile};

/// Where the weather comes from.
pub(crate) struct WeatherSource {
    /// The file, or the inputs as they are.
    file: Option<WeatherFile>,
    /// When and where it is, if the parameters say so.
    ephemeris: Option<Ephemeris>,
}

impl WeatherSource {
    /// The file of this name, or the inputs if the name is empty.
    pub(crate) fn open(file: &str, site: &SiteParameters) -> Result<Self, ModelError> {
        let file = match file.is_empty() {
            true => None,
            false => Some(WeatherFile::open(Path::new(file)).map_err(ModelError::from_error)?),
        };
        let ephemeris = site.ephemeris(file.as_ref().and_then(WeatherFile::site))?;
        Ok(Self { file, ephemeris })
    }

    /// The weather at a time in s.
    pub(crate) fn at(
        &self,
        time: f64,
        signals: &Signals,
        values: &Values,
    ) -> Result<Weather, ModelError> {
        match &self.file {
            Some(file) => file.at(time, self.ephemeris.as_ref()).map_err(ModelError::from_error),
            None => Ok(WeatherInputs::read(&signals.weather, values).into()),
        }
    }

    /// When and where it is, if the parameters say so.
    pub(crate) fn ephemeris(&self) -> Option<Ephemeris> {
        self.ephemeris
    }

    /// Whether it is known where the sun stands.
    pub(crate) fn has_sun(&self) -> bool {
        self.ephemeris.is_some() || self.file.as_ref().is_none_or(WeatherFile::has_sun)
    }

    /// Refuses a time that a file does not cover.
    pub(crate) fn check_until(&self, time: f64) -> Result<(), ModelError> {
        match &self.file {
            Some(file) => {
                file.at(time, self.ephemeris.as_ref()).map(|_| ()).map_err(ModelError::from_error)
            }
            None => Ok(()),
        }
    }
}
