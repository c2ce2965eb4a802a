//! Parameters of FMUs that a scenario sets by their names.

use files::did_you_mean;

use super::error::PrepareError;
use super::resources::parameter_file;
use crate::fmi::Import;
use crate::interface::VariableType;
use crate::scenario::Value as Stated;
use crate::system::structure::{Parameter, Value};

/// A parameter, or the start value of an input, as the scenario says in the table `key`.
///
/// # Errors
/// When the FMU has no such variable, or one of another type.
pub fn parameter(
    import: &Import,
    key: &str,
    name: &str,
    stated: &Stated,
) -> Result<Parameter, PrepareError> {
    let wrong = |problem: String| PrepareError::Parameter {
        key: key.to_owned(),
        name: name.to_owned(),
        value: stated.to_string(),
        problem,
    };
    let file = import.file();
    let variable = import.interface().variable(name).ok_or_else(|| {
        let variables = import.interface().variables();
        let meant = did_you_mean(name, variables.iter().map(|variable| variable.name.as_str()));
        wrong(format!("{file} has no such variable; `hotfoot interface {file}` lists them{meant}"))
    })?;
    let (causality, kind) = (variable.causality.as_str(), variable.kind);
    let is_input = causality == "input" && kind == VariableType::Real && stated.number().is_some();
    if causality != "parameter" && !is_input {
        return Err(wrong(format!("it is no parameter but {causality} of {file}")));
    }
    let value = match (kind, stated, stated.number()) {
        (VariableType::Real, _, Some(number)) => Value::Real(number),
        (VariableType::Integer, Stated::Integer(value), _) => Value::Integer(*value),
        (VariableType::Boolean, Stated::Boolean(value), _) => Value::Boolean(*value),
        (VariableType::Text, Stated::Text(value), _) => Value::Text(value.clone()),
        (VariableType::Text, Stated::File(original), _) => {
            let copy = parameter_file(name, original);
            let path = match import.resources().join(&copy).exists() {
                true => &copy,
                // An FMU that was not packed for the scenario has no copy.
                false => original,
            };
            Value::Text(path.display().to_string())
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
    };
    Ok(Parameter::new(name, value))
}
