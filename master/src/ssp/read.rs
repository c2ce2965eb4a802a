//! Reads `SystemStructure.ssd` of SSP 1.0: the package's structure, with nested systems made
//! flat.

use std::cmp::Ordering;
use std::collections::{HashMap, HashSet};
use std::path::Path;

use roxmltree::Node;

use super::connect::{self, Edge};
use super::error::SspError;
use super::package::Package;
use super::parameters;
use super::schedule;
use super::units::{transformation, units};
use super::values::{self, Bound};
use super::xml::{XmlFile, child, listed};
use crate::system::structure::{
    Component, Connector, ConnectorKind, Endpoint, Sampling, Structure,
};

/// Name of the default structure in a package.
pub const STRUCTURE_FILE: &str = "SystemStructure.ssd";

/// MIME type of a component that is an FMU, the default.
pub const FMU_TYPE: &str = "application/x-fmu-sharedlibrary";

/// Reads the structure in a file, such as [`STRUCTURE_FILE`], in the folder of an unpacked package.
///
/// # Errors
/// When a file is missing or not as SSP 1.0 wants it.
pub fn read(folder: &Path, file: &str) -> Result<Structure, SspError> {
    let package = Package::new(folder);
    let text = package.xml(file)?.unwrap_or_default();
    let file = XmlFile::parse(file, &text)?;
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
    let mut reader = Reader {
        file: &file,
        package: &package,
        structure,
        edges: vec![],
        taken: HashSet::new(),
        ports: HashMap::new(),
        names: HashSet::new(),
        bound: vec![],
        samplings: HashMap::new(),
    };
    reader.system(system, "")?;
    let Reader { mut structure, edges, ports, bound, samplings, .. } = reader;
    let ends = edges.iter().map(|edge| &edge.from);
    let of_components = ends.filter(|from| structure.component(&from.element).is_some());
    structure.given = of_components.cloned().collect();
    structure.connections = connect::trace(&edges, &structure)
        .map_err(|problem| SspError::Unfit { file: file.name.clone(), problems: vec![problem] })?;
    let unmatched = values::hand_on(bound, &edges, &ports, &mut structure);
    for connection in &mut structure.connections {
        if let Some(sampling) = samplings.get(&connection.to) {
            connection.sampling = *sampling;
        }
    }
    drop(file);
    structure.notes = package.into_notes();
    structure.notes.extend(unmatched);
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
    package: &'r Package<'r>,
    structure: Structure,
    edges: Vec<Edge>,
    /// The ends of connections that take a value.
    taken: HashSet<Endpoint>,
    /// The connectors of systems.
    ports: HashMap<Endpoint, Connector>,
    /// Full names of the components and of the systems inside.
    names: HashSet<String>,
    /// Start values that are bound at systems.
    bound: Vec<Bound>,
    /// What inputs get of which a slower component does not get the mean.
    samplings: HashMap<Endpoint, Sampling>,
}

impl Reader<'_, '_> {
    /// Takes in a system, whose elements get names that begin with `prefix`.
    fn system(&mut self, system: Node<'_, '_>, prefix: &str) -> Result<(), SspError> {
        let mut kinds = HashMap::new();
        let own = prefix.trim_end_matches('.');
        for connector in self.connectors(system)? {
            kinds.insert((None, connector.name.clone()), connector.kind);
            self.ports.insert(Endpoint::new(own, &connector.name), connector);
        }
        for element in child(system, "Elements").into_iter().flat_map(|list| list.children()) {
            match element.tag_name().name() {
                "" => continue,
                "Component" => self.component(element, prefix)?,
                "System" => {
                    let name = self.name(element, prefix)?;
                    self.system(element, &format!("{name}."))?;
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
            self.bound.push(Bound { system: own.to_owned(), parameter });
        }
        Ok(())
    }

    /// The full name of a component or system, which no other has.
    fn name(&mut self, element: Node<'_, '_>, prefix: &str) -> Result<String, SspError> {
        let name = format!("{prefix}{}", self.file.required(element, "name")?);
        match self.names.insert(name.clone()) {
            true => Ok(name),
            false => {
                let message = format!("there are two components with the name '{name}'");
                Err(self.file.wrong(element, message))
            }
        }
    }

    fn component(&mut self, node: Node<'_, '_>, prefix: &str) -> Result<(), SspError> {
        let kind = node.attribute("type").unwrap_or(FMU_TYPE);
        if kind != FMU_TYPE {
            let message = format!("a component of type {kind} is not supported; Hotfoot runs FMUs");
            return Err(self.file.wrong(node, message));
        }
        let name = self.name(node, prefix)?;
        let source = self.file.required(node, "source")?.to_owned();
        let (schedule, samplings) = schedule::read(self.file, node)?;
        let of_component = samplings
            .into_iter()
            .map(|(connector, sampling)| (Endpoint::new(&name, &connector), sampling));
        self.samplings.extend(of_component);
        let component = Component {
            name,
            source,
            connectors: self.connectors(node)?,
            parameters: parameters::bindings(self.file, self.package, node)?,
            schedule,
        };
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
            // OMSimulator names the system itself by an empty text.
            let element = node.attribute(element).filter(|name| !name.is_empty());
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
        if !self.taken.insert(to.clone()) {
            return Err(self.file.wrong(node, format!("'{to}' is connected already")));
        }
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
