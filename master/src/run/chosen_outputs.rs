//! The outputs of a package's components that its run records.

use std::collections::HashSet;

use files::did_you_mean;

use super::observe_error::OutputsError;
use crate::interface::name_pattern::matches;
use crate::interface::{Variable, VariableType};
use crate::system::step::System;
use crate::system::structure::Endpoint;
use crate::system::unit::Unit;

/// The outputs that are recorded; by default every one.
#[derive(Debug, Default)]
pub struct ChosenOutputs(Option<HashSet<Endpoint>>);

impl ChosenOutputs {
    /// Those that fit one of the `patterns`, such as `vehicle_1.force.*`.
    ///
    /// Without patterns those that are `connected`, and of a component of which none is, all.
    ///
    /// # Errors
    /// When a pattern fits no output.
    pub fn new(
        patterns: &[String],
        connected: &HashSet<Endpoint>,
        system: &System,
    ) -> Result<Self, OutputsError> {
        if patterns.is_empty() {
            return Ok(Self(Some(
                system.units().flat_map(|unit| default(unit, connected)).collect(),
            )));
        }
        let outputs: Vec<Endpoint> = system.units().flat_map(endpoints).collect();
        let fits = |pattern: &str, output: &Endpoint| matches(pattern, &output.to_string());
        let lonely = patterns.iter().find(|p| !outputs.iter().any(|output| fits(p, output)));
        if let Some(pattern) = lonely {
            return Err(no_output(pattern, &outputs));
        }
        let is_wanted = |output: &Endpoint| patterns.iter().any(|pattern| fits(pattern, output));
        Ok(Self(Some(outputs.into_iter().filter(is_wanted).collect())))
    }

    /// Whether an output of a component is recorded.
    pub fn contain(&self, component: &str, output: &str) -> bool {
        let Self(chosen) = self;
        chosen.as_ref().is_none_or(|chosen| chosen.contains(&Endpoint::new(component, output)))
    }
}

/// The outputs of a unit that are numbers and `wanted`: Real, Integer, Boolean.
pub fn numbers<'u>(unit: &'u dyn Unit, wanted: &impl Fn(&Variable) -> bool) -> Vec<&'u Variable> {
    let outputs = unit.interface().variables().into_iter().filter(|v| v.causality == "output");
    outputs.filter(|v| v.kind != VariableType::Text && wanted(v)).collect()
}

/// The outputs of a component that are numbers.
fn endpoints(unit: &dyn Unit) -> Vec<Endpoint> {
    let endpoint = |output: &Variable| Endpoint::new(unit.name(), &output.name);
    numbers(unit, &|_| true).into_iter().map(endpoint).collect()
}

/// Its connected outputs, or all.
fn default(unit: &dyn Unit, connected: &HashSet<Endpoint>) -> Vec<Endpoint> {
    let all = endpoints(unit);
    let mut of_connections = all.clone();
    of_connections.retain(|output| connected.contains(output));
    if of_connections.is_empty() { all } else { of_connections }
}

/// The error of a pattern that no output fits.
fn no_output(pattern: &str, outputs: &[Endpoint]) -> OutputsError {
    // A star at an end leaves the other part of the name.
    let names: Vec<String> = match (pattern.strip_prefix("*."), pattern.strip_suffix(".*")) {
        (Some(_), _) => outputs.iter().map(|output| format!("*.{}", output.connector)).collect(),
        (_, Some(_)) => outputs.iter().map(|output| format!("{}.*", output.element)).collect(),
        _ => outputs.iter().map(ToString::to_string).collect(),
    };
    let mut meant = did_you_mean(pattern, names.iter().map(String::as_str));
    if meant.is_empty() {
        let mut components: Vec<&str> = outputs.iter().map(|o| o.element.as_str()).collect();
        components.dedup();
        meant = format!("; there are outputs of {}", components.join(", "));
    }
    OutputsError::Pattern { pattern: pattern.to_owned(), meant }
}
