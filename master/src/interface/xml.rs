//! The elements and attributes of a model description that are read.

use serde::Deserialize;

use crate::interface::si::{Dimension, Linear, SiUnit};

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
    #[serde(rename = "UnitDefinitions")]
    pub unit_definitions: Option<UnitDefinitions>,
    #[serde(rename = "TypeDefinitions")]
    pub type_definitions: Option<TypeDefinitions>,
    #[serde(rename = "DefaultExperiment", default)]
    pub default_experiment: DefaultExperiment,
    #[serde(rename = "ModelVariables")]
    pub model_variables: ModelVariables,
}

/// Numbers as they are written: what makes no sense is as if it were not there.
#[derive(Default, Deserialize)]
pub struct DefaultExperiment {
    #[serde(rename = "@startTime")]
    pub start: Option<String>,
    #[serde(rename = "@stopTime")]
    pub stop: Option<String>,
    #[serde(rename = "@stepSize")]
    pub step: Option<String>,
    #[serde(rename = "@tolerance")]
    pub tolerance: Option<String>,
}

#[derive(Deserialize)]
pub struct UnitDefinitions {
    #[serde(rename = "Unit", default)]
    pub units: Vec<Unit>,
}

#[derive(Deserialize)]
pub struct Unit {
    #[serde(rename = "@name")]
    pub name: String,
    #[serde(rename = "BaseUnit")]
    pub base: Option<BaseUnit>,
}

/// The attributes are the same in FMI and in SSP.
#[derive(Deserialize)]
#[serde(default)]
pub struct BaseUnit {
    #[serde(rename = "@kg")]
    kg: i32,
    #[serde(rename = "@m")]
    m: i32,
    #[serde(rename = "@s")]
    s: i32,
    #[serde(rename = "@A")]
    ampere: i32,
    #[serde(rename = "@K")]
    kelvin: i32,
    #[serde(rename = "@mol")]
    mol: i32,
    #[serde(rename = "@cd")]
    cd: i32,
    #[serde(rename = "@factor")]
    factor: f64,
    #[serde(rename = "@offset")]
    offset: f64,
}

impl Default for BaseUnit {
    fn default() -> Self {
        let (kg, m, s, ampere, kelvin, mol, cd) = Default::default();
        Self { kg, m, s, ampere, kelvin, mol, cd, factor: 1.0, offset: 0.0 }
    }
}

impl BaseUnit {
    /// The unit, unless its numbers make no sense.
    pub fn si(&self) -> Option<SiUnit> {
        let exponents = [self.kg, self.m, self.s, self.ampere, self.kelvin, self.mol, self.cd];
        let to_base = Linear { factor: self.factor, offset: self.offset };
        (to_base.factor.is_normal() && to_base.offset.is_finite())
            .then_some(SiUnit { dimension: Dimension(exponents), to_base })
    }
}

#[derive(Deserialize)]
pub struct TypeDefinitions {
    #[serde(rename = "SimpleType", default)]
    pub types: Vec<SimpleType>,
}

#[derive(Deserialize)]
pub struct SimpleType {
    #[serde(rename = "@name")]
    pub name: String,
    #[serde(rename = "Real")]
    pub real: Option<Real>,
    #[serde(rename = "Integer")]
    pub integer: Option<Other>,
}

#[derive(Deserialize)]
pub struct CoSimulation {
    #[serde(rename = "@modelIdentifier")]
    pub model_identifier: String,
    #[serde(rename = "@canBeInstantiatedOnlyOncePerProcess", default)]
    pub once_per_process: bool,
    #[serde(rename = "@canGetAndSetFMUstate", default)]
    pub can_get_and_set_state: bool,
    #[serde(rename = "@canSerializeFMUstate", default)]
    pub can_serialize_state: bool,
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
    #[serde(rename = "@variability", default)]
    pub variability: String,
    #[serde(rename = "@description", default)]
    pub description: String,
    #[serde(rename = "Real")]
    pub real: Option<Real>,
    #[serde(rename = "Integer")]
    pub integer: Option<Other>,
    #[serde(rename = "Boolean")]
    pub boolean: Option<Other>,
    #[serde(rename = "String")]
    pub text: Option<Other>,
    #[serde(rename = "Enumeration")]
    pub enumeration: Option<Other>,
}

#[derive(Deserialize)]
pub struct Real {
    #[serde(rename = "@declaredType")]
    pub declared_type: Option<String>,
    #[serde(rename = "@unit")]
    pub unit: Option<String>,
    #[serde(rename = "@relativeQuantity", default)]
    pub relative: bool,
    #[serde(rename = "@min")]
    pub min: Option<String>,
    #[serde(rename = "@max")]
    pub max: Option<String>,
    #[serde(rename = "@start")]
    pub start: Option<String>,
}

/// A variable of another type than Real.
#[derive(Deserialize)]
pub struct Other {
    #[serde(rename = "@declaredType")]
    pub declared_type: Option<String>,
    #[serde(rename = "@min")]
    pub min: Option<String>,
    #[serde(rename = "@max")]
    pub max: Option<String>,
    #[serde(rename = "@start")]
    pub start: Option<String>,
}

fn local() -> String {
    "local".to_owned()
}
