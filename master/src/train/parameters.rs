//! Parameters of FMUs that a scenario sets by their names.

use std::path::Path;

use files::did_you_mean;

use crate::fmi::Import;
use crate::interface::{Variable, VariableType};
use crate::scenario::Value;
use crate::system::unit::Unit;
use crate::train::prepare::PrepareError;
use crate::train::resources::parameter_file;

/// Sets a parameter as the scenario says in the table `key`. An input is given back with its value, since an FMU
/// takes inputs only when it is being initialised (FMI 2.0 §4.2.4).
pub(crate) fn set_parameter(
    unit: &mut dyn Unit,
    import: &Import,
    key: &str,
    (name, value): (&str, &Value),
) -> Result<Option<(u32, f64)>, PrepareError> {
    let wrong = |problem: String| PrepareError::Parameter {
        key: key.to_owned(),
        name: name.to_owned(),
        value: value.to_string(),
        problem,
    };
    let file = import.file();
    let variable = unit.interface().variable(name).cloned().ok_or_else(|| {
        let variables = unit.interface().variables();
        let meant = did_you_mean(name, variables.iter().map(|variable| variable.name.as_str()));
        wrong(format!("{file} has no such variable; `hotfoot interface {file}` lists them{meant}"))
    })?;
    let Variable { reference, kind, causality, .. } = variable;
    if let ("input", VariableType::Real, Some(number)) = (causality.as_str(), kind, value.number())
    {
        return Ok(Some((reference, number)));
    }
    if causality != "parameter" {
        return Err(wrong(format!("it is no parameter but {causality} of {file}")));
    }
    match (kind, value, value.number()) {
        (VariableType::Real, _, Some(number)) => unit.set_reals(&[reference], &[number])?,
        (VariableType::Integer, Value::Integer(value), _) => {
            unit.set_integers(&[reference], &[*value])?;
        }
        (VariableType::Boolean, Value::Boolean(value), _) => {
            unit.set_booleans(&[reference], &[i32::from(*value)])?;
        }
        (VariableType::Text, Value::Text(value), _) => unit.set_text(reference, value)?,
        (VariableType::Text, Value::File(original), _) => {
            unit.set_text(reference, &path_of_copy(import, name, original))?;
        }
        _ => {
            let wanted = match kind {
                VariableType::Real => "a Real: a number such as 0.5",
                VariableType::Integer => "an Integer: a whole number such as 2",
                VariableType::Boolean => "a Boolean: true or false",
                VariableType::Text => "a String: a text in quotation marks",
            };
            return Err(wrong(format!("it is {wanted}")));
        }
    }
    Ok(None)
}

/// The file in the FMU's resources; the original for an FMU that was not packed for the scenario.
fn path_of_copy(import: &Import, name: &str, original: &Path) -> String {
    let copy = import.resources().join(parameter_file(name, original));
    let path = if copy.exists() { &copy } else { original };
    path.display().to_string()
}
