//! A reference run.

use std::sync::Arc;

use super::ReferenceError;
use super::experiment::Experiment;
use super::table::{Signal, Table};
use crate::fmi::{FmuInstance, Import};
use crate::interface::VariableType;
use crate::system::clock::beyond;
use crate::system::structure::Value;
use crate::system::unit::Unit;

/// Runs an FMU, to the end or until it wants to end, and gives the outputs that the experiment names.
///
/// # Errors
/// When the FMU lacks a variable, or fails.
pub fn run(
    import: &Arc<Import>,
    experiment: &Experiment,
    inputs: &Table,
) -> Result<Table, ReferenceError> {
    let into = variables(import, &inputs.names(), "input")?;
    let from = variables(import, &experiment.outputs, "output")?;
    let mut unit: Box<dyn Unit> = Box::new(FmuInstance::new(import, "reference")?);
    for (name, value) in &experiment.start_values {
        unit.set_real_parameter(name, *value)?;
    }
    unit.enter_initialization(0.0, beyond(0.0, experiment.stop_time_s))?;
    set(unit.as_mut(), &into, inputs.at(0.0))?;
    unit.exit_initialization()?;

    let signals = experiment.outputs.iter().map(|name| Signal::of(import.interface(), name));
    let mut result = Table { signals: signals.collect(), ..Table::default() };
    record(unit.as_mut(), &from, 0.0, &mut result)?;
    for k in 0..experiment.steps() {
        let time = k as f64 * experiment.step_s;
        set(unit.as_mut(), &into, inputs.at(time))?;
        if let Err(error) = unit.step(time, experiment.step_s) {
            let end = unit.wish_to_end().ok_or(error)?;
            if result.times.last() != Some(&end) {
                record(unit.as_mut(), &from, end, &mut result)?;
            }
            break;
        }
        if (k + 1).is_multiple_of(experiment.record_every) {
            let time = (k + 1) as f64 * experiment.step_s;
            record(unit.as_mut(), &from, time, &mut result)?;
        }
    }
    unit.terminate()?;
    Ok(result)
}

/// Type and value reference of a variable.
type Access = (VariableType, u32);

fn set(unit: &mut dyn Unit, into: &[Access], values: Vec<Value>) -> Result<(), ReferenceError> {
    for ((_, reference), value) in into.iter().zip(values) {
        unit.set_value(*reference, &value)?;
    }
    Ok(())
}

/// Appends a row of what the unit gives to a table.
fn record(
    unit: &mut dyn Unit,
    from: &[Access],
    time: f64,
    result: &mut Table,
) -> Result<(), ReferenceError> {
    let values = from.iter().map(|&(kind, reference)| unit.value(kind, reference));
    result.rows.push(values.collect::<Result<_, _>>()?);
    result.times.push(time);
    Ok(())
}

/// The variables of these names.
fn variables(
    import: &Import,
    names: &[String],
    causality: &'static str,
) -> Result<Vec<Access>, ReferenceError> {
    let access = |name: &String| {
        let variable = import.interface().variable(name);
        let fits = variable.filter(|variable| variable.causality == causality);
        fits.map(|variable| (variable.kind, variable.reference)).ok_or_else(|| {
            let file = import.file().to_owned();
            ReferenceError::Variable { file, causality, name: name.clone() }
        })
    };
    names.iter().map(access).collect()
}
