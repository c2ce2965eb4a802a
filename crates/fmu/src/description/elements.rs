//! The elements of `modelDescription.xml`, named and ordered as in the schema of §2.2 and §4.3.
//!
//! A field that is renamed to `@name` is the attribute `name`; an absent one is left out.

use std::borrow::Cow;

use serde::Serialize;

#[derive(Serialize)]
#[serde(rename = "fmiModelDescription")]
pub(super) struct Root<'a> {
    #[serde(rename = "@fmiVersion")]
    pub fmi_version: &'a str,
    #[serde(rename = "@modelName")]
    pub model_name: &'a str,
    #[serde(rename = "@guid")]
    pub guid: String,
    #[serde(rename = "@description")]
    pub description: &'a str,
    #[serde(rename = "@author")]
    pub author: &'a str,
    #[serde(rename = "@version")]
    pub version: &'a str,
    #[serde(rename = "@copyright")]
    pub copyright: &'a str,
    #[serde(rename = "@license")]
    pub license: &'a str,
    #[serde(rename = "@generationTool")]
    pub generation_tool: &'a str,
    #[serde(rename = "@variableNamingConvention")]
    pub variable_naming_convention: &'a str,
    #[serde(rename = "@numberOfEventIndicators")]
    pub number_of_event_indicators: u32,
    #[serde(rename = "CoSimulation")]
    pub co_simulation: CoSimulation<'a>,
    #[serde(rename = "UnitDefinitions")]
    pub unit_definitions: Option<UnitDefinitions<'a>>,
    #[serde(rename = "LogCategories")]
    pub log_categories: LogCategories<'a>,
    #[serde(rename = "DefaultExperiment")]
    pub default_experiment: DefaultExperiment,
    #[serde(rename = "ModelVariables")]
    pub model_variables: ModelVariables<'a>,
    #[serde(rename = "ModelStructure")]
    pub model_structure: ModelStructure,
}

#[derive(Serialize)]
pub(super) struct CoSimulation<'a> {
    #[serde(rename = "@modelIdentifier")]
    pub model_identifier: &'a str,
    #[serde(rename = "@needsExecutionTool")]
    pub needs_execution_tool: bool,
    #[serde(rename = "@canHandleVariableCommunicationStepSize")]
    pub can_handle_variable_communication_step_size: bool,
    #[serde(rename = "@canInterpolateInputs")]
    pub can_interpolate_inputs: bool,
    #[serde(rename = "@maxOutputDerivativeOrder")]
    pub max_output_derivative_order: u32,
    #[serde(rename = "@canRunAsynchronuously")]
    pub can_run_asynchronuously: bool,
    #[serde(rename = "@canBeInstantiatedOnlyOncePerProcess")]
    pub can_be_instantiated_only_once_per_process: bool,
    #[serde(rename = "@canNotUseMemoryManagementFunctions")]
    pub can_not_use_memory_management_functions: bool,
    #[serde(rename = "@canGetAndSetFMUstate")]
    pub can_get_and_set_fmu_state: bool,
    #[serde(rename = "@canSerializeFMUstate")]
    pub can_serialize_fmu_state: bool,
    #[serde(rename = "@providesDirectionalDerivative")]
    pub provides_directional_derivative: bool,
}

#[derive(Serialize)]
pub(super) struct UnitDefinitions<'a> {
    #[serde(rename = "Unit")]
    pub units: Vec<UnitElement<'a>>,
}

#[derive(Serialize)]
pub(super) struct UnitElement<'a> {
    #[serde(rename = "@name")]
    pub name: &'a str,
    #[serde(rename = "BaseUnit")]
    pub base_unit: BaseUnit,
}

#[derive(Serialize)]
pub(super) struct BaseUnit {
    #[serde(rename = "@kg")]
    pub kg: Option<i8>,
    #[serde(rename = "@m")]
    pub m: Option<i8>,
    #[serde(rename = "@s")]
    pub s: Option<i8>,
    #[serde(rename = "@K")]
    pub kelvin: Option<i8>,
    #[serde(rename = "@rad")]
    pub rad: Option<i8>,
    #[serde(rename = "@factor")]
    pub factor: Option<f64>,
    #[serde(rename = "@offset")]
    pub offset: Option<f64>,
}

#[derive(Serialize)]
pub(super) struct LogCategories<'a> {
    #[serde(rename = "Category")]
    pub categories: Vec<LogCategory<'a>>,
}

#[derive(Serialize)]
pub(super) struct LogCategory<'a> {
    #[serde(rename = "@name")]
    pub name: &'a str,
    #[serde(rename = "@description")]
    pub description: &'a str,
}

#[derive(Serialize)]
pub(super) struct DefaultExperiment {
    #[serde(rename = "@startTime")]
    pub start_time: f64,
    #[serde(rename = "@stopTime")]
    pub stop_time: f64,
    #[serde(rename = "@tolerance")]
    pub tolerance: f64,
    #[serde(rename = "@stepSize")]
    pub step_size: f64,
}

#[derive(Serialize)]
pub(super) struct ModelVariables<'a> {
    #[serde(rename = "ScalarVariable")]
    pub variables: Vec<ScalarVariable<'a>>,
}

#[derive(Serialize)]
pub(super) struct ScalarVariable<'a> {
    #[serde(rename = "@name")]
    pub name: &'a str,
    #[serde(rename = "@valueReference")]
    pub value_reference: u32,
    #[serde(rename = "@description")]
    pub description: Cow<'a, str>,
    #[serde(rename = "@causality")]
    pub causality: &'a str,
    #[serde(rename = "@variability")]
    pub variability: &'a str,
    #[serde(rename = "@initial")]
    pub initial: Option<&'a str>,
    #[serde(rename = "#content")]
    pub kind: TypeElement<'a>,
}

#[derive(Serialize)]
pub(super) enum TypeElement<'a> {
    Real(RealElement<'a>),
    Integer(IntegerElement),
    Boolean(BooleanElement),
    String(StringElement<'a>),
}

#[derive(Serialize)]
pub(super) struct RealElement<'a> {
    #[serde(rename = "@unit")]
    pub unit: &'a str,
    #[serde(rename = "@min")]
    pub min: Option<f64>,
    #[serde(rename = "@max")]
    pub max: Option<f64>,
    #[serde(rename = "@start")]
    pub start: Option<f64>,
}

#[derive(Serialize)]
pub(super) struct IntegerElement {
    #[serde(rename = "@min")]
    pub min: Option<i32>,
    #[serde(rename = "@max")]
    pub max: Option<i32>,
    #[serde(rename = "@start")]
    pub start: Option<i32>,
}

#[derive(Serialize)]
pub(super) struct BooleanElement {
    #[serde(rename = "@start")]
    pub start: Option<bool>,
}

#[derive(Serialize)]
pub(super) struct StringElement<'a> {
    #[serde(rename = "@start")]
    pub start: Option<&'a str>,
}

#[derive(Serialize)]
pub(super) struct ModelStructure {
    #[serde(rename = "Outputs")]
    pub outputs: Option<Unknowns>,
    #[serde(rename = "InitialUnknowns")]
    pub initial_unknowns: Option<Unknowns>,
}

#[derive(Clone, Serialize)]
pub(super) struct Unknowns {
    #[serde(rename = "Unknown")]
    pub unknowns: Vec<Unknown>,
}

#[derive(Clone, Serialize)]
pub(super) struct Unknown {
    #[serde(rename = "@index")]
    pub index: usize,
    #[serde(rename = "@dependencies")]
    pub dependencies: Option<&'static str>,
}
