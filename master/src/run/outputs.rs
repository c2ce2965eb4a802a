//! Further outputs of the recorded vehicles: those that the scenario names.

use std::path::Path;

use files::{Check, Mistake, did_you_mean};

use super::observe_error::{ObserveError, OutputsError};
use super::step_table::{StepTable, signals};
use crate::interface::name_pattern::matches;
use crate::interface::{Interface, Variable, VariableType};
use crate::recording::{Column, SeriesWriter, vehicle_keys_of};
use crate::scenario::Scenario;
use crate::system::step::System;
use crate::train::layout::VehicleHolder;

/// The table `outputs`: a row for each of these vehicles, with their numbers from one, and a column for
/// each output that the scenario names; outputs that a vehicle lacks are not-a-number there. None if no output is wanted.
///
/// # Errors
/// When a name fits no output, or the folder cannot be written.
pub fn table(
    scenario: &Scenario,
    recorded: &[(usize, &VehicleHolder)],
    system: &mut System,
    (folder, per_part): (&Path, usize),
) -> Result<Option<StepTable>, ObserveError> {
    let patterns = &scenario.record.outputs;
    if patterns.is_empty() || recorded.is_empty() {
        return Ok(None);
    }
    let interface = |(number, holder): &(usize, &VehicleHolder)| {
        let part = system.number(&holder.component)?;
        Some((*number, system.parts[part].unit.interface()))
    };
    let interfaces: Vec<_> = recorded.iter().filter_map(interface).collect();
    let columns = columns(patterns, &interfaces, &scenario.check())?;
    let mut row = |(_, holder): &(usize, &VehicleHolder)| {
        let tap = |column: &Column| system.tap(&holder.component, column.name());
        signals(columns.iter().map(tap).collect(), f64::NAN)
    };
    let rows = recorded.iter().map(&mut row).collect();
    let keys = vehicle_keys_of(recorded.iter().map(|(number, _)| *number));
    let series = SeriesWriter::create(folder, "outputs", keys, columns, per_part)?;
    Ok(Some(StepTable::new(series, rows)))
}

/// The outputs of all these vehicles that fit one of the names, in the order of the first vehicle
/// that has them.
fn columns(
    patterns: &[String],
    vehicles: &[(usize, &Interface)],
    check: &Check,
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
        Some(lonely) => {
            Err(OutputsError::None(no_output(lonely, &patterns[lonely], vehicles, check)))
        }
    }
}

/// The mistake of the name with this index that fits no output of these vehicles.
fn no_output(
    index: usize,
    pattern: &str,
    vehicles: &[(usize, &Interface)],
    check: &Check,
) -> Mistake {
    let outputs = vehicles.iter().flat_map(|(_, interface)| interface.variables());
    let outputs = outputs.filter(|v| v.causality == "output" && v.kind == VariableType::Real);
    // With a star in front, the end of a name is what was meant.
    let names: Vec<String> = match pattern.strip_prefix("*.") {
        None => outputs.map(|output| output.name.clone()).collect(),
        Some(_) => outputs
            .map(|output| format!("*.{}", output.name.rsplit('.').next().unwrap_or_default()))
            .collect(),
    };
    let meant = did_you_mean(pattern, names.iter().map(String::as_str));
    let numbers =
        vehicles.iter().map(|(number, _)| number.to_string()).collect::<Vec<_>>().join(", ");
    let wanted = format!("no output of the recorded vehicles {numbers} has this name{meant}");
    check.error(&format!("record.outputs[{}]", index + 1), format!("\"{pattern}\""), wanted)
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
