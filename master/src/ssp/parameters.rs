//! Start values: parameter bindings in the structure or in files of the package (SSV), with
//! mappings of their names (SSM).

use std::collections::HashMap;
use std::path::{Component as PathPart, Path};

use roxmltree::Node;

use super::error::SspError;
use super::read::{transformation, units};
use super::xml::{XmlFile, child, children, listed};
use crate::files::file_error::FileError;
use crate::interface::si::SiUnit;
use crate::system::structure::{Parameter, Value};

/// The start values that are bound to an element, in the order in which they are applied.
///
/// # Errors
/// When a file is missing or not as SSP 1.0 wants it.
pub fn bindings(
    file: &XmlFile<'_>,
    package: &Path,
    element: Node<'_, '_>,
) -> Result<Vec<Parameter>, SspError> {
    let mut parameters = vec![];
    for binding in listed(element, "ParameterBindings", "ParameterBinding") {
        let prefix = binding.attribute("prefix").unwrap_or_default();
        let mut bound = match (binding.attribute("source"), child(binding, "ParameterValues")) {
            (Some(source), _) => {
                let text = text_of(file, binding, package, source)?;
                let file = XmlFile::parse(source, &text)?;
                parameter_set(&file, file.document.root_element())?
            }
            (None, Some(values)) => match child(values, "ParameterSet") {
                Some(set) => parameter_set(file, set)?,
                None => vec![],
            },
            (None, None) => vec![],
        };
        for parameter in &mut bound {
            parameter.name.insert_str(0, prefix);
        }
        parameters.extend(match child(binding, "ParameterMapping") {
            Some(mapping) => mapped(file, package, mapping, bound)?,
            None => bound,
        });
    }
    Ok(parameters)
}

/// The text of a file in the package.
fn text_of(
    file: &XmlFile<'_>,
    node: Node<'_, '_>,
    package: &Path,
    source: &str,
) -> Result<String, SspError> {
    let inside = Path::new(source).components().all(|part| matches!(part, PathPart::Normal(_)));
    if !inside {
        let message = format!("source=\"{source}\" must be a path inside of the package");
        return Err(file.wrong(node, message));
    }
    let path = package.join(source);
    Ok(std::fs::read_to_string(&path).map_err(FileError::at(&path))?)
}

/// The parameters of an element ParameterSet.
fn parameter_set(file: &XmlFile<'_>, set: Node<'_, '_>) -> Result<Vec<Parameter>, SspError> {
    let units = units(file, set)?;
    listed(set, "Parameters", "Parameter").map(|node| parameter(file, node, &units)).collect()
}

fn parameter(
    file: &XmlFile<'_>,
    node: Node<'_, '_>,
    units: &HashMap<String, SiUnit>,
) -> Result<Parameter, SspError> {
    let name = file.required(node, "name")?.to_owned();
    let typed = node.children().find(|child| {
        let name = child.tag_name().name();
        child.is_element() && name != "Annotations"
    });
    let typed =
        typed.ok_or_else(|| file.wrong(node, format!("parameter '{name}' has no value")))?;
    let missing = || file.wrong(typed, format!("parameter '{name}' lacks the attribute 'value'"));
    let value = match typed.tag_name().name() {
        "Real" => Value::Real(file.value(typed, "value")?.ok_or_else(missing)?),
        "Integer" => Value::Integer(file.value(typed, "value")?.ok_or_else(missing)?),
        "Boolean" => Value::Boolean(boolean(file, typed)?),
        "String" => Value::Text(file.required(typed, "value")?.to_owned()),
        other => {
            let message = format!(
                "parameter '{name}' is of type {other}; Hotfoot sets Real, Integer, Boolean and String"
            );
            return Err(file.wrong(typed, message));
        }
    };
    let unit = typed.attribute("unit").map(str::to_owned);
    let si = unit.as_ref().and_then(|unit| units.get(unit)).copied();
    Ok(Parameter { name, value, unit, si })
}

/// `true`, `false`, `1` or `0`, as XML schema has it.
fn boolean(file: &XmlFile<'_>, node: Node<'_, '_>) -> Result<bool, SspError> {
    match file.required(node, "value")? {
        "true" | "1" => Ok(true),
        "false" | "0" => Ok(false),
        other => Err(file.wrong(node, format!("value=\"{other}\" must be true or false"))),
    }
}

/// The parameters that a mapping takes over, under its names and with its transformations.
fn mapped(
    file: &XmlFile<'_>,
    package: &Path,
    mapping: Node<'_, '_>,
    parameters: Vec<Parameter>,
) -> Result<Vec<Parameter>, SspError> {
    if let Some(source) = mapping.attribute("source") {
        let text = text_of(file, mapping, package, source)?;
        let file = XmlFile::parse(source, &text)?;
        return entries(&file, file.document.root_element(), &parameters);
    }
    match child(mapping, "ParameterMapping") {
        Some(mapping) => entries(file, mapping, &parameters),
        None => Ok(vec![]),
    }
}

fn entries(
    file: &XmlFile<'_>,
    mapping: Node<'_, '_>,
    parameters: &[Parameter],
) -> Result<Vec<Parameter>, SspError> {
    let mut mapped = vec![];
    for entry in children(mapping, "MappingEntry") {
        let source = file.required(entry, "source")?;
        let target = file.required(entry, "target")?;
        let way = transformation(file, entry)?;
        for parameter in parameters.iter().filter(|parameter| parameter.name == source) {
            let mut parameter = parameter.clone();
            target.clone_into(&mut parameter.name);
            match &mut parameter.value {
                Value::Real(value) => *value = way.apply(*value),
                _ if way.is_identity() => {}
                other => {
                    let message = format!(
                        "'{source}' is of type {}; only a Real can be transformed",
                        other.type_name()
                    );
                    return Err(file.wrong(entry, message));
                }
            }
            mapped.push(parameter);
        }
    }
    Ok(mapped)
}
