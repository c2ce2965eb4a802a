//! The model as an FMU.

use std::borrow::Cow;
use std::path::Path;

use field::FieldError;
use fmu::{Declaration, Identity, Interval, Log, Model, ModelError, Values};

use super::chosen_model::{ChosenModel, State};
use super::field_file::FieldFile;
use super::parameters_energy::{self, Site};
use super::shape::Shape;
use super::signals::Signals;
use super::{checks, parameters_site};
use crate::contact::Wheel;
use crate::energy::EnergyModel;
use crate::heat_model::HeatModel;
use crate::line::Stray;
use crate::paper::PaperModel;
use crate::weather::{Weather, WeatherFile};

/// Heat in one rail from the wheels of a train.
pub struct RailHeat {
    model: ChosenModel,
    /// The inputs of the present step.
    wheels: Vec<Wheel>,
    /// The element of each probe.
    probes: Vec<usize>,
    field: Option<FieldFile>,
    weather: Option<WeatherFile>,
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
        let file = open_weather(signals, values)?;
        let weather = weather_at(file.as_ref(), signals, values, start_time)?;
        let at = Beginning { file: file.as_ref(), resources, weather: &weather, time: start_time };
        let model = build(signals, values, &at)?;
        let wheels = vec![Wheel::default(); signals.wheels.len()];
        let rail_heat = Self {
            probes: checks::probe_elements(&signals.shape.probes, model.line())?,
            field: begin_field(signals, values, start_time, &*model, log)?,
            weather: file,
            wheels,
            model,
        };
        rail_heat.write_outputs(signals, values);
        Ok(rail_heat)
    }

    fn foresee(&self, stop_time: f64) -> Result<(), ModelError> {
        let at_the_end = self.weather.as_ref().map(|file| file.at(stop_time)).transpose();
        at_the_end.map(|_| ()).map_err(ModelError::from_error)
    }

    fn step(
        &mut self,
        signals: &Signals,
        values: &mut Values,
        interval: Interval,
        log: &mut Log,
    ) -> Result<(), ModelError> {
        for (wheel, inputs) in self.wheels.iter_mut().zip(&signals.wheels) {
            *wheel = inputs.read(values);
            checks::wheel(wheel, &inputs.name)?;
        }
        let Interval { start, length } = interval;
        let weather = weather_at(self.weather.as_ref(), signals, values, start + 0.5 * length)?;
        if let Some(stray) = self.model.step(&self.wheels, &weather, start, length) {
            log.warning(self.sentence(signals, stray, start + length));
        }
        self.write_field(signals, values, start + length, log)?;
        self.write_outputs(signals, values);
        Ok(())
    }

    fn state(&self) -> Cow<'_, State> {
        Cow::Owned(self.model.state())
    }

    fn restore(&mut self, state: State) {
        self.model.restore(state);
    }
}

impl RailHeat {
    fn write_outputs(&self, signals: &Signals, values: &mut Values) {
        let outputs = &signals.outputs;
        for (handles, highest) in outputs.highest.iter().zip(self.model.highest()) {
            values[handles.rise] = highest.rise;
            values[handles.chainage] = highest.chainage;
        }
        for (handles, &element) in outputs.probes.iter().zip(&self.probes) {
            for (level, handle) in handles.rises.iter().enumerate() {
                values[*handle] = self.model.rise(element, level);
            }
            values[handles.heat] = self.model.heat_per_metre(element);
        }
        values[outputs.highest_flash] = self.model.highest_flash();
        values[outputs.untouched] = self.model.untouched_surface();
        match &self.model {
            ChosenModel::Paper(model) => {
                let audit = model.audit();
                values[outputs.stored] = audit.stored;
                values[outputs.imposed] = audit.imposed;
                values[outputs.weather] = audit.weather;
            }
            ChosenModel::Energy(model) => {
                outputs.energy.write(model, &self.wheels, &self.probes, values);
                values[outputs.stored] = model.ledger().stored;
                values[outputs.weather] = model.ledger().sources.weather;
            }
        }
    }

    /// Writes the field if it is time; what a failure means is the user's choice.
    fn write_field(
        &mut self,
        signals: &Signals,
        values: &Values,
        time: f64,
        log: &mut Log,
    ) -> Result<(), ModelError> {
        let Some(field) = &mut self.field else {
            return Ok(());
        };
        let Err(error) = field.write_if_due(time, &*self.model) else {
            return Ok(());
        };
        self.field = None;
        field_failed(signals, values, error, log)
    }

    fn sentence(&self, signals: &Signals, stray: Stray, time: f64) -> String {
        let line = self.model.line();
        format!(
            "{} is at chainage {:.1} m at {time:.3} s, outside the modelled track from {} m to {} m; \
             wheels heat nothing there (told once)",
            signals.wheels[stray.wheel].name,
            stray.position,
            line.begin,
            line.end()
        )
    }
}

/// Where and when the model begins.
struct Beginning<'b> {
    file: Option<&'b WeatherFile>,
    resources: &'b Path,
    weather: &'b Weather,
    time: f64,
}

/// The model that the parameters choose, at its start.
fn build(
    signals: &Signals,
    values: &Values,
    at: &Beginning<'_>,
) -> Result<ChosenModel, ModelError> {
    let Shape { wheelsets, depths, .. } = &signals.shape;
    match values[signals.parameters.model].as_str() {
        "paper" => {
            let parameters = signals.parameters.read(values, at.weather, depths)?;
            let paper = PaperModel::new(parameters, signals.wheels.len(), at.time);
            paper.map(|paper| ChosenModel::Paper(Box::new(paper))).map_err(ModelError::from_error)
        }
        "energy" => {
            let site = site(signals, values, at)?;
            let parameters =
                signals.parameters_energy.read(&signals.parameters, site, values, depths)?;
            let energy = EnergyModel::new(parameters, wheelsets, at.weather, at.time);
            energy
                .map(|energy| ChosenModel::Energy(Box::new(energy)))
                .map_err(ModelError::from_error)
        }
        other => {
            let sentence = format!("model = \"{other}\": must be \"paper\" or \"energy\"");
            Err(ModelError::new(sentence))
        }
    }
}

/// Where the track runs, where the sun stands and what day it is.
fn site(signals: &Signals, values: &Values, at: &Beginning<'_>) -> Result<Site, ModelError> {
    let site = &signals.site;
    let line = parameters_energy::line(&signals.parameters, values)?;
    let ephemeris = site.ephemeris(values)?;
    if ephemeris.is_none() && at.file.is_some_and(|file| !file.has_sun()) {
        return Err(ModelError::new(
            "weather_file has no columns for the sun: site.date_time must say when it is",
        ));
    }
    let weather = |time: f64| weather_at(at.file, signals, values, time);
    let day = match values[site.day] {
        true => Some(parameters_site::day(weather, ephemeris.as_ref(), at.time)?),
        false => None,
    };
    Ok(Site {
        azimuth: site.azimuth(values, at.resources, &line)?,
        shade: site.body(values)?,
        ephemeris,
        day,
        line,
    })
}

/// The weather file, if there is one.
fn open_weather(signals: &Signals, values: &Values) -> Result<Option<WeatherFile>, ModelError> {
    let path = &values[signals.parameters.weather_file];
    if path.is_empty() {
        return Ok(None);
    }
    WeatherFile::open(Path::new(path)).map(Some).map_err(ModelError::from_error)
}

/// The weather of the file at a time, or of the inputs.
fn weather_at(
    file: Option<&WeatherFile>,
    signals: &Signals,
    values: &Values,
    time: f64,
) -> Result<Weather, ModelError> {
    if let Some(file) = file {
        return file.at(time).map_err(ModelError::from_error);
    }
    let weather = signals.weather.read(values);
    checks::weather(&weather)?;
    Ok(weather)
}

/// Begins the field's file, if one is wanted; what a failure means is the user's choice.
fn begin_field(
    signals: &Signals,
    values: &Values,
    start_time: f64,
    model: &dyn HeatModel,
    log: &mut Log,
) -> Result<Option<FieldFile>, ModelError> {
    let path = &values[signals.parameters.field_file];
    if path.is_empty() {
        return Ok(None);
    }
    let failure = &values[signals.parameters.field_failure];
    if failure != "stop" && failure != "go_on" {
        let sentence = format!("field_failure = \"{failure}\": must be \"stop\" or \"go_on\"");
        return Err(ModelError::new(sentence));
    }
    let interval = values[signals.parameters.field_interval];
    if !(interval > 0.0 && interval.is_finite()) {
        let sentence = format!("field_interval = {interval}: must be greater than zero");
        return Err(ModelError::new(sentence));
    }
    match FieldFile::create(Path::new(path), interval, start_time, model) {
        Ok(field) => Ok(Some(field)),
        Err(error) => field_failed(signals, values, error, log).map(|()| None),
    }
}

/// Stops the run, or says that it goes on without the field, as the user has chosen.
fn field_failed(
    signals: &Signals,
    values: &Values,
    error: FieldError,
    log: &mut Log,
) -> Result<(), ModelError> {
    if values[signals.parameters.field_failure] != "go_on" {
        return Err(ModelError::from_error(error));
    }
    log.warning(format!("{error}; the run goes on without writing the field"));
    Ok(())
}
