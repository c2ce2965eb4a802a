//! Parameters of FMUs that a scenario sets by their names.

use files::{Check, Mistake, did_you_mean};
use numerics::constants::ZERO_CELSIUS;

use super::resources::parameter_file;
use crate::fmi::Import;
use crate::interface::VariableType;
use crate::interface::range::Range;
use crate::scenario::{Value as Stated, quoted};
use crate::system::structure::{Parameter, Value};

/// A parameter, or the start value of an input, as the scenario says in the section of `check`.
///
/// # Errors
/// When the FMU has no such variable, or one of another type.
pub fn parameter(
    import: &Import,
    check: &Check,
    name: &str,
    stated: &Stated,
) -> Result<Parameter, Mistake> {
    let key = quoted(name);
    let wrong = |problem: String| check.error(&key, stated, problem);
    let file = import.file();
    let variable = import.interface().variable(name).ok_or_else(|| {
        let variables = import.interface().variables();
        let meant = did_you_mean(name, variables.iter().map(|variable| variable.name.as_str()));
        wrong(match meant.is_empty() {
            true => {
                "there is no such parameter; `hotfoot interface` lists those of an FMU".to_owned()
            }
            false => format!("there is no such parameter{meant}"),
        })
    })?;
    let (causality, kind) = (variable.causality.as_str(), variable.kind);
    let is_input = causality == "input" && kind == VariableType::Real && stated.number().is_some();
    if causality != "parameter" && !is_input {
        return Err(wrong(format!("is no parameter but {causality} of {file}")));
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
                VariableType::Real => "a number such as 0.5",
                VariableType::Integer => "a whole number such as 2",
                VariableType::Boolean => "true or false",
                VariableType::Text => "a text in quotation marks",
            };
            return Err(wrong(format!("must be {wanted}")));
        }
    };
    match value {
        Value::Real(number) if !variable.range.contains(number) => {
            let unit = variable.unit.as_deref().unwrap_or_default();
            Err(wrong(outside(number, variable.range, unit)))
        }
        value => Ok(Parameter::new(name, value)),
    }
}

/// What is right for a number outside its range, with what may be meant by one in degrees or percent.
fn outside(number: f64, range: Range, unit: &str) -> String {
    let Range { min, max } = range;
    let bounds = match (min > f64::MIN, max < f64::MAX) {
        (true, true) => format!("lie between {min} and {max}"),
        (true, false) => format!("be at least {min}"),
        (false, _) => format!("be at most {max}"),
    };
    let unit_word = if unit.is_empty() || unit == "1" { String::new() } else { format!(" {unit}") };
    let hint = match unit {
        "rad" if range.contains(number.to_radians()) => {
            format!("; it is in radians: {:.4} for {number}°", number.to_radians())
        }
        "K" if range.contains(number + ZERO_CELSIUS) => {
            format!("; it is in kelvin: {} for {number} °C", number + ZERO_CELSIUS)
        }
        "" | "1" if number > max && range.contains(number / 100.0) => {
            format!("; it is a share: {} for {number} %", number / 100.0)
        }
        _ => String::new(),
    };
    format!("must {bounds}{unit_word}{hint}")
}
