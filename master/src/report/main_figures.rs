//! The table of main figures.

use super::ReportError;
use super::collect::Results;
use super::data::MainFigure;
use super::facts::RunFacts;
use super::quantity::{seconds, with_unit};
use crate::recording::{KeyValue, RecordingError, SeriesReader};

/// The extremes of the vehicles that are worth a line: name, column, unit, and which extreme.
const EXTREMES: [(&str, &str, &str, Extreme); 6] = [
    ("Largest coupler tension", "coupler_rear_force", "N", Extreme::Highest),
    ("Largest coupler compression", "coupler_rear_force", "N", Extreme::Lowest),
    ("Largest longitudinal creep force of a vehicle", "creep_force", "N", Extreme::Farthest),
    ("Largest friction power of a vehicle", "friction_power", "W", Extreme::Highest),
    ("Largest synchronisation force", "sync_force", "N", Extreme::Farthest),
    ("Largest position error", "position_error", "m", Extreme::Farthest),
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
pub(super) fn of_run(results: &Results) -> Result<Vec<MainFigure>, ReportError> {
    let mut figures = motion(&results.vehicles)?;
    // Alone, a train has couplers only.
    let extremes = if results.facts.train_alone { &EXTREMES[..2] } else { &EXTREMES[..] };
    for &(name, column, unit, extreme) in extremes {
        figures.extend(of_vehicles(&results.vehicles, name, column, unit, extreme)?);
    }
    figures.extend(of_rail(&results.train)?);
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
    Ok(vec![
        MainFigure {
            name: "Distance run".to_owned(),
            value: format!("{:.1} m", position.1 - position.0),
            place: format!("in {} s", seconds(time.1 - time.0)),
        },
        MainFigure {
            name: "Speed at start and end".to_owned(),
            value: format!("{:.2} and {:.2} m/s", velocity.0, velocity.1),
            place: format!("change {:+.2} m/s", velocity.1 - velocity.0),
        },
    ])
}

/// An extreme over all vehicles and times; nothing if no value was ever finite.
fn of_vehicles(
    vehicles: &SeriesReader,
    name: &str,
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
    let time = seconds(vehicles.read("time", &[])?[row]);
    let place = match column {
        "coupler_rear_force" => format!("rear coupler of vehicle {vehicle} at {time} s"),
        _ => format!("vehicle {vehicle} at {time} s"),
    };
    Ok(Some(MainFigure { name: name.to_owned(), value: with_unit(values[row], unit), place }))
}

/// The highest of each rise that the rail gives as its highest along the track
/// (`rail.highest.….rise` with its `.chainage`).
fn of_rail(train: &SeriesReader) -> Result<Vec<MainFigure>, RecordingError> {
    let mut figures = vec![];
    for column in train.columns() {
        let name = column.name();
        let Some(what) = name.strip_suffix(".rise") else { continue };
        if !what.starts_with("rail.highest.") {
            continue;
        }
        let rise = train.read(name, &[])?;
        let Some(record) = largest(&rise) else { continue };
        let time = seconds(train.read("time", &[])?[record]);
        let place = match train.read(&format!("{what}.chainage"), &[]) {
            Ok(chainage) => format!("chainage {:.1} m at {time} s", chainage[record]),
            Err(_) => format!("at {time} s"),
        };
        figures.push(MainFigure {
            name: column.metadata().get("description").unwrap_or(name).to_owned(),
            value: with_unit(rise[record], "K"),
            place,
        });
    }
    Ok(figures)
}

/// How long the run took, if it has finished.
fn speed_of_run(
    facts: &RunFacts,
    train: &SeriesReader,
) -> Result<Option<MainFigure>, RecordingError> {
    let Some(wall_time) = facts.wall_time_s else { return Ok(None) };
    let time = train.read("time", &[])?;
    let simulated = time.last().copied().unwrap_or(0.0) - time.first().copied().unwrap_or(0.0);
    Ok(Some(MainFigure {
        name: "Wall time".to_owned(),
        value: format!("{wall_time:.1} s"),
        place: format!(
            "{:.2} times real time; {} vehicles, {} threads, step {}",
            simulated / wall_time,
            facts.vehicles,
            facts.threads,
            with_unit(facts.step_s, "s"),
        ),
    }))
}

/// The first place of the value that is farthest from zero.
fn largest(values: &[f64]) -> Option<usize> {
    let mut best: Option<usize> = None;
    for (row, value) in values.iter().enumerate().filter(|(_, value)| value.is_finite()) {
        if best.is_none_or(|best| value.abs() > values[best].abs()) {
            best = Some(row);
        }
    }
    best
}
