//! The model that the parameters describe, at its start.

use std::path::Path;

use fmu::{ModelError, Values};

use super::chosen_model::ChosenModel;
use super::parameters::common::ModelChoice;
use super::parameters::other_model::{self, AllParameters};
use super::parameters::{energy, paper};
use super::shape::Shape;
use super::signals::Signals;
use super::weather_source::WeatherSource;
use crate::energy::EnergyModel;
use crate::paper::PaperModel;

/// The model at its start.
pub(crate) fn build(
    signals: &Signals,
    values: &Values,
    resources: &Path,
    source: &WeatherSource,
    start_time: f64,
) -> Result<ChosenModel, ModelError> {
    let parameters = signals.parameters(values);
    other_model::check(&parameters, &signals.parameters(&signals.start))?;
    let AllParameters { common, energy, site } = parameters;
    let Shape { wheelsets, depths, .. } = &signals.shape;
    let weather = source.at(start_time, signals, values)?;
    match common.model {
        ModelChoice::Paper => {
            let constants = paper::constants(&common, &weather, depths)?;
            let model = PaperModel::new(constants, signals.wheels.len(), start_time);
            model.map(|model| ChosenModel::Paper(Box::new(model))).map_err(ModelError::from_error)
        }
        ModelChoice::Energy => {
            if !source.has_sun() {
                return Err(ModelError::new(
                    "weather_file has no columns for the sun: site.date_time must say when it is",
                ));
            }
            let over_time = |time| source.at(time, signals, values);
            let ephemeris = source.ephemeris();
            let line = energy::line(&common)?;
            let site = site.site(line, resources, ephemeris, over_time, start_time)?;
            let constants = energy.constants(&common, site, depths)?;
            let model = EnergyModel::new(constants, wheelsets, &weather, start_time);
            model.map(|model| ChosenModel::Energy(Box::new(model))).map_err(ModelError::from_error)
        }
    }
}
