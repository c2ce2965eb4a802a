//! The interface of an FMU as its modelDescription.xml states it (FMI 2.0 §2.2).

pub mod name_pattern;
#[cfg(test)]
mod published_tests;
pub mod range;
pub mod si;
mod xml;

use std::collections::HashMap;

use crate::files::xml_depth::{TooDeep, check_depth};
use crate::interface::range::Range;
use crate::interface::si::SiUnit;

/// Type of a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
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
    /// Whether steps may differ in length.
    pub variable_step: bool,
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

/// What a name in C is, in words.
pub const C_NAME: &str = "a name in C: letters, digits and underscores, not beginning with a digit";

/// Whether a text is a name in C, as the binary of an FMU must have.
pub fn is_c_name(text: &str) -> bool {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.starts_with(|c: char| is_part(c) && !c.is_ascii_digit()) && text.chars().all(is_part)
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
        let units = Units::of(root.unit_definitions, root.type_definitions);
        let variables = root.model_variables.variables.into_iter();
        Ok(Self {
            identifier: slave.model_identifier,
            model_name: root.model_name,
            guid: root.guid,
            once_per_process: slave.once_per_process,
            can_get_and_set_state: slave.can_get_and_set_state,
            variable_step: slave.variable_step,
            variables: variables.filter_map(|scalar| variable(scalar, &units)).collect(),
            units: units.units,
        })
    }

    /// An interface of the given variables, for units that are not FMUs.
    pub fn of(variables: impl IntoIterator<Item = Variable>) -> Self {
        let variables = variables.into_iter().map(|v| (v.name.clone(), v)).collect();
        Self { variables, ..Self::default() }
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

/// The units that a model description defines, and the declared types.
struct Units {
    units: HashMap<String, SiUnit>,
    of_type: HashMap<String, xml::SimpleType>,
}

impl Units {
    fn of(units: Option<xml::UnitDefinitions>, types: Option<xml::TypeDefinitions>) -> Self {
        let units = units.map(|list| list.units).unwrap_or_default().into_iter();
        let types = types.map(|list| list.types).unwrap_or_default().into_iter();
        Self {
            units: units.filter_map(|unit| Some((unit.name, unit.base?.si()?))).collect(),
            of_type: types.map(|simple| (simple.name.clone(), simple)).collect(),
        }
    }

    /// The type that a variable declares.
    fn declared(&self, name: &Option<String>) -> Option<&xml::SimpleType> {
        self.of_type.get(name.as_ref()?)
    }

    /// Unit of a Real variable, from itself or its declared type, and what it is in SI.
    fn of_real(&self, real: &xml::Real) -> (Option<String>, Option<SiUnit>) {
        let declared = self.declared(&real.declared_type).and_then(|simple| simple.real.as_ref());
        let unit = real.unit.clone().or_else(|| declared?.unit.clone());
        let relative = real.relative || declared.is_some_and(|declared| declared.relative);
        let mut si = unit.as_ref().and_then(|name| self.units.get(name).copied());
        if let (Some(si), true) = (&mut si, relative) {
            // A difference of two values knows no offset (§2.2.2).
            si.to_base.offset = 0.0;
        }
        (unit, si)
    }

    /// What a Real may be, by itself or its declared type.
    fn range_of_real(&self, real: &xml::Real) -> Range {
        let declared = self.declared(&real.declared_type).and_then(|simple| simple.real.as_ref());
        let min = real.min.as_ref().or_else(|| declared?.min.as_ref());
        let max = real.max.as_ref().or_else(|| declared?.max.as_ref());
        Range::stated(number(min), number(max))
    }

    /// What an Integer or Enumeration may be, by itself or its declared type.
    fn range_of_integer(&self, integer: &xml::Other) -> Range {
        let declared =
            self.declared(&integer.declared_type).and_then(|simple| simple.integer.as_ref());
        let min = integer.min.as_ref().or_else(|| declared?.min.as_ref());
        let max = integer.max.as_ref().or_else(|| declared?.max.as_ref());
        Range::stated(number(min), number(max))
    }
}

/// The number that an attribute states.
fn number(text: Option<&String>) -> Option<f64> {
    text?.trim().parse().ok()
}

fn variable(scalar: xml::ScalarVariable, units: &Units) -> Option<(String, Variable)> {
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

    /// The binary of an FMU is loaded by this name, so a path must not pass.
    #[test]
    fn a_model_identifier_that_is_no_c_name_is_refused() {
        for wrong in ["/tmp/evil", "../m", "1m", "", "m.so", "m m"] {
            let xml = XML.replace("modelIdentifier=\"m\"", &format!("modelIdentifier=\"{wrong}\""));
            let error = Interface::from_xml(&xml).unwrap_err().to_string();
            assert!(error.contains(&format!("\"{wrong}\", but must be a name in C")), "{error}");
        }
    }

    /// FMI 2.0 §2.2.7: what a variable states goes before what its type does.
    #[test]
    fn ranges_are_those_of_the_variable_or_of_its_type() {
        let definitions = r#"<TypeDefinitions>
              <SimpleType name="Share"><Real min="0" max="1"/></SimpleType>
              <SimpleType name="Count"><Integer min="1"/></SimpleType></TypeDefinitions>
          <ModelVariables>
            <ScalarVariable name="share" valueReference="5"><Real declaredType="Share"/></ScalarVariable>
            <ScalarVariable name="half" valueReference="6">
              <Real declaredType="Share" max=" 0.5 "/></ScalarVariable>
            <ScalarVariable name="count" valueReference="7">
              <Integer declaredType="Count" max="9"/></ScalarVariable>"#;
        let interface = Interface::from_xml(&XML.replace("<ModelVariables>", definitions)).unwrap();
        let range = |name| interface.variable(name).unwrap().range;
        assert_eq!(range("share"), Range { min: 0.0, max: 1.0 });
        assert_eq!(range("half"), Range { min: 0.0, max: 0.5 });
        assert_eq!(range("count"), Range { min: 1.0, max: 9.0 });
        assert_eq!(range("axle[1].force"), Range::FINITE);
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
