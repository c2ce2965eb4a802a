//! Reads `SystemStructure.ssd` of SSP 1.0: the package's structure, with nested systems made
//! flat.

use std::cmp::Ordering;
use std::collections::HashMap;
use std::path::Path;

use roxmltree::Node;

use super::connect::{self, Edge};
use super::error::SspError;
use super::parameters;
use super::schedule;
use super::units::{transformation, units};
use super::xml::{XmlFile, child, listed};
use crate::files::file_error::FileError;
use crate::files::xml_text;
use crate::system::structure::{
    Component, Connector, ConnectorKind, Endpoint, Sampling, Structure,
};

/// Name of the default structure in a package.
pub const STRUCTURE_FILE: &str = "SystemStructure.ssd";

/// MIME type of a component that is an FMU, the default.
pub const FMU_TYPE: &str = "application/x-fmu-sharedlibrary";

/// Reads the structure in the folder of an unpacked package.
///
/// # Errors
/// When a file is missing or not as SSP 1.0 wants it.
pub fn read(package: &Path) -> Result<Structure, SspError> {
    let path = package.join(STRUCTURE_FILE);
    let text = xml_text::read(&path).map_err(FileError::at(&path))?;
    let file = XmlFile::parse(STRUCTURE_FILE, &text)?;
    let root = file.document.root_element();
    let system = child(root, "System")
        .ok_or_else(|| file.wrong(root, "there is no element System".to_owned()))?;
    let mut structure = Structure {
        name: file.required(root, "name")?.to_owned(),
        units: units(&file, root)?,
        ..Structure::default()
    };
    if let Some(experiment) = child(root, "DefaultExperiment") {
        structure.start = file.value(experiment, "startTime")?;
        structure.stop = file.value(experiment, "stopTime")?;
        structure.step = step(&file, experiment)?;
        structure.stages = schedule::read_stages(&file, experiment)?;
        if let Some(stop) = structure.stop
            && (stop.partial_cmp(&structure.start.unwrap_or(0.0)) != Some(Ordering::Greater)
                || stop.is_infinite())
        {
            let start = structure.start.unwrap_or(0.0);
            let message = format!("stopTime=\"{stop}\" must be after startTime=\"{start}\"");
            return Err(file.wrong(experiment, message));
        }
    }
    let mut reader =
        Reader { file: &file, package, structure, edges: vec![], samplings: HashMap::new() };
    reader.system(system, "")?;
    let Reader { mut structure, edges, samplings, .. } = reader;
    structure.connections = connect::trace(&edges, &structure);
    for connection in &mut structure.connections {
        if let Some(sampling) = samplings.get(&connection.to) {
            connection.sampling = *sampling;
        }
    }
    Ok(structure)
}

/// The step that libcosim's annotation of the experiment names; SSP 1.0 itself has nothing
/// for it.
fn step(file: &XmlFile<'_>, experiment: Node<'_, '_>) -> Result<Option<f64>, SspError> {
    let algorithm =
        experiment.descendants().find(|node| node.tag_name().name() == "FixedStepAlgorithm");
    let Some(algorithm) = algorithm else { return Ok(None) };
    match file.value(algorithm, "baseStepSize")? {
        Some(step) if !(step > 0.0 && f64::is_finite(step)) => {
            let message = format!("baseStepSize=\"{step}\" must be greater than zero");
            Err(file.wrong(algorithm, message))
        }
        step => Ok(step),
    }
}

struct Reader<'r, 't> {
    file: &'r XmlFile<'t>,
    package: &'r Path,
    structure: Structure,
    edges: Vec<Edge>,
    /// What inputs get of which a slower component does not get the mean.
    samplings: HashMap<Endpoint, Sampling>,
}

impl Reader<'_, '_> {
    /// Takes in a system, whose elements get names that begin with `prefix`.
    fn system(&mut self, system: Node<'_, '_>, prefix: &str) -> Result<(), SspError> {
        let mut kinds = HashMap::new();
        for connector in self.connectors(system)? {
            kinds.insert((None, connector.name), connector.kind);
        }
        for element in child(system, "Elements").into_iter().flat_map(|list| list.children()) {
            match element.tag_name().name() {
                "" => continue,
                "Component" => self.component(element, prefix)?,
                "System" => {
                    let name = self.file.required(element, "name")?;
                    self.system(element, &format!("{prefix}{name}."))?;
                }
                other => {
                    let message = format!(
                        "element {other} is not supported; Hotfoot runs Component and System"
                    );
                    return Err(self.file.wrong(element, message));
                }
            }
            let name = self.file.required(element, "name")?;
            for connector in self.connectors(element)? {
                kinds.insert((Some(name.to_owned()), connector.name), connector.kind);
            }
        }
        for connection in listed(system, "Connections", "Connection") {
            self.connection(connection, prefix, &kinds)?;
        }
        for parameter in parameters::bindings(self.file, self.package, system)? {
            self.parameter_of_system(parameter, prefix);
        }
        Ok(())
    }

    /// A parameter that is bound at a system belongs to the element that its name begins with.
    fn parameter_of_system(
        &mut self,
        mut parameter: crate::system::structure::Parameter,
        prefix: &str,
    ) {
        let full = format!("{prefix}{}", parameter.name);
        let of_component = self.structure.components.iter_mut().find_map(|component| {
            let variable = full.strip_prefix(&component.name)?.strip_prefix('.')?.to_owned();
            Some((component, variable))
        });
        if let Some((component, variable)) = of_component {
            parameter.name = variable;
            component.parameters.push(parameter);
        }
    }

    fn component(&mut self, node: Node<'_, '_>, prefix: &str) -> Result<(), SspError> {
        let kind = node.attribute("type").unwrap_or(FMU_TYPE);
        if kind != FMU_TYPE {
            let message = format!("a component of type {kind} is not supported; Hotfoot runs FMUs");
            return Err(self.file.wrong(node, message));
        }
        let name = format!("{prefix}{}", self.file.required(node, "name")?);
        let (schedule, samplings) = schedule::read(self.file, node)?;
        let of_component = samplings
            .into_iter()
            .map(|(connector, sampling)| (Endpoint::new(&name, &connector), sampling));
        self.samplings.extend(of_component);
        let component = Component {
            name,
            source: self.file.required(node, "source")?.to_owned(),
            connectors: self.connectors(node)?,
            parameters: parameters::bindings(self.file, self.package, node)?,
            schedule,
        };
        if self.structure.component(&component.name).is_some() {
            let message = format!("there are two components with the name '{}'", component.name);
            return Err(self.file.wrong(node, message));
        }
        self.structure.components.push(component);
        Ok(())
    }

    fn connectors(&self, element: Node<'_, '_>) -> Result<Vec<Connector>, SspError> {
        let connector = |node| {
            let kind = match self.file.required(node, "kind")? {
                "input" => ConnectorKind::Input,
                "output" => ConnectorKind::Output,
                "parameter" => ConnectorKind::Parameter,
                "calculatedParameter" => ConnectorKind::CalculatedParameter,
                other => {
                    let message = format!(
                        "kind=\"{other}\" of a connector; known are input, output, parameter and \
                         calculatedParameter"
                    );
                    return Err(self.file.wrong(node, message));
                }
            };
            Ok(Connector {
                name: self.file.required(node, "name")?.to_owned(),
                kind,
                unit: child(node, "Real")
                    .and_then(|real| real.attribute("unit"))
                    .map(str::to_owned),
            })
        };
        listed(element, "Connectors", "Connector").map(connector).collect()
    }

    fn connection(
        &mut self,
        node: Node<'_, '_>,
        prefix: &str,
        kinds: &HashMap<(Option<String>, String), ConnectorKind>,
    ) -> Result<(), SspError> {
        let end = |element: &str, connector: &str| {
            let element = node.attribute(element);
            let connector = self.file.required(node, connector)?;
            let key = (element.map(str::to_owned), connector.to_owned());
            let kind = kinds.get(&key).ok_or_else(|| {
                let of = element.map_or("the system".to_owned(), |name| format!("'{name}'"));
                self.file.wrong(node, format!("{of} has no connector '{connector}'"))
            })?;
            // A connector of the system itself gives inside what it takes outside.
            let gives = matches!(kind, ConnectorKind::Output | ConnectorKind::CalculatedParameter)
                == element.is_some();
            let element = match element {
                Some(element) => format!("{prefix}{element}"),
                None => prefix.trim_end_matches('.').to_owned(),
            };
            Ok::<_, SspError>((Endpoint { element, connector: connector.to_owned() }, gives))
        };
        let (start, start_gives) = end("startElement", "startConnector")?;
        let (stop, stop_gives) = end("endElement", "endConnector")?;
        if start_gives == stop_gives {
            let message = format!(
                "'{}' and '{}' are connected, but one must give values and the other take them",
                start.connector, stop.connector
            );
            return Err(self.file.wrong(node, message));
        }
        let (from, to) = if start_gives { (start, stop) } else { (stop, start) };
        let suppressed: Option<bool> = self.file.value(node, "suppressUnitConversion")?;
        self.edges.push(Edge {
            from,
            to,
            transformation: transformation(self.file, node)?,
            convert_units: suppressed != Some(true),
        });
        Ok(())
    }
}
