//! The parameters of a train's units, as those of the components of a package.

use controller::Gains;

use crate::interface::{Interface, VariableType};
use crate::system::structure::{Parameter, Value};
use crate::system::unit::{Unit, UnitError};
use crate::train::prepare::Folders;

/// The inputs of a unit that keep a value throughout.
pub(super) fn constants(unit: &dyn Unit, kept: &[(u32, f64)]) -> Vec<Parameter> {
    let parameter = |&(reference, value): &(u32, f64)| {
        let name = unit.interface().name_of(VariableType::Real, reference)?;
        Some(Parameter::new(name, Value::Real(value)))
    };
    kept.iter().filter_map(parameter).collect()
}

/// Gains and limit of a controller.
pub(super) fn gains(gains: &Gains) -> Vec<Parameter> {
    let real = |name: &str, value| Parameter::new(name, Value::Real(value));
    vec![
        real("gain.proportional", gains.proportional),
        real("gain.integral", gains.integral),
        real("gain.derivative", gains.derivative),
        real("force.limit", gains.limit),
    ]
}

/// The parameters of a unit that are not as its model description says, but for files in the
/// results of a run, which belong to this machine.
pub(super) fn parameters(
    unit: &mut dyn Unit,
    folders: &Folders,
) -> Result<Vec<Parameter>, UnitError> {
    let results = folders.results.to_string_lossy().into_owned();
    let mut parameters = vec![];
    for (name, reference, kind, start) in stated_parameters(unit.interface()) {
        let value = match kind {
            VariableType::Real => {
                let mut value = [f64::NAN];
                unit.get_reals(&[reference], &mut value)?;
                Value::Real(value[0])
            }
            VariableType::Integer => {
                let mut value = [0];
                unit.get_integers(&[reference], &mut value)?;
                Value::Integer(value[0])
            }
            VariableType::Boolean => {
                let mut value = [0];
                unit.get_booleans(&[reference], &mut value)?;
                Value::Boolean(value[0] != 0)
            }
            VariableType::Text => Value::Text(unit.get_text(reference)?),
        };
        let of_results = matches!(&value, Value::Text(text) if text.starts_with(&results));
        if !of_results && Some(&value) != start.and_then(|text| parse(&text, kind)).as_ref() {
            parameters.push(Parameter::new(&name, value));
        }
    }
    Ok(parameters)
}

/// Name, value reference, type and start value of every parameter.
fn stated_parameters(interface: &Interface) -> Vec<(String, u32, VariableType, Option<String>)> {
    let parameters = interface.variables().into_iter().filter(|v| v.causality == "parameter");
    parameters.map(|v| (v.name.clone(), v.reference, v.kind, v.start.clone())).collect()
}

/// A start value as it is written.
fn parse(text: &str, kind: VariableType) -> Option<Value> {
    match kind {
        VariableType::Real => text.trim().parse().ok().map(Value::Real),
        VariableType::Integer => text.trim().parse().ok().map(Value::Integer),
        VariableType::Boolean => Some(Value::Boolean(matches!(text.trim(), "true" | "1"))),
        VariableType::Text => Some(Value::Text(text.to_owned())),
    }
}
