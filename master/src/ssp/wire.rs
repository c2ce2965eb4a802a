//! From a structure to instances of FMUs with what flows between them. All that does not fit is
//! found before anything is run, and told in a sentence each.

use std::collections::{BTreeMap, HashMap};
use std::path::{Component as PathPart, Path};
use std::sync::Arc;

use percent_encoding::percent_decode_str;

use super::error::SspError;
use crate::fmi::{FmuInstance, Import};
use crate::interface::si::{Linear, SiUnit};
use crate::interface::{Interface, Variable, VariableType};
use crate::system::links::{Link, Part, Place};
use crate::system::step::System;
use crate::system::structure::{Component, Connection, Parameter, Structure, Value};
use crate::system::unit::{Unit, UnitError};
use crate::train::lockstep::Clock;

/// Instantiates the FMUs of a structure, sets their parameters, and links them.
///
/// `package` is the folder of the unpacked package, `file` its name for messages.
///
/// # Errors
/// When an FMU cannot be used, or the structure does not fit the FMUs.
pub fn wire(
    structure: &Structure,
    package: &Path,
    file: &str,
    clock: Clock,
) -> Result<System, SspError> {
    let imports = imports(structure, package, file)?;
    let mut wiring = Wiring { structure, system: System::empty(clock), problems: vec![] };
    for component in &structure.components {
        let import = &imports[component.source.as_str()];
        let unit: Box<dyn Unit> = Box::new(FmuInstance::new(import, &component.name)?);
        wiring.system.parts.push(Part::new(unit));
    }
    for connection in &structure.connections {
        if let Err(problem) = wiring.connect(connection) {
            wiring.problems.push(problem);
        }
    }
    for (part, component) in structure.components.iter().enumerate() {
        wiring.parametrise(part, component)?;
    }
    match wiring.problems.is_empty() {
        true => Ok(wiring.system),
        false => Err(SspError::Unfit { file: file.to_owned(), problems: wiring.problems }),
    }
}

/// Every FMU once, however many components use it.
fn imports<'s>(
    structure: &'s Structure,
    package: &Path,
    file: &str,
) -> Result<BTreeMap<&'s str, Arc<Import>>, SspError> {
    let unfit = |problem| SspError::Unfit { file: file.to_owned(), problems: vec![problem] };
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for component in &structure.components {
        *counts.entry(&component.source).or_default() += 1;
    }
    let mut imports = BTreeMap::new();
    for (source, count) in counts {
        let path = percent_decode_str(source).decode_utf8_lossy().into_owned();
        let inside = Path::new(&path).components().all(|part| matches!(part, PathPart::Normal(_)));
        if !inside {
            return Err(unfit(format!("source=\"{source}\" must be a path inside of the package")));
        }
        let import = Import::open(&package.join(path))?;
        if import.interface().once_per_process && count > 1 {
            return Err(unfit(format!(
                "{source} allows only one instance in a process \
                 (canBeInstantiatedOnlyOncePerProcess), but {count} components use it"
            )));
        }
        imports.insert(source, import);
    }
    Ok(imports)
}

struct Wiring<'s> {
    structure: &'s Structure,
    system: System,
    problems: Vec<String>,
}

impl Wiring<'_> {
    /// The number of a component and its variable of that name.
    fn variable(&self, element: &str, name: &str) -> Result<(usize, &Variable), String> {
        let part = self.structure.components.iter().position(|c| c.name == element);
        let part = part.ok_or_else(|| format!("there is no component '{element}'"))?;
        let variable = self.system.parts[part].unit.interface().variable(name);
        let variable = variable.ok_or_else(|| {
            let source = &self.structure.components[part].source;
            format!("'{element}' has a connector '{name}', but {source} has no such variable")
        })?;
        Ok((part, variable))
    }

    fn connect(&mut self, connection: &Connection) -> Result<(), String> {
        let Connection { from, to, .. } = connection;
        let (from_part, output) = self.variable(&from.element, &from.connector)?;
        let (to_part, input) = self.variable(&to.element, &to.connector)?;
        let names =
            format!("'{}.{}' to '{}.{}'", from.element, from.connector, to.element, to.connector);
        if input.causality != "input" {
            return Err(format!("connection of {names}: the latter is no input of its FMU"));
        }
        if output.kind != input.kind {
            return Err(format!(
                "connection of {names}: a {:?} cannot become a {:?}",
                output.kind, input.kind
            ));
        }
        let way = self.way(connection, output, input, &names)?;
        let (output, input, kind) = (output.reference, input.reference, output.kind);
        let System { parts, links, .. } = &mut self.system;
        let ends = (
            parts[from_part].outputs.place(kind, output),
            parts[to_part].inputs.place(kind, input),
            links.of(kind),
        );
        let (Some(from_at), Some(to_at), Some(links)) = ends else {
            return Err(format!("connection of {names}: Strings cannot be connected"));
        };
        let from = Place { part: from_part, at: from_at };
        let to = Place { part: to_part, at: to_at };
        if links.iter().any(|other| other.to == to) {
            return Err(format!("connection of {names}: the latter is connected already"));
        }
        links.push(Link { from, to, way });
        Ok(())
    }

    /// Conversion of units, then the transformation (SSP 1.0 §5.3.2).
    fn way(
        &self,
        connection: &Connection,
        output: &Variable,
        input: &Variable,
        names: &str,
    ) -> Result<Linear, String> {
        let transformation = connection.transformation;
        if output.kind != VariableType::Real {
            return match transformation.is_identity() {
                true => Ok(transformation),
                false => Err(format!("connection of {names}: only a Real can be transformed")),
            };
        }
        let unit_of = |end: &crate::system::structure::Endpoint, variable: &Variable| {
            let stated = self.structure.component(&end.element)?.connector(&end.connector)?;
            variable.si.or_else(|| self.structure.units.get(stated.unit.as_ref()?).copied())
        };
        let units = (unit_of(&connection.from, output), unit_of(&connection.to, input));
        let (true, (Some(from), Some(to))) = (connection.convert_units, units) else {
            return Ok(transformation);
        };
        let conversion = from.to(&to).ok_or_else(|| {
            format!(
                "connection of {names}: the units '{}' and '{}' measure different things",
                output.unit.as_deref().unwrap_or("1"),
                input.unit.as_deref().unwrap_or("1"),
            )
        })?;
        Ok(conversion.then(transformation))
    }

    /// Sets the parameters of a component; start values of inputs are kept for its
    /// initialisation.
    fn parametrise(&mut self, part: usize, component: &Component) -> Result<(), SspError> {
        let units = &self.structure.units;
        for parameter in &component.parameters {
            let Part { unit, inputs, .. } = &mut self.system.parts[part];
            let name = format!("'{}.{}'", component.name, parameter.name);
            let Some(variable) = unit.interface().variable(&parameter.name).cloned() else {
                self.problems
                    .push(format!("{name} has a start value, but there is no such variable"));
                continue;
            };
            let value = match converted(parameter, &variable, unit.interface(), units) {
                Ok(value) => value,
                Err(problem) => {
                    self.problems.push(format!("start value of {name}: {problem}"));
                    continue;
                }
            };
            match variable.causality == "input" {
                true if !inputs.start(variable.reference, &value) => self
                    .problems
                    .push(format!("start value of {name}: a String input cannot be started")),
                true => {}
                false => set(unit.as_mut(), variable.reference, &value)?,
            }
        }
        Ok(())
    }
}

/// A parameter's value in the type and unit of its variable.
fn converted(
    parameter: &Parameter,
    variable: &Variable,
    interface: &Interface,
    units: &HashMap<String, SiUnit>,
) -> Result<Value, String> {
    let value = match (&parameter.value, variable.kind) {
        (Value::Real(_), VariableType::Real)
        | (Value::Integer(_), VariableType::Integer)
        | (Value::Boolean(_), VariableType::Boolean)
        | (Value::Text(_), VariableType::Text) => parameter.value.clone(),
        (&Value::Integer(value), VariableType::Real) => Value::Real(f64::from(value)),
        (value, kind) => {
            return Err(format!(
                "it is of type {}, but the variable is {kind:?}",
                value.type_name()
            ));
        }
    };
    let (Value::Real(number), Some(unit)) = (&value, &parameter.unit) else {
        return Ok(value);
    };
    let given = parameter.si.or_else(|| units.get(unit).copied()).or_else(|| interface.unit(unit));
    match (given, variable.si) {
        (Some(given), Some(own)) => match given.to(&own) {
            Some(way) => Ok(Value::Real(way.apply(*number))),
            None => Err(format!(
                "the units '{unit}' and '{}' measure different things",
                variable.unit.as_deref().unwrap_or("1")
            )),
        },
        _ => Ok(value),
    }
}

fn set(unit: &mut dyn Unit, reference: u32, value: &Value) -> Result<(), UnitError> {
    match value {
        Value::Real(value) => unit.set_reals(&[reference], &[*value]),
        Value::Integer(value) => unit.set_integers(&[reference], &[*value]),
        Value::Boolean(value) => unit.set_booleans(&[reference], &[i32::from(*value)]),
        Value::Text(value) => unit.set_text(reference, value),
    }
}
