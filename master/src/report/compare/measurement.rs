//! A measurement: the columns of a CSV file as curves of signals of a run.

use std::collections::BTreeMap;
use std::path::Path;
use std::str::FromStr;

use files::{Document, Mistake, Table as Rows, did_you_mean};

use super::about::About;
use super::error::CompareError;
use super::errors::signal;
use super::measured_unit::{conversion, known, name_and_unit};
use super::run::{Curves, Run};

/// Names that the column of times may have without being named.
const TIMES: [&str; 3] = ["time", "time_s", "t"];

/// How the columns of measurements are signals of a run.
#[derive(Debug, Clone, Default)]
pub struct MeasurementOptions {
    /// Columns whose names are no signals.
    pub mappings: Vec<Mapping>,
    /// Name of the column of times; none: `time`, `time_s` or `t`.
    pub time: Option<String>,
    /// What is added to its times, s.
    pub shift: f64,
}

/// A column and the signal that it measures, as in `V_GPS=vehicles[1].velocity`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mapping {
    column: String,
    signal: String,
}

impl FromStr for Mapping {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('=').map(|(column, signal)| (column.trim(), signal.trim()));
        match parts.filter(|(column, signal)| !column.is_empty() && !signal.is_empty()) {
            Some((column, signal)) => {
                Ok(Self { column: column.to_owned(), signal: signal.to_owned() })
            }
            None => {
                Err("must be a column and its signal, as in V_GPS=vehicles[1].velocity".to_owned())
            }
        }
    }
}

/// A measurement.
pub(super) struct Measurement {
    /// What it is.
    pub about: About,
    /// Columns that found no home, each with why.
    pub without_home: Vec<String>,
    /// Times, s.
    time: Vec<f64>,
    /// Signals that it has, with their values in SI units.
    signals: Vec<(Home, Vec<f64>)>,
}

/// A signal of a run.
#[derive(Debug, Clone, PartialEq)]
struct Home {
    table: String,
    row: String,
    column: String,
    unit: String,
}

impl Measurement {
    /// Reads a file, whose columns are signals of a run.
    pub fn read(
        file: &Path,
        run: &Run,
        options: &MeasurementOptions,
    ) -> Result<Self, CompareError> {
        let document = Document::read(file)?;
        let rows = Rows::new(&document)?;
        let at = time_column(&rows, options)?;
        let mut time = column(&rows, at, "s", "time")?;
        time.iter_mut().for_each(|time| *time += options.shift);
        if let Some(row) = time.windows(2).position(|pair| pair[1] <= pair[0]) {
            return Err(rows.error(row + 1, at, "must be later than the time before it").into());
        }
        let homes = Homes::of(run);
        check_mappings(&rows, &homes, options)?;
        let (mut signals, mut without_home): (Vec<(Home, Vec<f64>)>, _) = (vec![], vec![]);
        for (number, written) in rows.names().enumerate().filter(|(number, _)| *number != at) {
            let (name, _) = name_and_unit(written);
            let mapped = options.mappings.iter().find(|m| m.column == name || m.column == written);
            match homes.find(mapped.map_or(name, |mapping| mapping.signal.as_str())) {
                Some(home) if signals.iter().any(|(other, _)| other == home) => {
                    let signal = signal(&home.table, &home.row, &home.column);
                    let sentence = format!("two columns measure {signal}");
                    return Err(rows.error_in_names(sentence).into());
                }
                Some(home) => {
                    let values = column(&rows, number, &home.unit, name)?;
                    signals.push((home.clone(), values));
                }
                None => without_home.push(format!(
                    "{written}: no signal of {} has this name{}",
                    run.about.name,
                    homes.meant(name)
                )),
            }
        }
        if signals.is_empty() {
            return Err(rows.error_in_names(no_home(&without_home)).into());
        }
        let about = About {
            name: file.display().to_string(),
            command: String::new(),
            begun: String::new(),
            version: String::new(),
            simulated_s: None,
            end: "measured".to_owned(),
        };
        Ok(Self { about, without_home, time, signals })
    }

    /// The curves of a column of a table of the run.
    pub fn curves(&self, table: &str, column: &str) -> Option<Curves> {
        let is_here = |(home, _): &&(Home, Vec<f64>)| home.table == table && home.column == column;
        let rows: Vec<_> = self
            .signals
            .iter()
            .filter(is_here)
            .map(|(home, values)| (home.row.clone(), values.clone()))
            .collect();
        (!rows.is_empty()).then(|| Curves { time: self.time.clone(), rows })
    }
}

/// The sentence of a file of which no column is a signal.
fn no_home(without_home: &[String]) -> String {
    format!(
        "no column is a signal; name one as TABLE.COLUMN or TABLE[ROW].COLUMN, such as vehicles[1].velocity, or say by \
         --map which signal it measures: {}",
        without_home.join("; ")
    )
}

/// The number of the column of times.
fn time_column(rows: &Rows<'_>, options: &MeasurementOptions) -> Result<usize, Mistake> {
    let is_time = |written: &str| match &options.time {
        Some(wanted) => written == wanted || name_and_unit(written).0 == wanted,
        None => TIMES.contains(&name_and_unit(written).0),
    };
    rows.names().position(is_time).ok_or_else(|| {
        let wanted = options.time.as_deref().map_or_else(
            || {
                "there is no column time, time_s or t; name the column of times by --time"
                    .to_owned()
            },
            |wanted| format!("there is no column {wanted}{}", did_you_mean(wanted, rows.names())),
        );
        rows.error_in_names(wanted)
    })
}

/// The values of a column in an SI unit; where the file has none, not-a-number.
fn column(rows: &Rows<'_>, number: usize, unit: &str, name: &str) -> Result<Vec<f64>, Mistake> {
    let written = rows.names().nth(number).unwrap_or_default();
    let (_, measured) = name_and_unit(written);
    let Some((factor, offset)) = conversion(measured, unit) else {
        let measured = measured.unwrap_or_default();
        return Err(rows.error_in_names(format!(
            "{name} is in {measured}, but its signal in {unit}; its unit can be {}",
            known(unit)
        )));
    };
    let value = |row| match rows.text(row, number).is_empty() {
        true => Ok(f64::NAN),
        false => Ok(factor * rows.number(row, number)? + offset),
    };
    (0..rows.len()).map(value).collect()
}

/// Refuses a mapping of a column or to a signal that is not there.
fn check_mappings(
    rows: &Rows<'_>,
    homes: &Homes,
    options: &MeasurementOptions,
) -> Result<(), Mistake> {
    for Mapping { column, signal } in &options.mappings {
        let is_there = rows.names().any(|own| own == column || name_and_unit(own).0 == column);
        if !is_there {
            let meant = did_you_mean(column, rows.names().map(|own| name_and_unit(own).0));
            let sentence = format!("--map {column}={signal}: there is no column {column}{meant}");
            return Err(rows.error_in_names(sentence));
        }
        if homes.find(signal).is_none() {
            let meant = homes.meant(signal);
            let sentence =
                format!("--map {column}={signal}: the run has no signal {signal}{meant}");
            return Err(rows.error_in_names(sentence));
        }
    }
    Ok(())
}

/// The signals of a run by their names.
struct Homes {
    by_signal: BTreeMap<String, Home>,
}

impl Homes {
    fn of(run: &Run) -> Self {
        let mut by_signal = BTreeMap::new();
        for table in &run.tables {
            for (column, unit) in table.columns() {
                for row in table.rows() {
                    let home = Home {
                        table: table.name.clone(),
                        row: row.clone(),
                        column: column.clone(),
                        unit: unit.clone(),
                    };
                    by_signal.insert(signal(&table.name, row, &column), home);
                }
            }
        }
        Self { by_signal }
    }

    /// The signal of that name; a column's name is enough where only one signal has it.
    fn find(&self, name: &str) -> Option<&Home> {
        let mut of_column = self.by_signal.values().filter(|home| home.column == name);
        self.by_signal.get(name).or_else(|| of_column.next().filter(|_| of_column.next().is_none()))
    }

    fn meant(&self, name: &str) -> String {
        did_you_mean(name, self.by_signal.keys().map(String::as_str))
    }
}
