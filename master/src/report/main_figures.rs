//! The table of main figures.

use numerics::constants::KILOMETRES_PER_HOUR;
use numerics::seconds;

use super::data::MainFigure;
use super::error::ReportError;
use super::facts::RunFacts;
use super::instrument::Residual;
use super::output_figures;
use super::quantity::with_unit;
use super::results::Results;
use crate::recording::{KeyValue, RecordingError, SeriesReader};

/// The extremes of the vehicles that are worth a line: key, name, column, unit, and which extreme.
const EXTREMES: [(&str, &str, &str, &str, Extreme); 6] = [
    ("coupler.tension", "Largest coupler tension", "coupler_rear_force", "N", Extreme::Highest),
    (
        "coupler.compression",
        "Largest coupler compression",
        "coupler_rear_force",
        "N",
        Extreme::Lowest,
    ),
    (
        "creep_force",
        "Largest longitudinal creep force of a vehicle",
        "creep_force",
        "N",
        Extreme::Farthest,
    ),
    (
        "friction_power",
        "Largest friction power of a vehicle",
        "friction_power",
        "W",
        Extreme::Highest,
    ),
    (
        "synchronisation.force",
        "Largest synchronisation force",
        "sync_force",
        "N",
        Extreme::Farthest,
    ),
    ("synchronisation.error", "Largest position error", "position_error", "m", Extreme::Farthest),
];

/// Which value of a column is wanted.
#[derive(Debug, Clone, Copy)]
enum Extreme {
    /// The highest, at least zero.
    Highest,
    /// The lowest, at most zero; shown without its sign.
    Lowest,
    /// The one farthest from zero.
    Farthest,
}

/// The lines of the table.
pub(super) fn of_run(
    results: &Results,
    residual: Option<&Residual>,
) -> Result<Vec<MainFigure>, ReportError> {
    let mut figures = motion(&results.vehicles)?;
    // Alone, a train has couplers only.
    let extremes = if results.facts.train_alone { &EXTREMES[..2] } else { &EXTREMES[..] };
    for &(key, name, column, unit, extreme) in extremes {
        figures.extend(of_vehicles(&results.vehicles, (key, name), column, unit, extreme)?);
    }
    figures.extend(residual.map(coupling).into_iter().flatten());
    if let Some(outputs) = &results.outputs {
        figures.extend(output_figures::of_run(&results.facts.outputs, outputs)?);
    }
    figures.extend(speed_of_run(&results.facts, &results.train)?);
    Ok(figures)
}

/// Distance and speed of the leading vehicle.
fn motion(vehicles: &SeriesReader) -> Result<Vec<MainFigure>, RecordingError> {
    let ends = |column: &str| {
        let values = vehicles.read(column, &[("vehicle", KeyValue::Integer(1))])?;
        let end = |value: Option<&f64>| value.copied().unwrap_or(f64::NAN);
        Ok::<_, RecordingError>((end(values.first()), end(values.last())))
    };
    let (time, position, velocity) = (ends("time")?, ends("position")?, ends("velocity")?);
    let distance = MainFigure::new("distance", "Distance run", position.1 - position.0, "m");
    let speed = |key: &str, name: &str, value: f64| MainFigure {
        text: format!("{value:.2} m/s ({:.1} km/h)", value * KILOMETRES_PER_HOUR),
        ..MainFigure::new(key, name, value, "m/s")
    };
    Ok(vec![
        MainFigure { text: format!("{:.1} m", position.1 - position.0), ..distance }
            .at(format!("in {} s", seconds(time.1 - time.0))),
        speed("speed.start", "Speed at the start", velocity.0),
        speed("speed.end", "Speed at the end", velocity.1)
            .at(format!("change {:+.2} m/s", velocity.1 - velocity.0)),
    ])
}

/// What is lost or made where train and vehicles are coupled.
fn coupling(residual: &Residual) -> [MainFigure; 2] {
    let power = MainFigure::new(
        "coupling.residual.power",
        "Largest residual power of a coupling",
        residual.power,
        "W",
    );
    let location = format!("vehicle {} at {} s", residual.vehicle, seconds(residual.time));
    let energy = MainFigure::new(
        "coupling.residual.energy",
        "Residual energy of all couplings",
        residual.energy,
        "J",
    );
    [MainFigure { time_s: Some(residual.time), ..power.at(location) }, energy]
}

/// An extreme over all vehicles and times; `None` if no value is finite.
fn of_vehicles(
    vehicles: &SeriesReader,
    (key, name): (&str, &str),
    column: &str,
    unit: &str,
    extreme: Extreme,
) -> Result<Option<MainFigure>, RecordingError> {
    let lowest = || vehicles.read(&format!("{column}_min"), &[]);
    let highest = || vehicles.read(&format!("{column}_max"), &[]);
    let values: Vec<f64> = match extreme {
        Extreme::Highest => highest()?.into_iter().map(|value| value.max(0.0)).collect(),
        Extreme::Lowest => lowest()?.into_iter().map(|value| (-value).max(0.0)).collect(),
        Extreme::Farthest => {
            let pairs = lowest()?.into_iter().zip(highest()?);
            pairs.map(|(low, high)| if -low > high { low } else { high }).collect()
        }
    };
    let Some(row) = largest(&values) else { return Ok(None) };
    let vehicle = vehicles.read("vehicle", &[])?[row];
    let time = vehicles.read("time", &[])?[row];
    let location = match column {
        "coupler_rear_force" => "rear coupler of vehicle",
        _ => "vehicle",
    };
    let figure = MainFigure::new(key, name, values[row], unit);
    let figure = figure.at(format!("{location} {vehicle} at {} s", seconds(time)));
    Ok(Some(MainFigure { time_s: Some(time), ..figure }))
}

/// How long the run took, if it has finished.
fn speed_of_run(
    facts: &RunFacts,
    train: &SeriesReader,
) -> Result<Option<MainFigure>, RecordingError> {
    let Some(wall_time) = facts.wall_time_s else { return Ok(None) };
    let time = train.read("time", &[])?;
    let simulated = time.last().copied().unwrap_or(0.0) - time.first().copied().unwrap_or(0.0);
    let location = format!(
        "{:.2} times real time; {} vehicles, {} threads, step {}",
        simulated / wall_time,
        facts.vehicles,
        facts.threads,
        with_unit(facts.step_s, "s"),
    );
    let figure = MainFigure::new("wall_time", "Wall time", wall_time, "s");
    Ok(Some(MainFigure { text: format!("{wall_time:.1} s"), ..figure }.at(location)))
}

/// The first index of the value that is farthest from zero.
pub(super) fn largest(values: &[f64]) -> Option<usize> {
    let mut best: Option<usize> = None;
    for (row, value) in values.iter().enumerate().filter(|(_, value)| value.is_finite()) {
        if best.is_none_or(|best| value.abs() > values[best].abs()) {
            best = Some(row);
        }
    }
    best
}
