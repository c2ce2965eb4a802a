//! The interface of an FMU as its modelDescription.xml states it (FMI 2.0 §2.2).

mod experiment;
pub mod identifier;
pub mod name_pattern;
#[cfg(test)]
mod published_tests;
pub mod range;
pub mod si;
mod types;
mod xml;

use std::collections::HashMap;

pub use experiment::DefaultExperiment;
use serde::{Deserialize, Serialize};

use crate::files::xml_depth::{TooDeep, check_depth};
use crate::interface::identifier::{C_NAME, is_c_name};
use crate::interface::range::Range;
use crate::interface::si::SiUnit;
use crate::interface::types::Types;

/// Type of a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum VariableType {
    /// Real.
    Real,
    /// Integer or Enumeration.
    Integer,
    /// Boolean.
    Boolean,
    /// String.
    Text,
}

impl VariableType {
    /// Its name in model descriptions.
    pub fn fmi_name(self) -> &'static str {
        match self {
            Self::Real => "Real",
            Self::Integer => "Integer",
            Self::Boolean => "Boolean",
            Self::Text => "String",
        }
    }
}

/// A variable as far as a master needs it.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Name.
    pub name: String,
    /// Value reference.
    pub reference: u32,
    /// Type.
    pub kind: VariableType,
    /// `parameter`, `input`, `output`, `local`, …
    pub causality: String,
    /// Whether it changes in steps only; what is no Real always does.
    pub discrete: bool,
    /// Unit of a Real, where stated.
    pub unit: Option<String>,
    /// What that unit is in SI base units, where the model description traces it to them.
    pub si: Option<SiUnit>,
    /// What it may be, by itself or its declared type.
    pub range: Range,
    /// Start value as it is written, where one is stated.
    pub start: Option<String>,
    /// Description, empty where none is stated.
    pub description: String,
}

/// What modelDescription.xml says of a co-simulation FMU.
#[derive(Debug, Clone, Default)]
pub struct Interface {
    /// `modelIdentifier` of the element CoSimulation: file name of the binary.
    pub identifier: String,
    /// `modelName`.
    pub model_name: String,
    /// GUID that the binary must agree to.
    pub guid: String,
    /// Whether only one instance may live in a process.
    pub once_per_process: bool,
    /// Whether the FMU can save its state and be set back to it.
    pub can_get_and_set_state: bool,
    /// Whether a saved state can be had as bytes, for another program.
    pub can_serialize_state: bool,
    /// Whether steps may differ in length.
    pub variable_step: bool,
    /// What it proposes for a run.
    pub experiment: DefaultExperiment,
    variables: HashMap<String, Variable>,
    units: HashMap<String, SiUnit>,
}

/// Why a model description cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum InterfaceError {
    /// Not XML, or not of the form of FMI 2.0.
    #[error("modelDescription.xml cannot be read: {0}")]
    Syntax(#[from] serde_xml_rs::Error),
    /// Its elements lie too deep in each other.
    #[error("modelDescription.xml, {0}")]
    Depth(#[from] TooDeep),
    /// The binary cannot be named like this.
    #[error("modelDescription.xml: modelIdentifier is \"{0}\", but must be {C_NAME}")]
    Identifier(String),
    /// Another version of FMI.
    #[error("modelDescription.xml is of FMI {0}; Hotfoot runs FMUs of FMI 2.0")]
    Version(String),
    /// No element CoSimulation.
    #[error("the FMU has no co-simulation interface (element CoSimulation); Hotfoot cannot run it")]
    NoCoSimulation,
}

impl Interface {
    /// Reads a modelDescription.xml.
    ///
    /// # Errors
    /// When it is not a model description of an FMI 2.0 co-simulation FMU.
    pub fn from_xml(xml: &str) -> Result<Self, InterfaceError> {
        check_depth(xml)?;
        let root: xml::ModelDescription = serde_xml_rs::from_str(xml)?;
        if root.fmi_version != "2.0" {
            return Err(InterfaceError::Version(root.fmi_version));
        }
        let slave = root.co_simulation.ok_or(InterfaceError::NoCoSimulation)?;
        if !is_c_name(&slave.model_identifier) {
            return Err(InterfaceError::Identifier(slave.model_identifier));
        }
        let units = Types::of(root.unit_definitions, root.type_definitions);
        let variables = root.model_variables.variables.into_iter();
        Ok(Self {
            identifier: slave.model_identifier,
            model_name: root.model_name,
            guid: root.guid,
            once_per_process: slave.once_per_process,
            can_get_and_set_state: slave.can_get_and_set_state,
            can_serialize_state: slave.can_serialize_state,
            variable_step: slave.variable_step,
            experiment: root.default_experiment.into(),
            variables: variables.filter_map(|scalar| variable(scalar, &units)).collect(),
            units: units.units,
        })
    }

    /// An interface of the given variables, for units that are not FMUs.
    pub fn of(variables: impl IntoIterator<Item = Variable>) -> Self {
        let variables = variables.into_iter().map(|v| (v.name.clone(), v)).collect();
        Self { variables, ..Self::default() }
    }

    /// The interface with further variables.
    #[must_use]
    pub fn with(mut self, variables: impl IntoIterator<Item = Variable>) -> Self {
        self.variables.extend(variables.into_iter().map(|v| (v.name.clone(), v)));
        self
    }

    /// The variable of that name.
    pub fn variable(&self, name: &str) -> Option<&Variable> {
        self.variables.get(name)
    }

    /// What a unit of measurement is in SI base units, if the model description says so.
    pub fn unit(&self, name: &str) -> Option<SiUnit> {
        self.units.get(name).copied()
    }

    /// All variables in the order of causality and value reference.
    pub fn variables(&self) -> Vec<&Variable> {
        let mut variables: Vec<_> = self.variables.values().collect();
        variables.sort_by_key(|v| (v.causality.as_str(), v.kind as u8, v.reference));
        variables
    }

    /// The name of the variable of that type and value reference.
    pub fn name_of(&self, kind: VariableType, reference: u32) -> Option<&str> {
        let mut variables = self.variables.values();
        let found = variables.find(|v| v.kind == kind && v.reference == reference);
        found.map(|variable| variable.name.as_str())
    }

    /// The Real outputs whose names do not begin with `except`, in the order of their value
    /// references.
    pub fn real_outputs(&self, except: &str) -> Vec<&Variable> {
        let mut outputs: Vec<&Variable> = self
            .variables
            .values()
            .filter(|v| v.kind == VariableType::Real && v.causality == "output")
            .filter(|v| !v.name.starts_with(except))
            .collect();
        outputs.sort_by_key(|variable| variable.reference);
        outputs
    }

    /// How many elements an array of structures has: the largest i with a variable
    /// `prefix[i].suffix`, counted from one without gaps.
    pub fn count(&self, prefix: &str, suffix: &str) -> usize {
        (1..)
            .take_while(|i| self.variables.contains_key(&format!("{prefix}[{i}].{suffix}")))
            .count()
    }
}

fn variable(scalar: xml::ScalarVariable, units: &Types) -> Option<(String, Variable)> {
    let mut range = Range::FINITE;
    let ((unit, si), kind, start) = if let Some(real) = scalar.real {
        range = units.range_of_real(&real);
        (units.of_real(&real), VariableType::Real, real.start)
    } else if let Some(integer) = scalar.integer.or(scalar.enumeration) {
        range = units.range_of_integer(&integer);
        ((None, None), VariableType::Integer, integer.start)
    } else if let Some(boolean) = scalar.boolean {
        ((None, None), VariableType::Boolean, boolean.start)
    } else {
        ((None, None), VariableType::Text, scalar.text?.start)
    };
    let variable = Variable {
        name: scalar.name.clone(),
        reference: scalar.value_reference,
        kind,
        causality: scalar.causality,
        discrete: kind != VariableType::Real
            || !matches!(scalar.variability.as_str(), "" | "continuous"),
        unit,
        si,
        range,
        start,
        description: scalar.description,
    };
    Some((scalar.name, variable))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::si::Dimension;

    const XML: &str = r#"<?xml version="1.0"?>
        <fmiModelDescription fmiVersion="2.0" modelName="m" guid="{1}">
          <CoSimulation modelIdentifier="m" canBeInstantiatedOnlyOncePerProcess="true">
            <SourceFiles><File name="m.c"/></SourceFiles>
          </CoSimulation>
          <ModelVariables>
            <ScalarVariable name="axle[1].force" valueReference="3" causality="input">
              <Real unit="N" start="0"/></ScalarVariable>
            <ScalarVariable name="axle[2].force" valueReference="4" causality="input">
              <Real start="0"/></ScalarVariable>
            <ScalarVariable name="file" valueReference="0" causality="parameter">
              <String start=""/></ScalarVariable>
          </ModelVariables>
          <ModelStructure/>
        </fmiModelDescription>"#;

    #[test]
    fn variables_are_found_by_name_and_counted() {
        let interface = Interface::from_xml(XML).unwrap();
        assert_eq!((interface.identifier.as_str(), interface.once_per_process), ("m", true));
        assert_eq!(interface.count("axle", "force"), 2);
        let force = interface.variable("axle[1].force").unwrap();
        assert_eq!((force.reference, force.unit.as_deref()), (3, Some("N")));
        assert_eq!(interface.variable("file").unwrap().kind, VariableType::Text);
    }

    /// The definition of km/h, from a variable and from its declared type.
    #[test]
    fn analytic_units_are_traced_to_si_base_units() {
        let definitions = r#"<UnitDefinitions>
              <Unit name="km/h"><BaseUnit m="1" s="-1" factor="0.2777777777777778"/></Unit>
              <Unit name="degC"><BaseUnit K="1" offset="273.15"/></Unit>
              <Unit name="pain"/>
            </UnitDefinitions>
            <TypeDefinitions><SimpleType name="Speed"><Real unit="km/h"/></SimpleType></TypeDefinitions>
          <ModelVariables>
            <ScalarVariable name="v" valueReference="5" causality="output">
              <Real declaredType="Speed"/></ScalarVariable>
            <ScalarVariable name="rise" valueReference="6" causality="output">
              <Real unit="degC" relativeQuantity="true"/></ScalarVariable>
            <ScalarVariable name="ache" valueReference="7" causality="output">
              <Real unit="pain"/></ScalarVariable>"#;
        let interface = Interface::from_xml(&XML.replace("<ModelVariables>", definitions)).unwrap();
        let variable = |name| interface.variable(name).unwrap();
        assert_eq!(variable("v").unit.as_deref(), Some("km/h"));
        let si = variable("v").si.unwrap();
        assert_eq!(si.dimension, Dimension::mechanical(0, 1, -1));
        assert!((si.to_base.apply(36.0) - 10.0).abs() < 1e-12, "rounding of the factor");
        assert_eq!(variable("rise").si.unwrap().to_base.offset, 0.0, "a difference");
        assert_eq!((variable("ache").unit.as_deref(), variable("ache").si), (Some("pain"), None));
    }

    #[test]
    fn another_version_is_refused_by_name() {
        let xml = XML.replace("fmiVersion=\"2.0\"", "fmiVersion=\"3.0\"");
        let error = Interface::from_xml(&xml).unwrap_err().to_string();
        assert!(error.contains("FMI 3.0"), "{error}");
    }

    /// The attributes and the kinds of variables of FMI 2.0 §2.2.7 and §4.3.1.
    #[test]
    fn kinds_start_values_and_capabilities_are_read() {
        let xml = XML
            .replace("canBeInstantiatedOnlyOncePerProcess=\"true\"", "canGetAndSetFMUstate=\"true\"")
            .replace(
                "<ModelVariables>",
                r#"<ModelVariables>
                <ScalarVariable name="mode" valueReference="3" causality="parameter">
                  <Enumeration declaredType="Mode" start="2"/></ScalarVariable>
                <ScalarVariable name="on" valueReference="3" causality="input">
                  <Boolean start="true"/></ScalarVariable>
                <ScalarVariable name="height" valueReference="9" causality="output" description="Height">
                  <Real/></ScalarVariable>
                <ScalarVariable name="energy" valueReference="8" causality="output">
                  <Real/></ScalarVariable>"#,
            );
        let interface = Interface::from_xml(&xml).unwrap();
        assert!(interface.can_get_and_set_state && !interface.once_per_process);
        assert!(!interface.variable_step, "false where it is not stated");
        let kind = |name| interface.variable(name).unwrap().kind;
        assert_eq!(kind("mode"), VariableType::Integer, "an enumeration is exchanged as Integer");
        assert_eq!(kind("on"), VariableType::Boolean);
        assert_eq!(interface.variable("mode").unwrap().start.as_deref(), Some("2"));
        assert_eq!(interface.variable("height").unwrap().description, "Height");
        // A value reference means something for one kind only.
        assert_eq!(interface.name_of(VariableType::Integer, 3), Some("mode"));
        assert_eq!(interface.name_of(VariableType::Boolean, 3), Some("on"));
        assert_eq!(interface.name_of(VariableType::Real, 3), Some("axle[1].force"));
        assert_eq!(interface.name_of(VariableType::Real, 77), None);
        let names = |except| -> Vec<&str> {
            interface.real_outputs(except).iter().map(|output| output.name.as_str()).collect()
        };
        assert_eq!(names("-"), ["energy", "height"], "by value reference");
        assert_eq!(names("energy"), ["height"]);
    }

    #[test]
    fn what_is_no_co_simulation_fmu_is_refused_in_words() {
        let exchange = XML.replace("CoSimulation modelIdentifier", "ModelExchange modelIdentifier");
        let exchange = exchange.replace("</CoSimulation>", "</ModelExchange>");
        let error = Interface::from_xml(&exchange).unwrap_err().to_string();
        assert!(error.contains("no co-simulation interface"), "{error}");
        let error = Interface::from_xml("<html>").unwrap_err().to_string();
        assert!(error.contains("modelDescription.xml cannot be read"), "{error}");
    }
}
