//! A reference run.

use std::sync::Arc;

use super::ReferenceError;
use super::experiment::Experiment;
use super::table::Table;
use crate::fmi::{FmuInstance, Import};
use crate::interface::VariableType;
use crate::system::unit::Unit;

/// Runs an FMU and gives the outputs that the experiment names.
///
/// # Errors
/// When the FMU lacks a variable, or fails.
pub fn run(
    import: &Arc<Import>,
    experiment: &Experiment,
    inputs: &Table,
) -> Result<Table, ReferenceError> {
    let into = references(import, &inputs.names, "input")?;
    let from = references(import, &experiment.outputs, "output")?;
    let mut unit: Box<dyn Unit> = Box::new(FmuInstance::new(import, "reference")?);
    for (name, value) in &experiment.start_values {
        unit.set_real_parameter(name, *value)?;
    }
    unit.enter_initialization(0.0, experiment.stop_time_s)?;
    unit.set_reals(&into, &inputs.at(0.0))?;
    unit.exit_initialization()?;

    let mut result = Table { names: experiment.outputs.clone(), ..Table::default() };
    let mut record = |unit: &mut dyn Unit, time| -> Result<(), ReferenceError> {
        let mut values = vec![0.0; from.len()];
        unit.get_reals(&from, &mut values)?;
        result.times.push(time);
        result.rows.push(values);
        Ok(())
    };
    record(unit.as_mut(), 0.0)?;
    for k in 0..experiment.steps() {
        let time = k as f64 * experiment.step_s;
        unit.set_reals(&into, &inputs.at(time))?;
        unit.step(time, experiment.step_s)?;
        if (k + 1).is_multiple_of(experiment.record_every) {
            record(unit.as_mut(), (k + 1) as f64 * experiment.step_s)?;
        }
    }
    unit.terminate()?;
    Ok(result)
}

/// Value references of Real variables.
fn references(
    import: &Import,
    names: &[String],
    causality: &'static str,
) -> Result<Vec<u32>, ReferenceError> {
    let reference = |name: &String| {
        let variable = import.interface().variable(name);
        let fits = variable.filter(|variable| {
            variable.kind == VariableType::Real && variable.causality == causality
        });
        fits.map(|variable| variable.reference).ok_or_else(|| ReferenceError::Variable {
            file: import.file().to_owned(),
            causality,
            name: name.clone(),
        })
    };
    names.iter().map(reference).collect()
}
