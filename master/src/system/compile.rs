//! From a structure and its units to a system that runs. All that does not fit is found before
//! anything is run, and told in a sentence each.

use std::collections::{HashMap, HashSet};

use super::clock::Clock;
use super::links::Link;
use super::part::Part;
use super::step::System;
use super::structure::{Component, Connection, Endpoint, Parameter, Sampling, Structure, Value};
use super::unit::{Unit, UnitError};
use crate::interface::si::{Linear, SiUnit};
use crate::interface::{Interface, Variable, VariableType};

/// Why a structure cannot be run.
#[derive(Debug, thiserror::Error)]
pub enum CompileError {
    /// A unit refuses a parameter.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// The structure does not fit its units, a sentence for each problem.
    #[error("{}", .0.join("; "))]
    Unfit(Vec<String>),
}

/// Sets the parameters of a structure's units, which stand in the order of its components, and links
/// them.
///
/// # Errors
/// When a unit refuses, or the structure does not fit the units.
pub fn compile(
    structure: &Structure,
    units: Vec<Box<dyn Unit>>,
    clock: Clock,
) -> Result<System, CompileError> {
    let mut problems = vec![];
    let mut parts = vec![];
    for (component, unit) in structure.components.iter().zip(units) {
        let schedule = component.schedule;
        let mut part = Part::new(unit, schedule.stage, schedule.every);
        problems.extend(parametrise(&mut part, component, &structure.units)?);
        parts.push(part);
    }
    let mut linker = Linker {
        components: structure.components.iter().map(|c| (c.name.as_str(), c)).collect(),
        structure,
        system: System::new(clock, parts),
        taken: HashSet::new(),
    };
    for connection in &structure.connections {
        if let Err(problem) = linker.connect(connection) {
            problems.push(problem);
        }
    }
    match problems.is_empty() {
        true => Ok(linker.system),
        false => Err(CompileError::Unfit(problems)),
    }
}

struct Linker<'s> {
    structure: &'s Structure,
    components: HashMap<&'s str, &'s Component>,
    system: System,
    /// Inputs that are connected: part, type, and value reference.
    taken: HashSet<(usize, u8, u32)>,
}

impl Linker<'_> {
    /// The number of a component's part and its variable of that name.
    fn variable(&self, end: &Endpoint) -> Result<(usize, &Variable), String> {
        let Endpoint { element, connector } = end;
        let part = self.system.number(element);
        let part = part.ok_or_else(|| format!("there is no component '{element}'"))?;
        let variable = self.system.parts[part].unit.interface().variable(connector);
        let variable = variable.ok_or_else(|| {
            let source = self.components.get(element.as_str()).map_or("it", |c| &c.source);
            format!("'{element}' has a connector '{connector}', but {source} has no such variable")
        })?;
        Ok((part, variable))
    }

    fn connect(&mut self, connection: &Connection) -> Result<(), String> {
        let (giver, output) = self.variable(&connection.from)?;
        let (receiver, input) = self.variable(&connection.to)?;
        let wrong = |problem: &str| {
            let Connection { from, to, .. } = connection;
            let (from, to) = (from.to_string(), to.to_string());
            Err(format!("connection of '{from}' to '{to}': {problem}"))
        };
        if input.causality != "input" {
            return wrong("the latter is no input of its FMU");
        }
        if output.kind != input.kind {
            return wrong(&format!("a {:?} cannot become a {:?}", output.kind, input.kind));
        }
        let conversion = match self.conversion(connection, output, input) {
            Ok(conversion) => conversion,
            Err(problem) => return wrong(&problem),
        };
        let (output, input, kind) = (output.reference, input.reference, output.kind);
        if kind == VariableType::Text {
            return wrong("Strings cannot be connected");
        }
        if !self.taken.insert((receiver, kind as u8, input)) {
            return wrong("the latter is connected already");
        }
        self.link((giver, receiver), kind, (output, input), conversion, connection.sampling);
        Ok(())
    }

    /// Adds a link between two variables, given by their value references.
    fn link(
        &mut self,
        (giver, receiver): (usize, usize),
        kind: VariableType,
        (output, input): (u32, u32),
        conversion: Linear,
        sampling: Sampling,
    ) {
        let System { parts, stages, .. } = &mut self.system;
        let output = parts[giver].outputs.index(kind, output).unwrap_or_default();
        let part = &mut parts[receiver];
        let input = part.inputs.index(kind, input).unwrap_or_default();
        let sampling = if part.every == 1 { Sampling::Last } else { sampling };
        if kind == VariableType::Real {
            let count = part.inputs.reals.values.len();
            part.sums.resize(count, 0.0);
            part.samplings.resize(count, Sampling::Last);
            part.samplings[input] = sampling;
        }
        let link = Link::new((giver, output), (receiver, input));
        stages[part.stage].links.add(kind, link, conversion, sampling);
    }

    /// Conversion of units, then the transformation (SSP 1.0 §5.3.2).
    fn conversion(
        &self,
        connection: &Connection,
        output: &Variable,
        input: &Variable,
    ) -> Result<Linear, String> {
        let transformation = connection.transformation;
        if output.kind != VariableType::Real {
            return match transformation.is_identity() {
                true => Ok(transformation),
                false => Err("only a Real can be transformed".to_owned()),
            };
        }
        if !connection.convert_units {
            return Ok(transformation);
        }
        let stated = |end: &Endpoint| {
            let connector = self.components.get(end.element.as_str())?.connector(&end.connector)?;
            self.structure.units.get(connector.unit.as_ref()?).copied()
        };
        let from = output.si.or_else(|| stated(&connection.from));
        let to = input.si.or_else(|| stated(&connection.to));
        let (Some(from), Some(to)) = (from, to) else {
            return Ok(transformation);
        };
        let conversion = from.to(&to).ok_or_else(|| {
            let unit =
                |variable: &Variable| variable.unit.clone().unwrap_or_else(|| "1".to_owned());
            let (from, to) = (unit(output), unit(input));
            format!("the units '{from}' and '{to}' measure different things")
        })?;
        Ok(conversion.then(transformation))
    }
}

/// Sets the parameters of a component, and keeps the start values of its inputs for its
/// initialisation; gives what does not fit.
fn parametrise(
    part: &mut Part,
    component: &Component,
    units: &HashMap<String, SiUnit>,
) -> Result<Vec<String>, UnitError> {
    let mut problems = vec![];
    for parameter in &component.parameters {
        let Part { unit, starts, .. } = &mut *part;
        let name = format!("'{}.{}'", component.name, parameter.name);
        let Some(variable) = unit.interface().variable(&parameter.name).cloned() else {
            problems.push(format!("{name} has a start value, but there is no such variable"));
            continue;
        };
        let value = match converted(parameter, &variable, unit.interface(), units) {
            Ok(value) => value,
            Err(problem) => {
                problems.push(format!("start value of {name}: {problem}"));
                continue;
            }
        };
        match variable.causality == "input" {
            true if !starts.start(variable.reference, &value) => {
                problems.push(format!("start value of {name}: a String input cannot be started"))
            }
            true => {}
            false => unit.set_value(variable.reference, &value)?,
        }
    }
    Ok(problems)
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
    let transformation = parameter.transformation;
    let Value::Real(number) = value else {
        return match transformation.is_identity() {
            true => Ok(value),
            false => Err("only a Real can be transformed".to_owned()),
        };
    };
    let transformed = |number| Ok(Value::Real(transformation.apply(number)));
    let Some(unit) = &parameter.unit else { return transformed(number) };
    let given = parameter.si.or_else(|| units.get(unit).copied()).or_else(|| interface.unit(unit));
    match (given, variable.si) {
        (Some(given), Some(own)) => match given.to(&own) {
            Some(conversion) => transformed(conversion.apply(number)),
            None => Err(format!(
                "the units '{unit}' and '{}' measure different things",
                variable.unit.as_deref().unwrap_or("1")
            )),
        },
        _ => transformed(number),
    }
}
