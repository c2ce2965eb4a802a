//! `modelDescription.xml` from a model's identity and declaration (§2.2, §4.3).

use std::borrow::Cow;
use std::path::Path;

use super::elements::{
    BaseUnit, BooleanElement, CoSimulation, DefaultExperiment, IntegerElement, LogCategories,
    LogCategory, ModelStructure, ModelVariables, RealElement, Root, ScalarVariable, StringElement,
    TypeElement, UnitDefinitions, UnitElement, Unknown, Unknowns,
};
use serde::Serialize;
use serde_xml_rs::SerdeXml;
use xml::EmitterConfig;

use crate::error::Error;
use crate::instance::interface::Interface;
use crate::instance::logging::categories;
use crate::model::{Identity, Model, ModelError};
use crate::variables::{Bounds, Causality, Guid, Initial, Kind, Unit, Variability, Variable};

/// End of the experiment that a tool proposes to its user, s.
const DEFAULT_STOP_TIME: f64 = 10.0;
/// Tolerance that a tool proposes to its user.
///
/// The models step with fixed steps and do not use it, but tools miss it where it is absent.
const DEFAULT_TOLERANCE: f64 = 1e-6;

/// The text of `modelDescription.xml` of a model with the files in `resources`.
///
/// The same model and files always give the same text: no date stands in it.
///
/// # Errors
/// When the interface cannot be formed from the resources.
pub fn model_description<M: Model>(resources: &Path) -> Result<String, Error> {
    let interface = Interface::<M>::new(resources)?;
    write(&M::IDENTITY, interface.guid, interface.declaration.variables())
}

fn write(identity: &Identity, guid: Guid, variables: &[Variable]) -> Result<String, Error> {
    to_xml(&root(identity, guid, variables))
}

/// A document, indented.
pub(crate) fn to_xml(root: &impl Serialize) -> Result<String, Error> {
    let layout = EmitterConfig::new().perform_indent(true).pad_self_closing(false);
    let text = SerdeXml::new()
        .emitter(layout)
        .to_string(root)
        .map_err(|error| Error::Interface(ModelError::from_error(error)))?;
    Ok(text + "\n")
}

fn root<'a>(identity: &Identity, guid: Guid, variables: &'a [Variable]) -> Root<'a> {
    Root {
        fmi_version: "2.0",
        model_name: identity.name,
        guid: guid.to_string(),
        description: identity.description,
        author: "Hotfoot developers",
        version: env!("CARGO_PKG_VERSION"),
        copyright: "Copyright Hotfoot developers",
        license: env!("CARGO_PKG_LICENSE"),
        generation_tool: concat!("Hotfoot ", env!("CARGO_PKG_VERSION")),
        variable_naming_convention: "structured",
        number_of_event_indicators: 0,
        co_simulation: co_simulation(identity),
        unit_definitions: unit_definitions(variables),
        log_categories: log_categories(),
        default_experiment: DefaultExperiment {
            start_time: 0.0,
            stop_time: DEFAULT_STOP_TIME,
            tolerance: DEFAULT_TOLERANCE,
            step_size: identity.default_step,
        },
        model_variables: ModelVariables {
            variables: variables.iter().map(scalar_variable).collect(),
        },
        model_structure: model_structure(variables),
    }
}

/// What the FMU can do.
fn co_simulation(identity: &Identity) -> CoSimulation<'static> {
    CoSimulation {
        model_identifier: identity.identifier,
        needs_execution_tool: false,
        can_handle_variable_communication_step_size: true,
        can_interpolate_inputs: false,
        max_output_derivative_order: 0,
        can_run_asynchronuously: false,
        can_be_instantiated_only_once_per_process: false,
        // Memory is Rust's own, whatever the tool's functions are.
        can_not_use_memory_management_functions: true,
        can_get_and_set_fmu_state: true,
        can_serialize_fmu_state: true,
        provides_directional_derivative: false,
    }
}

/// Every unit that a variable has, once, in the order of first use.
fn unit_definitions(variables: &[Variable]) -> Option<UnitDefinitions<'static>> {
    let mut units: Vec<Unit> = Vec::new();
    for variable in variables {
        if let Kind::Real { unit, .. } = variable.kind
            && !units.iter().any(|known| known.symbol == unit.symbol)
        {
            units.push(unit);
        }
    }
    let units: Vec<_> = units.into_iter().map(unit_element).collect();
    (!units.is_empty()).then_some(UnitDefinitions { units })
}

fn unit_element(unit: Unit) -> UnitElement<'static> {
    let exponent = |exponent: i8| (exponent != 0).then_some(exponent);
    UnitElement {
        name: unit.symbol,
        base_unit: BaseUnit {
            kg: exponent(unit.kg),
            m: exponent(unit.m),
            s: exponent(unit.s),
            kelvin: exponent(unit.kelvin),
            rad: exponent(unit.rad),
            factor: (unit.factor != 1.0).then_some(unit.factor),
            offset: (unit.offset != 0.0).then_some(unit.offset),
        },
    }
}

fn log_categories() -> LogCategories<'static> {
    let category = |(name, description)| LogCategory { name, description };
    LogCategories { categories: categories().map(category).collect() }
}

fn scalar_variable(variable: &Variable) -> ScalarVariable<'_> {
    // What the model computes has no start value.
    let has_start = variable.initial != Some(Initial::Calculated);
    ScalarVariable {
        name: &variable.name,
        value_reference: variable.reference,
        description: description(variable),
        causality: variable.causality.name(),
        variability: variable.variability.name(),
        initial: variable.initial.map(Initial::name),
        kind: match &variable.kind {
            &Kind::Real { unit, start, bounds: Bounds { min, max, .. } } => {
                let start = has_start.then_some(start);
                TypeElement::Real(RealElement { unit: unit.symbol, min, max, start })
            }
            &Kind::Integer { start, bounds: Bounds { min, max, .. } } => {
                let start = has_start.then_some(start);
                TypeElement::Integer(IntegerElement { min, max, start })
            }
            &Kind::Boolean { start } => {
                TypeElement::Boolean(BooleanElement { start: has_start.then_some(start) })
            }
            Kind::Text { start, .. } => {
                TypeElement::String(StringElement { start: has_start.then_some(start) })
            }
        },
    }
}

/// The variable's description; it also states what the attributes `min` and `max` cannot.
fn description(variable: &Variable) -> Cow<'_, str> {
    match &variable.kind {
        Kind::Real { bounds: Bounds { above: true, .. }, .. }
        | Kind::Integer { bounds: Bounds { above: true, .. }, .. } => {
            format!("{}; {}", variable.description, variable.kind.range()).into()
        }
        _ => (&variable.description).into(),
    }
}

/// The outputs, and what the initialization computes; both count the variables from one.
///
/// No output depends on an input within a step: an empty list of dependencies says so.
fn model_structure(variables: &[Variable]) -> ModelStructure {
    let unknowns = |chosen: fn(&Variable) -> bool, dependencies| {
        let numbered = variables.iter().zip(1..);
        let unknowns: Vec<_> = numbered
            .filter(|(variable, _)| chosen(variable))
            .map(|(_, index)| Unknown { index, dependencies })
            .collect();
        (!unknowns.is_empty()).then_some(Unknowns { unknowns })
    };
    ModelStructure {
        outputs: unknowns(|variable| variable.causality == Causality::Output, Some("")),
        initial_unknowns: unknowns(|variable| variable.initial == Some(Initial::Calculated), None),
    }
}

impl Causality {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Parameter => "parameter",
            Self::Input => "input",
            Self::Output => "output",
        }
    }
}

impl Variability {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Fixed => "fixed",
            Self::Tunable => "tunable",
            Self::Discrete => "discrete",
            Self::Continuous => "continuous",
        }
    }
}

impl Initial {
    fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Calculated => "calculated",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::variables::Declaration;
    use crate::variables::unit;

    const IDENTITY: Identity = Identity {
        name: "Model",
        identifier: "model",
        description: "Cars & <bogies>",
        default_step: 1e-3,
    };

    fn description(declare: impl FnOnce(&mut Declaration)) -> String {
        let mut declaration = Declaration::default();
        declare(&mut declaration);
        let variables = declaration.variables();
        write(&IDENTITY, Guid::of("model", variables), variables).expect("it can be written")
    }

    #[test]
    fn an_output_has_no_start_value_and_stands_in_the_structure() {
        let text = description(|declaration| {
            let _ = declaration.real("force", unit::NEWTON, "Force").input(1.5);
            let _ = declaration.real("position", unit::METRE, "Place").output();
        });
        for line in [
            r#"<Real unit="N" start="1.5"/>"#,
            r#"<Real unit="m"/>"#,
            r#"<Unknown index="2" dependencies=""/>"#,
            r#"<Unknown index="2"/>"#,
        ] {
            assert!(text.lines().any(|own| own.trim() == line), "{line}\n{text}");
        }
    }

    #[test]
    fn a_unit_stands_once_with_its_exponents() {
        let text = description(|declaration| {
            let _ = declaration.real("a", unit::NEWTON, "One").input(0.0);
            let _ = declaration.real("b", unit::NEWTON, "Two").input(0.0);
        });
        assert_eq!(text.matches(r#"<Unit name="N">"#).count(), 1, "{text}");
        assert!(text.contains(r#"<BaseUnit kg="1" m="1" s="-2"/>"#), "{text}");
    }

    #[test]
    fn a_model_without_variables_has_empty_lists_and_no_units() {
        let text = description(|_| ());
        assert!(!text.contains("UnitDefinitions"), "{text}");
        assert!(text.contains("<ModelStructure/>"), "{text}");
    }

    #[test]
    fn marks_of_xml_are_escaped() {
        let text = description(|_| ());
        assert!(text.contains("Cars &amp; &lt;bogies"), "{text}");
    }
}
