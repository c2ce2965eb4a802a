//! Writes `SystemStructure.ssd` in the part of SSP 1.0 that libcosim, ecos, OMSimulator and
//! FMPy all accept: no connectors of the system, only connectors that are connected, the type
//! of a component written out, and start values inline (issues 751 and 759 of OMSimulator).

use serde::Serialize;
use serde_xml_rs::SerdeXml;
use xml::EmitterConfig;

use super::error::SspError;
use super::read::FMU_TYPE;
use super::structure::{ConnectorKind, Structure, Value};

/// The text of the file.
///
/// # Errors
/// Never in practice: the structure holds what XML can hold.
pub fn write(structure: &Structure) -> Result<String, SspError> {
    let namespace = |part: &str| format!("http://ssp-standard.org/SSP1/SystemStructure{part}");
    let text = SerdeXml::new()
        .emitter(EmitterConfig::new().perform_indent(true).pad_self_closing(false))
        .namespace("ssd", namespace("Description").as_str())
        .namespace("ssc", namespace("Common").as_str())
        .namespace("ssv", namespace("ParameterValues").as_str())
        .namespace("osp", "http://opensimulationplatform.com/SSP/OSPAnnotations")
        .to_string(&Description::of(structure))?;
    Ok(text + "\n")
}

#[derive(Serialize)]
#[serde(rename = "ssd:SystemStructureDescription")]
struct Description<'a> {
    #[serde(rename = "@version")]
    version: &'static str,
    #[serde(rename = "@name")]
    name: &'a str,
    #[serde(rename = "@generationTool")]
    generation_tool: &'static str,
    #[serde(rename = "ssd:System")]
    system: System<'a>,
    #[serde(rename = "ssd:DefaultExperiment")]
    experiment: Experiment,
}

#[derive(Serialize)]
struct System<'a> {
    #[serde(rename = "@name")]
    name: &'a str,
    #[serde(rename = "ssd:Elements")]
    elements: Elements<'a>,
    #[serde(rename = "ssd:Connections")]
    connections: Connections<'a>,
}

#[derive(Serialize)]
struct Elements<'a> {
    #[serde(rename = "ssd:Component")]
    components: Vec<Component<'a>>,
}

#[derive(Serialize)]
struct Component<'a> {
    #[serde(rename = "@name")]
    name: &'a str,
    #[serde(rename = "@type")]
    kind: &'static str,
    #[serde(rename = "@source")]
    source: &'a str,
    #[serde(rename = "ssd:Connectors")]
    connectors: Option<Connectors<'a>>,
    #[serde(rename = "ssd:ParameterBindings")]
    bindings: Option<Bindings<'a>>,
}

#[derive(Serialize)]
struct Connectors<'a> {
    #[serde(rename = "ssd:Connector")]
    connectors: Vec<Connector<'a>>,
}

#[derive(Serialize)]
struct Connector<'a> {
    #[serde(rename = "@name")]
    name: &'a str,
    #[serde(rename = "@kind")]
    kind: &'static str,
    #[serde(rename = "ssc:Real")]
    real: Empty,
}

#[derive(Serialize)]
struct Empty {}

#[derive(Serialize)]
struct Bindings<'a> {
    #[serde(rename = "ssd:ParameterBinding")]
    binding: Binding<'a>,
}

#[derive(Serialize)]
struct Binding<'a> {
    #[serde(rename = "ssd:ParameterValues")]
    values: ParameterValues<'a>,
}

#[derive(Serialize)]
struct ParameterValues<'a> {
    #[serde(rename = "ssv:ParameterSet")]
    set: ParameterSet<'a>,
}

#[derive(Serialize)]
struct ParameterSet<'a> {
    #[serde(rename = "@version")]
    version: &'static str,
    #[serde(rename = "@name")]
    name: &'static str,
    #[serde(rename = "ssv:Parameters")]
    parameters: Parameters<'a>,
}

#[derive(Serialize)]
struct Parameters<'a> {
    #[serde(rename = "ssv:Parameter")]
    parameters: Vec<Parameter<'a>>,
}

#[derive(Serialize)]
struct Parameter<'a> {
    #[serde(rename = "@name")]
    name: &'a str,
    #[serde(rename = "#content")]
    value: TypedValue<'a>,
}

#[derive(Serialize)]
enum TypedValue<'a> {
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
struct Connections<'a> {
    #[serde(rename = "ssd:Connection")]
    connections: Vec<Connection<'a>>,
}

#[derive(Serialize)]
struct Connection<'a> {
    #[serde(rename = "@startElement")]
    start_element: &'a str,
    #[serde(rename = "@startConnector")]
    start_connector: &'a str,
    #[serde(rename = "@endElement")]
    end_element: &'a str,
    #[serde(rename = "@endConnector")]
    end_connector: &'a str,
    #[serde(rename = "@suppressUnitConversion")]
    suppress_unit_conversion: Option<bool>,
    #[serde(rename = "ssc:LinearTransformation")]
    transformation: Option<Transformation>,
}

#[derive(Serialize)]
struct Transformation {
    #[serde(rename = "@factor")]
    factor: f64,
    #[serde(rename = "@offset")]
    offset: f64,
}

#[derive(Serialize)]
struct Experiment {
    #[serde(rename = "@startTime")]
    start: f64,
    #[serde(rename = "@stopTime")]
    stop: Option<f64>,
    #[serde(rename = "ssd:Annotations")]
    annotations: Option<Annotations>,
}

#[derive(Serialize)]
struct Annotations {
    #[serde(rename = "ssc:Annotation")]
    annotation: Annotation,
}

#[derive(Serialize)]
struct Annotation {
    #[serde(rename = "@type")]
    kind: &'static str,
    #[serde(rename = "osp:Algorithm")]
    algorithm: Algorithm,
}

#[derive(Serialize)]
struct Algorithm {
    #[serde(rename = "osp:FixedStepAlgorithm")]
    fixed_step: FixedStep,
}

#[derive(Serialize)]
struct FixedStep {
    #[serde(rename = "@baseStepSize")]
    step: f64,
}

impl<'a> Description<'a> {
    fn of(structure: &'a Structure) -> Self {
        let annotation = |step| Annotation {
            kind: "com.opensimulationplatform",
            algorithm: Algorithm { fixed_step: FixedStep { step } },
        };
        Self {
            version: "1.0",
            name: &structure.name,
            generation_tool: concat!("Hotfoot ", env!("CARGO_PKG_VERSION")),
            system: System {
                name: &structure.name,
                elements: Elements {
                    components: structure.components.iter().map(Component::of).collect(),
                },
                connections: Connections {
                    connections: structure.connections.iter().map(Connection::of).collect(),
                },
            },
            experiment: Experiment {
                start: structure.start.unwrap_or(0.0),
                stop: structure.stop,
                annotations: structure
                    .step
                    .map(|step| Annotations { annotation: annotation(step) }),
            },
        }
    }
}

impl<'a> Component<'a> {
    fn of(component: &'a super::structure::Component) -> Self {
        let connectors: Vec<_> = component.connectors.iter().map(Connector::of).collect();
        let parameters: Vec<_> = component.parameters.iter().map(Parameter::of).collect();
        let set = |parameters| ParameterSet {
            version: "1.0",
            name: "start",
            parameters: Parameters { parameters },
        };
        Self {
            name: &component.name,
            kind: FMU_TYPE,
            source: &component.source,
            connectors: (!connectors.is_empty()).then_some(Connectors { connectors }),
            bindings: (!parameters.is_empty()).then(|| Bindings {
                binding: Binding { values: ParameterValues { set: set(parameters) } },
            }),
        }
    }
}

impl<'a> Connector<'a> {
    fn of(connector: &'a super::structure::Connector) -> Self {
        let kind = match connector.kind {
            ConnectorKind::Input => "input",
            ConnectorKind::Output => "output",
            ConnectorKind::Parameter => "parameter",
            ConnectorKind::CalculatedParameter => "calculatedParameter",
        };
        Self { name: &connector.name, kind, real: Empty {} }
    }
}

impl<'a> Parameter<'a> {
    fn of(parameter: &'a super::structure::Parameter) -> Self {
        let value = match &parameter.value {
            &Value::Real(value) => TypedValue::Real { value },
            &Value::Integer(value) => TypedValue::Integer { value },
            &Value::Boolean(value) => TypedValue::Boolean { value },
            Value::Text(value) => TypedValue::Text { value },
        };
        Self { name: &parameter.name, value }
    }
}

impl<'a> Connection<'a> {
    fn of(connection: &'a super::structure::Connection) -> Self {
        let way = connection.transformation;
        Self {
            suppress_unit_conversion: (!connection.convert_units).then_some(true),
            transformation: (!way.is_identity())
                .then_some(Transformation { factor: way.factor, offset: way.offset }),
            start_element: &connection.from.element,
            start_connector: &connection.from.connector,
            end_element: &connection.to.element,
            end_connector: &connection.to.connector,
        }
    }
}
