//! The elements of `SystemStructure.ssd` that we write, as XML has them.

use serde::Serialize;

use super::schedule;

#[derive(Serialize)]
#[serde(rename = "ssd:SystemStructureDescription")]
pub struct Description<'a> {
    #[serde(rename = "@version")]
    pub version: &'static str,
    #[serde(rename = "@name")]
    pub name: &'a str,
    #[serde(rename = "@generationTool")]
    pub generation_tool: &'static str,
    #[serde(rename = "ssd:System")]
    pub system: System<'a>,
    #[serde(rename = "ssd:DefaultExperiment")]
    pub experiment: Experiment<'a>,
}

#[derive(Serialize)]
pub struct System<'a> {
    #[serde(rename = "@name")]
    pub name: &'a str,
    #[serde(rename = "ssd:Elements")]
    pub elements: Elements<'a>,
    #[serde(rename = "ssd:Connections")]
    pub connections: Connections<'a>,
}

#[derive(Serialize)]
pub struct Elements<'a> {
    #[serde(rename = "ssd:Component")]
    pub components: Vec<Component<'a>>,
}

#[derive(Serialize)]
pub struct Component<'a> {
    #[serde(rename = "@name")]
    pub name: &'a str,
    #[serde(rename = "@type")]
    pub kind: &'static str,
    #[serde(rename = "@source")]
    pub source: &'a str,
    #[serde(rename = "ssd:Connectors")]
    pub connectors: Option<Connectors<'a>>,
    #[serde(rename = "ssd:ParameterBindings")]
    pub bindings: Option<Bindings<'a>>,
    #[serde(rename = "ssd:Annotations")]
    pub annotations: Option<ComponentAnnotations<'a>>,
}

#[derive(Serialize)]
pub struct ComponentAnnotations<'a> {
    #[serde(rename = "ssc:Annotation")]
    pub annotation: schedule::Annotation<'a>,
}

#[derive(Serialize)]
pub struct Connectors<'a> {
    #[serde(rename = "ssd:Connector")]
    pub connectors: Vec<Connector<'a>>,
}

#[derive(Serialize)]
pub struct Connector<'a> {
    #[serde(rename = "@name")]
    pub name: &'a str,
    #[serde(rename = "@kind")]
    pub kind: &'static str,
    #[serde(rename = "ssc:Real")]
    pub real: Empty,
}

#[derive(Serialize)]
pub struct Empty {}

#[derive(Serialize)]
pub struct Bindings<'a> {
    #[serde(rename = "ssd:ParameterBinding")]
    pub binding: Binding<'a>,
}

#[derive(Serialize)]
pub struct Binding<'a> {
    #[serde(rename = "ssd:ParameterValues")]
    pub values: ParameterValues<'a>,
}

#[derive(Serialize)]
pub struct ParameterValues<'a> {
    #[serde(rename = "ssv:ParameterSet")]
    pub set: ParameterSet<'a>,
}

#[derive(Serialize)]
pub struct ParameterSet<'a> {
    #[serde(rename = "@version")]
    pub version: &'static str,
    #[serde(rename = "@name")]
    pub name: &'static str,
    #[serde(rename = "ssv:Parameters")]
    pub parameters: Parameters<'a>,
}

#[derive(Serialize)]
pub struct Parameters<'a> {
    #[serde(rename = "ssv:Parameter")]
    pub parameters: Vec<Parameter<'a>>,
}

#[derive(Serialize)]
pub struct Parameter<'a> {
    #[serde(rename = "@name")]
    pub name: &'a str,
    #[serde(rename = "#content")]
    pub value: TypedValue<'a>,
}

#[derive(Serialize)]
pub enum TypedValue<'a> {
    #[serde(rename = "ssv:Real")]
    Real {
        #[serde(rename = "@value")]
        value: f64,
    },
    #[serde(rename = "ssv:Integer")]
    Integer {
        #[serde(rename = "@value")]
        value: i32,
    },
    #[serde(rename = "ssv:Boolean")]
    Boolean {
        #[serde(rename = "@value")]
        value: bool,
    },
    #[serde(rename = "ssv:String")]
    Text {
        #[serde(rename = "@value")]
        value: &'a str,
    },
}

#[derive(Serialize)]
pub struct Connections<'a> {
    #[serde(rename = "ssd:Connection")]
    pub connections: Vec<Connection<'a>>,
}

#[derive(Serialize)]
pub struct Connection<'a> {
    #[serde(rename = "@startElement")]
    pub start_element: &'a str,
    #[serde(rename = "@startConnector")]
    pub start_connector: &'a str,
    #[serde(rename = "@endElement")]
    pub end_element: &'a str,
    #[serde(rename = "@endConnector")]
    pub end_connector: &'a str,
    #[serde(rename = "@suppressUnitConversion")]
    pub suppress_unit_conversion: Option<bool>,
    #[serde(rename = "ssc:LinearTransformation")]
    pub transformation: Option<Transformation>,
}

#[derive(Serialize)]
pub struct Transformation {
    #[serde(rename = "@factor")]
    pub factor: f64,
    #[serde(rename = "@offset")]
    pub offset: f64,
}

#[derive(Serialize)]
pub struct Experiment<'a> {
    #[serde(rename = "@startTime")]
    pub start: f64,
    #[serde(rename = "@stopTime")]
    pub stop: Option<f64>,
    #[serde(rename = "ssd:Annotations")]
    pub annotations: Option<Annotations<'a>>,
}

#[derive(Serialize)]
pub struct Annotations<'a> {
    #[serde(rename = "ssc:Annotation")]
    pub annotations: Vec<ExperimentAnnotation<'a>>,
}

#[derive(Serialize)]
#[serde(untagged)]
pub enum ExperimentAnnotation<'a> {
    Algorithm(Annotation),
    Stages(schedule::StagesAnnotation<'a>),
}

#[derive(Serialize)]
pub struct Annotation {
    #[serde(rename = "@type")]
    pub kind: &'static str,
    #[serde(rename = "osp:Algorithm")]
    pub algorithm: Algorithm,
}

#[derive(Serialize)]
pub struct Algorithm {
    #[serde(rename = "osp:FixedStepAlgorithm")]
    pub fixed_step: FixedStep,
}

#[derive(Serialize)]
pub struct FixedStep {
    #[serde(rename = "@baseStepSize")]
    pub step: f64,
}
