//! A driver who repeats what a locomotive's logger has recorded.
//!
//! ```toml
//! [replay]
//! file = "logger.csv"          # beside the driver file, or with its whole path
//! time = "Time (s)"            # names of the columns; the times must rise
//! speed = "GPS speed"          # measured speed, compared with the simulated one
//! speed_unit = "km/h"          # or "m/s", "mph"
//! throttle = "Notch"           # any of throttle, dynamic_brake, train_brake, locomotive_brake
//! throttle_full = 8.0          # value of the column for the whole of it; likewise for the others
//! resample = "hold"            # or "linear"
//! longest_gap_s = 10.0
//! ```
//!
//! The first time in the file is the start of the run. Before and after the file its first and last
//! row hold.

use std::path::Path;

use files::{Check, Document, Mistake, Table, did_you_mean};
use numerics::LinearTable;
use numerics::constants::{KILOMETRES_PER_HOUR, MILES_PER_HOUR};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::command::{Command, EMERGENCY, HIGHEST_NOTCH};

/// The columns of a logger's file, by the keys of `[replay]` that say what they are called.
pub const LOGGER_COLUMNS: [files::Column; 6] = [
    logged("time", "s", true, "Time, which must rise; its name is replay.time"),
    logged("speed", "km/h", true, "Measured speed; replay.speed, in the unit of replay.speed_unit"),
    logged(
        "throttle",
        "1",
        false,
        "Throttle or notch; replay.throttle, in parts of replay.throttle_full",
    ),
    logged(
        "dynamic_brake",
        "1",
        false,
        "Dynamic brake; replay.dynamic_brake, in parts of replay.dynamic_brake_full",
    ),
    logged(
        "train_brake",
        "1",
        false,
        "Train brake; replay.train_brake, in parts of replay.train_brake_full",
    ),
    logged(
        "locomotive_brake",
        "1",
        false,
        "Locomotive brake; replay.locomotive_brake, in parts of replay.locomotive_brake_full",
    ),
];

const fn logged(
    name: &'static str,
    unit: &'static str,
    required: bool,
    description: &'static str,
) -> files::Column {
    files::Column { name, unit, required, bounds: None, description }
}

/// Recorded commands and speed.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Replay {
    /// Times from the start of the record, s.
    times: Vec<f64>,
    /// Measured speed, m/s.
    speed: LinearTable,
    throttle: Column,
    dynamic_brake: Column,
    train_brake: Column,
    locomotive_brake: Column,
}

/// A lever over the time.
#[derive(Clone, Debug, PartialEq)]
enum Column {
    /// Each value holds until the next one.
    Hold(Vec<f64>),
    Linear(LinearTable),
    /// Not recorded.
    Zero,
}

/// Section `[replay]`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ReplayFile {
    /// CSV file of the logger, beside the driver file or with its whole path.
    pub(super) file: String,
    /// Name of the column of times, which must rise.
    time: String,
    /// Name of the column of the measured speed.
    speed: String,
    /// Unit of that column.
    #[serde(default)]
    speed_unit: SpeedUnit,
    /// Name of the column of the throttle.
    throttle: Option<String>,
    /// Value of that column for the whole of it.
    #[serde(default = "highest_notch")]
    throttle_full: f64,
    /// Name of the column of the dynamic brake.
    dynamic_brake: Option<String>,
    /// Value of that column for the whole of it.
    #[serde(default = "one")]
    dynamic_brake_full: f64,
    /// Name of the column of the train brake.
    train_brake: Option<String>,
    /// Value of that column for the whole of it.
    #[serde(default = "one")]
    train_brake_full: f64,
    /// Name of the column of the locomotive brake.
    locomotive_brake: Option<String>,
    /// Value of that column for the whole of it.
    #[serde(default = "one")]
    locomotive_brake_full: f64,
    /// Whether a value holds until the next one, or goes linearly.
    #[serde(default)]
    resample: Resample,
    /// Longest time between two rows, s.
    #[serde(default = "ten")]
    longest_gap_s: f64,
}

#[derive(Clone, Copy, Default, Deserialize, JsonSchema)]
enum SpeedUnit {
    #[default]
    #[serde(rename = "km/h")]
    Kmh,
    #[serde(rename = "m/s")]
    MetrePerSecond,
    #[serde(rename = "mph")]
    Mph,
}

#[derive(Clone, Copy, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum Resample {
    #[default]
    Hold,
    Linear,
}

fn one() -> f64 {
    1.0
}

fn ten() -> f64 {
    10.0
}

fn highest_notch() -> f64 {
    HIGHEST_NOTCH
}

impl ReplayFile {
    pub(super) fn compile(&self, check: &Check, file: &Path) -> Result<Replay, Mistake> {
        if let Err(missing) = files::exists(file) {
            return Err(check.error("file", &self.file, missing.sentence));
        }
        let document = Document::read(file)?;
        let log = Table::new(&document)?;
        let column = |key: &str, name: &str| match log.column(name) {
            Some(column) => Ok(column),
            None => {
                let meant = did_you_mean(name, log.names());
                let names = log.names().collect::<Vec<_>>().join(", ");
                let file = document.name();
                let wanted = format!("{file} has no column of this name, but {names}{meant}");
                Err(check.error(key, name, wanted))
            }
        };
        let numbers = |column: usize| {
            (0..log.len()).map(|row| log.number(row, column)).collect::<Result<Vec<f64>, _>>()
        };
        let time = column("time", &self.time)?;
        let mut times = seconds(&log, time)?;
        let start = times[0];
        times.iter_mut().for_each(|time| *time -= start);
        self.check_times(&times, &log, time)?;

        let unit = match self.speed_unit {
            SpeedUnit::Kmh => KILOMETRES_PER_HOUR,
            SpeedUnit::MetrePerSecond => 1.0,
            SpeedUnit::Mph => MILES_PER_HOUR,
        };
        let linear = |values: Vec<f64>| {
            LinearTable::new(times.clone(), values)
                .map_err(|error| log.error(0, time, error.to_string()))
        };
        let lever = |key: &str, name: &Option<String>, full: f64, most: f64| {
            check.positive(&format!("{key}_full"), full)?;
            let Some(name) = name else { return Ok(Column::Zero) };
            let column = column(key, name)?;
            let values: Vec<f64> = numbers(column)?.into_iter().map(|value| value / full).collect();
            if let Some(i) = values.iter().position(|value| !(0.0..=most).contains(value)) {
                return Err(log.error(i, column, outside(key, full, most, times[i] + start)));
            }
            match self.resample {
                Resample::Hold => Ok(Column::Hold(values)),
                Resample::Linear => linear(values).map(Column::Linear),
            }
        };
        let speed = numbers(column("speed", &self.speed)?)?;
        Ok(Replay {
            speed: linear(speed.iter().map(|v| v / unit).collect())?,
            throttle: lever("throttle", &self.throttle, self.throttle_full, 1.0)?,
            dynamic_brake: lever(
                "dynamic_brake",
                &self.dynamic_brake,
                self.dynamic_brake_full,
                1.0,
            )?,
            train_brake: lever("train_brake", &self.train_brake, self.train_brake_full, EMERGENCY)?,
            locomotive_brake: lever(
                "locomotive_brake",
                &self.locomotive_brake,
                self.locomotive_brake_full,
                1.0,
            )?,
            times,
        })
    }

    /// The times must rise, without gaps.
    fn check_times(&self, times: &[f64], log: &Table, column: usize) -> Result<(), Mistake> {
        for i in 1..times.len() {
            let gap = times[i] - times[i - 1];
            if gap <= 0.0 {
                let wrong = if gap < 0.0 { "goes back" } else { "is equal" };
                let wanted = format!("{wrong}: must be later than the time in the row before it");
                return Err(log.error(i, column, wanted));
            }
            if gap > self.longest_gap_s {
                let wanted = format!(
                    "a gap of {} s before this row is longer than longest_gap_s = {} s of the driver's file",
                    numerics::seconds(gap),
                    self.longest_gap_s
                );
                return Err(log.error(i, column, wanted));
            }
        }
        Ok(())
    }
}

/// The times in a column, s.
fn seconds(log: &Table, column: usize) -> Result<Vec<f64>, Mistake> {
    let clock = |row: usize| {
        log.text(row, column)
            .contains(':')
            .then(|| log.error(row, column, "must be a number of seconds, not a time of day"))
    };
    let second = |row| log.number(row, column).map_err(|mistake| clock(row).unwrap_or(mistake));
    (0..log.len()).map(second).collect()
}

/// What is right for a lever's column at a time in the file, s.
fn outside(lever: &str, full: f64, most: f64, time: f64) -> String {
    let pressure = match lever.ends_with("_brake") {
        true => "; a pressure is no command: the column must rise with the application",
        false => "",
    };
    format!(
        "must lie between 0 and {} (at {time} s), as replay.{lever}_full = {full} is the whole of it{pressure}",
        most * full
    )
}

impl Replay {
    /// Time from the first row to the last one, s.
    pub(super) fn length(&self) -> f64 {
        self.times.last().copied().unwrap_or_default()
    }

    /// Whether the throttle is opened at some time.
    pub(super) fn pulls(&self) -> bool {
        match &self.throttle {
            Column::Zero => false,
            Column::Hold(values) => values.iter().any(|value| *value > 0.0),
            Column::Linear(table) => table.y().iter().any(|value| *value > 0.0),
        }
    }

    /// The measured speed at a time, m/s.
    pub(super) fn speed(&self, time: f64) -> f64 {
        self.speed.value(time, &mut 0)
    }

    /// The command that was recorded for a time, s.
    pub(super) fn command(&self, time: f64) -> Command {
        let row = self.times.partition_point(|begin| *begin <= time).saturating_sub(1);
        let at = |column: &Column| match column {
            Column::Zero => 0.0,
            Column::Hold(values) => values[row],
            Column::Linear(table) => table.value(time, &mut 0),
        };
        Command {
            notch: at(&self.throttle) * HIGHEST_NOTCH,
            dynamic_brake: at(&self.dynamic_brake),
            train_brake: at(&self.train_brake),
            locomotive_brake: at(&self.locomotive_brake),
        }
    }
}
