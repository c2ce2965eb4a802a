//! Writes `SystemStructure.ssd` in the part of SSP 1.0 that libcosim, ecos, OMSimulator and
//! FMPy all accept: no connectors of the system, only connectors that are connected, the type
//! of a component written out, and start values inline (issues 751 and 759 of OMSimulator).

use std::collections::HashMap;

use serde_xml_rs::SerdeXml;
use xml::EmitterConfig;

use super::elements::{
    Algorithm, Annotation, Annotations, Binding, Bindings, Component, ComponentAnnotations,
    Connection, Connections, Connector, Connectors, Description, Elements, Empty, Experiment,
    ExperimentAnnotation, FixedStep, Parameter, ParameterSet, ParameterValues, Parameters, System,
    Transformation, TypedValue,
};
use super::error::SspError;
use super::package::OSP_NAMESPACE;
use super::read::FMU_TYPE;
use super::schedule::{self, StagesAnnotation};
use crate::system::structure::{ConnectorKind, Endpoint, Sampling, Structure, Value};

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
        .namespace("osp", OSP_NAMESPACE)
        .namespace("hotfoot", schedule::NAMESPACE)
        .to_string(&Description::of(structure))?;
    Ok(text + "\n")
}

impl<'a> Description<'a> {
    fn of(structure: &'a Structure) -> Self {
        let algorithm = |step| {
            ExperimentAnnotation::Algorithm(Annotation {
                kind: "com.opensimulationplatform",
                algorithm: Algorithm { fixed_step: FixedStep { step } },
            })
        };
        let stages = StagesAnnotation::of(structure).map(ExperimentAnnotation::Stages);
        let annotations: Vec<_> = structure.step.map(algorithm).into_iter().chain(stages).collect();
        let mut samplings: HashMap<&str, Vec<(&str, Sampling)>> = HashMap::new();
        for connection in &structure.connections {
            let Endpoint { element, connector } = &connection.to;
            samplings.entry(element).or_default().push((connector, connection.sampling));
        }
        let component = |component: &'a crate::system::structure::Component| {
            let samplings = samplings.get(component.name.as_str());
            Component::of(component, samplings.map_or(&[], Vec::as_slice))
        };
        Self {
            version: "1.0",
            name: &structure.name,
            generation_tool: concat!("Hotfoot ", env!("CARGO_PKG_VERSION")),
            system: System {
                name: &structure.name,
                elements: Elements {
                    components: structure.components.iter().map(component).collect(),
                },
                connections: Connections {
                    connections: structure.connections.iter().map(Connection::of).collect(),
                },
            },
            experiment: Experiment {
                start: structure.start.unwrap_or(0.0),
                stop: structure.stop,
                annotations: (!annotations.is_empty()).then_some(Annotations { annotations }),
            },
        }
    }
}

impl<'a> Component<'a> {
    fn of(
        component: &'a crate::system::structure::Component,
        samplings: &[(&'a str, Sampling)],
    ) -> Self {
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
            annotations: schedule::Annotation::of(component.schedule, samplings)
                .map(|annotation| ComponentAnnotations { annotation }),
        }
    }
}

impl<'a> Connector<'a> {
    fn of(connector: &'a crate::system::structure::Connector) -> Self {
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
    fn of(parameter: &'a crate::system::structure::Parameter) -> Self {
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
    fn of(connection: &'a crate::system::structure::Connection) -> Self {
        let transformation = connection.transformation;
        Self {
            suppress_unit_conversion: (!connection.convert_units).then_some(true),
            transformation: (!transformation.is_identity()).then_some(Transformation {
                factor: transformation.factor,
                offset: transformation.offset,
            }),
            start_element: &connection.from.element,
            start_connector: &connection.from.connector,
            end_element: &connection.to.element,
            end_connector: &connection.to.connector,
        }
    }
}
