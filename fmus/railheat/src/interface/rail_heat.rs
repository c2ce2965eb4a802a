//! Initialisation and step of the FMU.

use std::borrow::Cow;
use std::path::Path;

use field::FieldError;
use fmu::{Declaration, Identity, Interval, Log, Model, ModelError, Values, Variables};
use numerics::seconds;
use serde::{Deserialize, Serialize};

use super::build::build;
use super::chosen_model::{self, ChosenModel};
use super::field_file::{FieldFile, Written};
use super::inputs::WheelInputs;
use super::parameters::common::FieldFailure;
use super::parameters::site::SiteParameters;
use super::shape::Shape;
use super::signals::Signals;
use super::weather_source::WeatherSource;
use crate::contact::Wheel;
use crate::heat_model::HeatModel;
use crate::line::{Line, Stray};

/// Heat in one rail from the wheels of a train.
pub struct RailHeat {
    model: ChosenModel,
    /// The inputs of the present step.
    wheels: Vec<Wheel>,
    /// The element of each probe.
    probes: Vec<usize>,
    field: Option<FieldFile>,
    weather: WeatherSource,
}

/// What an FMU state saves.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    model: chosen_model::State,
    /// How far the field has been written, if one is wanted.
    field: Option<Written>,
}

impl Model for RailHeat {
    const IDENTITY: Identity = Identity {
        name: "Hotfoot rail heat",
        identifier: "railheat",
        description: "Temperature rise of one rail along the track and over its depth, caused by \
                      the wheels of a train and the weather",
        default_step: 0.001,
    };

    type Signals = Signals;
    type State = State;

    fn declare(resources: &Path, declaration: &mut Declaration) -> Result<Signals, ModelError> {
        let shape = Shape::from_resources(resources).map_err(ModelError::from_error)?;
        Ok(Signals::declare(shape, declaration))
    }

    fn initialize(
        signals: &Signals,
        values: &mut Values,
        resources: &Path,
        start_time: f64,
        log: &mut Log,
    ) -> Result<Self, ModelError> {
        let site = SiteParameters::read(&signals.site, values);
        let weather = WeatherSource::open(&values[signals.common.weather_file], &site)?;
        let model = build(signals, values, resources, &weather, start_time)?;
        let mut rail_heat = Self {
            probes: probe_elements(&signals.shape.probes, model.line())?,
            wheels: vec![Wheel::default(); signals.wheels.len()],
            field: None,
            weather,
            model,
        };
        rail_heat.begin_field(signals, values, start_time, log)?;
        rail_heat.write_outputs(signals, values);
        Ok(rail_heat)
    }

    fn check_until(&self, stop_time: f64) -> Result<(), ModelError> {
        self.weather.check_until(stop_time)
    }

    fn step(
        &mut self,
        signals: &Signals,
        values: &mut Values,
        interval: Interval,
        log: &mut Log,
    ) -> Result<(), ModelError> {
        let handles = signals.wheels.iter().zip(&signals.wheel_names);
        for (wheel, (handles, name)) in self.wheels.iter_mut().zip(handles) {
            *wheel = WheelInputs::read(handles, values).wheel(name)?;
        }
        let Interval { start, length } = interval;
        let weather = self.weather.at(start + 0.5 * length, signals, values)?;
        self.write_field(signals, values, log, |field, model| field.write_start(model))?;
        if let Some(stray) = self.model.step(&self.wheels, &weather, start, length) {
            log.warning(self.warning_of_stray(signals, stray, start + length));
        }
        self.write_field(signals, values, log, |field, model| {
            field.write_if_due(start + length, model)
        })?;
        self.write_outputs(signals, values);
        Ok(())
    }

    fn state(&self) -> Cow<'_, State> {
        let field = self.field.as_ref().map(FieldFile::written);
        Cow::Owned(State { model: self.model.state(), field })
    }

    fn restore(&mut self, state: State) {
        self.model.restore(state.model);
        if let (Some(field), Some(written)) = (&mut self.field, state.field) {
            field.continue_from(written);
        }
    }
}

impl RailHeat {
    fn write_outputs(&self, signals: &Signals, values: &mut Values) {
        signals.outputs.write(&self.model, &self.wheels, &self.probes, values);
    }

    /// Begins the field's file, if one is wanted; what a failure means is the user's choice.
    fn begin_field(
        &mut self,
        signals: &Signals,
        values: &Values,
        start_time: f64,
        log: &mut Log,
    ) -> Result<(), ModelError> {
        let path = &values[signals.common.field_file];
        if path.is_empty() {
            return Ok(());
        }
        let is_right = values[signals.site.rail] > 0.0;
        self.model.keep_sections(&self.probes, is_right);
        let interval = values[signals.common.field_interval];
        let (field, begun) = FieldFile::new(Path::new(path), interval, start_time, &*self.model);
        self.field = Some(field);
        self.write_field(signals, values, log, |_, _| begun)
    }

    /// Writes the field as `write` says; what a failure means is the user's choice.
    fn write_field(
        &mut self,
        signals: &Signals,
        values: &Values,
        log: &mut Log,
        write: impl FnOnce(&mut FieldFile, &dyn HeatModel) -> Result<(), FieldError>,
    ) -> Result<(), ModelError> {
        let Some(field) = &mut self.field else {
            return Ok(());
        };
        let Err(error) = write(field, &*self.model) else {
            return Ok(());
        };
        field.stop();
        field_failed(signals, values, error, log)
    }

    fn warning_of_stray(&self, signals: &Signals, stray: Stray, time: f64) -> String {
        let line = self.model.line();
        format!(
            "{} is at chainage {:.1} m at {} s, outside the modelled track from {} m to {} m; \
             wheels heat nothing there (one warning a run)",
            signals.wheel_names[stray.wheel],
            stray.position,
            seconds(time),
            line.begin,
            line.end()
        )
    }
}

/// The element in which each probe lies.
fn probe_elements(probes: &[f64], line: &Line) -> Result<Vec<usize>, ModelError> {
    let element = |&chainage: &f64| {
        line.element(chainage).ok_or_else(|| {
            ModelError::new(format!(
                "probe at chainage_m = {chainage}: must lie on the modelled track from {} m to {} m",
                line.begin,
                line.end()
            ))
        })
    };
    probes.iter().map(element).collect()
}

/// Stops the run, or says that it continues without the field, as the user has chosen.
fn field_failed(
    signals: &Signals,
    values: &Values,
    error: FieldError,
    log: &mut Log,
) -> Result<(), ModelError> {
    match FieldFailure::read(&signals.common.field_failure, values) {
        FieldFailure::Stop => Err(ModelError::from_error(error)),
        FieldFailure::Continue => {
            log.warning(format!("{error}; the run goes on without writing the field"));
            Ok(())
        }
    }
}
