//! The interface of an FMU as its modelDescription.xml states it (FMI 2.0 §2.2).

use std::collections::HashMap;

use serde::Deserialize;

/// Type of a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
}

/// Why a model description cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum InterfaceError {
    /// Not XML, or not of the form of FMI 2.0.
    #[error("modelDescription.xml cannot be read: {0}")]
    Syntax(#[from] serde_xml_rs::Error),
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
        let root: xml::ModelDescription = serde_xml_rs::from_str(xml)?;
        if root.fmi_version != "2.0" {
            return Err(InterfaceError::Version(root.fmi_version));
        }
        let slave = root.co_simulation.ok_or(InterfaceError::NoCoSimulation)?;
        Ok(Self {
            identifier: slave.model_identifier,
            model_name: root.model_name,
            guid: root.guid,
            once_per_process: slave.once_per_process,
            can_get_and_set_state: slave.can_get_and_set_state,
            variable_step: slave.variable_step,
            variables: root.model_variables.variables.into_iter().filter_map(variable).collect(),
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

fn variable(scalar: xml::ScalarVariable) -> Option<(String, Variable)> {
    let (kind, unit) = if let Some(real) = scalar.real {
        (VariableType::Real, real.unit)
    } else if scalar.integer.is_some() || scalar.enumeration.is_some() {
        (VariableType::Integer, None)
    } else if scalar.boolean.is_some() {
        (VariableType::Boolean, None)
    } else {
        scalar.text.as_ref()?;
        (VariableType::Text, None)
    };
    let variable = Variable {
        name: scalar.name.clone(),
        reference: scalar.value_reference,
        kind,
        causality: scalar.causality,
        unit,
        description: scalar.description,
    };
    Some((scalar.name, variable))
}

/// The elements and attributes that are read.
mod xml {
    use super::Deserialize;

    #[derive(Deserialize)]
    pub struct ModelDescription {
        #[serde(rename = "@fmiVersion")]
        pub fmi_version: String,
        #[serde(rename = "@modelName")]
        pub model_name: String,
        #[serde(rename = "@guid")]
        pub guid: String,
        #[serde(rename = "CoSimulation")]
        pub co_simulation: Option<CoSimulation>,
        #[serde(rename = "ModelVariables")]
        pub model_variables: ModelVariables,
    }

    #[derive(Deserialize)]
    pub struct CoSimulation {
        #[serde(rename = "@modelIdentifier")]
        pub model_identifier: String,
        #[serde(rename = "@canBeInstantiatedOnlyOncePerProcess", default)]
        pub once_per_process: bool,
        #[serde(rename = "@canGetAndSetFMUstate", default)]
        pub can_get_and_set_state: bool,
        #[serde(rename = "@canHandleVariableCommunicationStepSize", default)]
        pub variable_step: bool,
    }

    #[derive(Deserialize)]
    pub struct ModelVariables {
        #[serde(rename = "ScalarVariable", default)]
        pub variables: Vec<ScalarVariable>,
    }

    #[derive(Deserialize)]
    pub struct ScalarVariable {
        #[serde(rename = "@name")]
        pub name: String,
        #[serde(rename = "@valueReference")]
        pub value_reference: u32,
        #[serde(rename = "@causality", default = "local")]
        pub causality: String,
        #[serde(rename = "@description", default)]
        pub description: String,
        #[serde(rename = "Real")]
        pub real: Option<Real>,
        #[serde(rename = "Integer")]
        pub integer: Option<Empty>,
        #[serde(rename = "Boolean")]
        pub boolean: Option<Empty>,
        #[serde(rename = "String")]
        pub text: Option<Empty>,
        #[serde(rename = "Enumeration")]
        pub enumeration: Option<Empty>,
    }

    #[derive(Deserialize)]
    pub struct Real {
        #[serde(rename = "@unit")]
        pub unit: Option<String>,
    }

    #[derive(Deserialize)]
    pub struct Empty {}

    fn local() -> String {
        "local".to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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

    #[test]
    fn another_version_is_refused_by_name() {
        let xml = XML.replace("fmiVersion=\"2.0\"", "fmiVersion=\"3.0\"");
        let error = Interface::from_xml(&xml).unwrap_err().to_string();
        assert!(error.contains("FMI 3.0"), "{error}");
    }
}
