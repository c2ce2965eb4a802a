//! Start values: parameter bindings in the structure or in files of the package (SSV), with
//! mappings of their names (SSM).

use std::collections::HashMap;

use roxmltree::Node;

use super::error::SspError;
use super::package::Package;
use super::units::{transformation, units};
use super::xml::{XmlFile, child, children, listed};
use crate::interface::si::Linear;
use crate::interface::si::SiUnit;
use crate::system::structure::{Parameter, Value};

/// The start values that are bound to an element, in the order in which they are applied.
///
/// # Errors
/// When a file is missing or not as SSP 1.0 wants it.
pub fn bindings(
    file: &XmlFile<'_>,
    package: &Package<'_>,
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
    package: &Package<'_>,
    source: &str,
) -> Result<String, SspError> {
    package.xml(source)?.ok_or_else(|| {
        file.wrong(node, format!("source=\"{source}\" must be a path inside of the package"))
    })
}

/// The parameters of an element ParameterSet.
fn parameter_set(file: &XmlFile<'_>, set: Node<'_, '_>) -> Result<Vec<Parameter>, SspError> {
    let units = units(file, set)?;
    listed(set, "Parameters", "Parameter").map(|node| parameter(file, set, node, &units)).collect()
}

fn parameter(
    file: &XmlFile<'_>,
    set: Node<'_, '_>,
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
        "Enumeration" => Value::Integer(enumeration(file, set, typed)?),
        other => {
            let message = format!(
                "parameter '{name}' is of type {other}; Hotfoot sets Real, Integer, Boolean, String and Enumeration"
            );
            return Err(file.wrong(typed, message));
        }
    };
    let unit = typed.attribute("unit").map(str::to_owned);
    let si = unit.as_ref().and_then(|unit| units.get(unit)).copied();
    Ok(Parameter { name, value, unit, si, local: false, transformation: Linear::IDENTITY })
}

/// `true`, `false`, `1` or `0`, as XML schema has it.
fn boolean(file: &XmlFile<'_>, node: Node<'_, '_>) -> Result<bool, SspError> {
    match file.required(node, "value")? {
        "true" | "1" => Ok(true),
        "false" | "0" => Ok(false),
        other => Err(file.wrong(node, format!("value=\"{other}\" must be true or false"))),
    }
}

/// The number of an item of an enumeration, which is given by its name; some tools write the number.
fn enumeration(
    file: &XmlFile<'_>,
    set: Node<'_, '_>,
    typed: Node<'_, '_>,
) -> Result<i32, SspError> {
    let value = file.required(typed, "value")?;
    if let Ok(number) = value.parse() {
        return Ok(number);
    }
    let mut names = vec![];
    let stated = typed.attribute("name");
    for enumeration in listed(set, "Enumerations", "Enumeration") {
        if stated.is_some_and(|stated| enumeration.attribute("name") != Some(stated)) {
            continue;
        }
        for item in children(enumeration, "Item") {
            let name = file.required(item, "name")?;
            if name == value {
                let missing = || file.wrong(item, "an item of an enumeration lacks its value");
                return file.value(item, "value")?.ok_or_else(missing);
            }
            names.push(name);
        }
    }
    let message = if names.is_empty() {
        format!(
            "value=\"{value}\" names an item, but the parameter set declares no enumeration of it"
        )
    } else {
        format!("value=\"{value}\" is no item of the enumeration, which has {}", names.join(", "))
    };
    Err(file.wrong(typed, message))
}

/// The parameters that a mapping takes over, under its names and with its transformations.
fn mapped(
    file: &XmlFile<'_>,
    package: &Package<'_>,
    mapping: Node<'_, '_>,
    parameters: Vec<Parameter>,
) -> Result<Vec<Parameter>, SspError> {
    if let Some(source) = mapping.attribute("source") {
        let text = text_of(file, mapping, package, source)?;
        let file = XmlFile::parse(source, &text)?;
        return entries(&file, package, file.document.root_element(), &parameters);
    }
    match child(mapping, "ParameterMapping") {
        Some(mapping) => entries(file, package, mapping, &parameters),
        None => Ok(vec![]),
    }
}

fn entries(
    file: &XmlFile<'_>,
    package: &Package<'_>,
    mapping: Node<'_, '_>,
    parameters: &[Parameter],
) -> Result<Vec<Parameter>, SspError> {
    let mut mapped = vec![];
    let mut sources = vec![];
    for entry in children(mapping, "MappingEntry") {
        let source = file.required(entry, "source")?;
        sources.push(source);
        let target = file.required(entry, "target")?;
        let transformation = transformation(file, entry)?;
        for parameter in parameters.iter().filter(|parameter| parameter.name == source) {
            let mut parameter = parameter.clone();
            target.clone_into(&mut parameter.name);
            match &mut parameter.value {
                Value::Real(value) => *value = transformation.apply(*value),
                _ if transformation.is_identity() => {}
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
    for parameter in parameters.iter().filter(|own| !sources.contains(&own.name.as_str())) {
        let Parameter { name, .. } = parameter;
        package.note(format!("'{name}' has a start value that {} maps to nothing", file.name));
    }
    for source in sources.into_iter().filter(|source| !parameters.iter().any(|p| p.name == *source))
    {
        package.note(format!("{} maps '{source}', which has no start value", file.name));
    }
    Ok(mapped)
}
