//! Further outputs of the recorded vehicles: those that the scenario names.

use std::path::Path;

use super::observe_error::{ObserveError, OutputsError};
use super::recorder::Table;
use crate::interface::name_pattern::matches;
use crate::interface::{Interface, Variable, VariableType};
use crate::recording::{Column, SeriesWriter, vehicle_keys_of};
use crate::system::step::System;
use crate::system::tap::Tap;
use crate::train::layout::VehicleHolder;

/// Records the table `outputs`: a row for each recorded vehicle, a column for each output; outputs
/// that a vehicle lacks are not-a-number there.
pub struct OutputsTable {
    series: SeriesWriter,
    rows: Vec<Vec<Option<Tap>>>,
    values: Vec<f64>,
}

impl OutputsTable {
    /// Begins the table in `folder`, for these vehicles with their numbers from one; none if no output
    /// is wanted.
    ///
    /// # Errors
    /// When a name fits no output, or the folder cannot be written.
    pub fn new(
        patterns: &[String],
        recorded: &[(usize, &VehicleHolder)],
        system: &mut System,
        (folder, per_part): (&Path, usize),
    ) -> Result<Option<Self>, ObserveError> {
        if patterns.is_empty() || recorded.is_empty() {
            return Ok(None);
        }
        let interface = |(number, holder): &(usize, &VehicleHolder)| {
            let part = system.number(&holder.component)?;
            Some((*number, system.parts[part].unit.interface()))
        };
        let interfaces: Vec<_> = recorded.iter().filter_map(interface).collect();
        let columns = columns(patterns, &interfaces)?;
        let mut row = |(_, holder): &(usize, &VehicleHolder)| {
            columns.iter().map(|column| system.tap(&holder.component, column.name())).collect()
        };
        let rows = recorded.iter().map(&mut row).collect();
        let keys = vehicle_keys_of(recorded.iter().map(|(number, _)| *number));
        let series = SeriesWriter::create(folder, "outputs", keys, columns, per_part)?;
        Ok(Some(Self { series, rows, values: vec![] }))
    }
}

impl Table for OutputsTable {
    fn observe(&mut self, _: u64, system: &System) {
        for (number, row) in self.rows.iter().enumerate() {
            self.values.clear();
            let value = |tap: &Option<Tap>| tap.as_ref().map_or(f64::NAN, |tap| system.value(tap));
            self.values.extend(row.iter().map(value));
            self.series.observe(number, &self.values);
        }
    }

    fn record(&mut self, time: f64) -> Result<(), ObserveError> {
        Ok(self.series.record(time)?)
    }

    fn finish(self: Box<Self>) -> Result<(), ObserveError> {
        Ok(self.series.finish()?)
    }
}

/// The outputs of all these vehicles that fit one of the names, in the order of the first vehicle
/// that has them.
fn columns(
    patterns: &[String],
    vehicles: &[(usize, &Interface)],
) -> Result<Vec<Column>, OutputsError> {
    let mut columns: Vec<Column> = vec![];
    let mut fitting = vec![false; patterns.len()];
    for (number, interface) in vehicles {
        let variables = interface.variables().into_iter();
        let is_output = |v: &&Variable| v.causality == "output" && v.kind == VariableType::Real;
        for output in variables.filter(is_output) {
            let mut wanted = false;
            for (pattern, fits) in patterns.iter().zip(&mut fitting) {
                let matching = matches(pattern, &output.name);
                *fits |= matching;
                wanted |= matching;
            }
            if wanted {
                add(&mut columns, output, *number)?;
            }
        }
    }
    match fitting.iter().position(|fits| !fits) {
        None => Ok(columns),
        Some(lonely) => Err(OutputsError::None {
            pattern: patterns[lonely].clone(),
            vehicles: vehicles.iter().map(|(number, _)| *number).collect(),
        }),
    }
}

/// Adds the column of an output, unless it is there.
fn add(columns: &mut Vec<Column>, output: &Variable, vehicle: usize) -> Result<(), OutputsError> {
    let unit = output.unit.as_deref().unwrap_or("1");
    match columns.iter().find(|column| column.name() == output.name) {
        None => {
            let column = Column::new(&output.name, unit, &output.description);
            columns.push(column.double().mean().extremes());
            Ok(())
        }
        Some(other) if other.unit() == unit => Ok(()),
        Some(other) => Err(OutputsError::Units {
            name: output.name.clone(),
            unit: unit.to_owned(),
            vehicle,
            other: other.unit().to_owned(),
        }),
    }
}
