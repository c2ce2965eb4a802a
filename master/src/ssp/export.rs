//! A scenario's train as a package that other tools run without Hotfoot: the FMUs as packed for
//! the train, a controller FMU for each vehicle, and what flows between them.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use controller::{Gains, Motion};
use miette::Diagnostic;

use super::error::{SspError, io_error};
use super::read::STRUCTURE_FILE;
use super::structure::{
    Component, Connection, Connector, ConnectorKind, Endpoint, Parameter, Structure, Value,
};
use super::write::write;
use crate::archive;
use crate::interface::{Interface, VariableType};
use crate::lockstep::Lockstep;
use crate::parallel;
use crate::port::Port;
use crate::prepare::{Folders, PrepareError, prepare};
use crate::rail::Rail;
use crate::roles::{rail_input, train, vehicle_input, vehicle_output};
use crate::run::default_threads;
use crate::scenario::{self, Scenario, ScenarioError, Scheme};
use crate::unit::{Unit, UnitError};

/// Why a scenario cannot be exported.
#[derive(Debug, thiserror::Error, Diagnostic)]
pub enum ExportError {
    /// The scenario is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Scenario(#[from] ScenarioError),
    /// The units cannot be set up.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The units cannot be initialised, which start values need.
    #[error("initialisation: {0}")]
    Start(#[from] UnitError),
    /// The package cannot be written.
    #[error(transparent)]
    Ssp(#[from] SspError),
    /// The controller's FMU is not where it should be.
    #[error(
        "{0} is missing; build Hotfoot's FMUs with `cargo xtask fmus`, or name their folder with --fmus"
    )]
    NoController(String),
    /// The system gives no threads.
    #[error("threads cannot be started: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
}

/// What an export tells.
#[derive(Debug)]
pub struct Exported {
    /// Number of components.
    pub components: usize,
    /// Number of connections.
    pub connections: usize,
    /// In what a run of the package differs from a run of the scenario.
    pub differences: Vec<&'static str>,
}

/// Name of the train's component.
const TRAIN: &str = "train";
/// File of the controller's FMU.
const CONTROLLER_FMU: &str = "synchronisation.fmu";

/// Writes the scenario at `path` as the package `target`; Hotfoot's own FMUs lie in `fmus`.
///
/// # Errors
/// When the scenario is wrong, a unit fails, or the package cannot be written.
pub fn export(path: &Path, fmus: &Path, target: &Path) -> Result<Exported, ExportError> {
    let (scenario, _, _) = scenario::load(path)?;
    let controller = fmus.join(CONTROLLER_FMU);
    if !scenario.train_alone && !controller.exists() {
        return Err(ExportError::NoController(controller.display().to_string()));
    }
    let folder = tempfile::tempdir().map_err(io_error(target))?;
    let folders = Folders { fmus: fmus.to_owned(), results: folder.path().join("results") };
    let mut lockstep = prepare(&scenario, &folders)?;
    let start = Motion {
        position: scenario.train.leading_vehicle_position_m,
        velocity: scenario.train.speed_m_per_s,
    };
    let pool = parallel::pool(default_threads())?;
    pool.install(|| lockstep.initialize(start, scenario.duration_s, scenario.duration_s))?;

    let package = folder.path().join("package");
    let mut sources = Sources::new(&package);
    let mut exporter =
        Exporter { lockstep: &mut lockstep, sources: &mut sources, folders: &folders };
    let structure = exporter.structure(&scenario, &controller)?;
    sources.copy()?;
    let file = package.join(STRUCTURE_FILE);
    std::fs::write(&file, write(&structure)?).map_err(io_error(&file))?;
    archive::pack(&package, target).map_err(SspError::from)?;
    Ok(Exported {
        components: structure.components.len(),
        connections: structure.connections.len(),
        differences: differences(&scenario),
    })
}

/// In what a run of the package differs from a run of the scenario.
fn differences(scenario: &Scenario) -> Vec<&'static str> {
    let slow_rail = scenario.heat.as_ref().and_then(|heat| heat.step_s);
    let stated = [
        (
            scenario.scheme == Scheme::Sequential,
            "the scenario's scheme is sequential; tools that run the package exchange all values \
             at once, which is scheme = \"jacobi\"",
        ),
        (
            slow_rail.is_some_and(|step| step > scenario.step_s),
            "heat.step_s: in the package the rail steps with all others",
        ),
    ];
    stated.into_iter().filter(|(differs, _)| *differs).map(|(_, sentence)| sentence).collect()
}

/// The FMU files of a package, each once.
struct Sources {
    package: PathBuf,
    /// From the file to its name in the package.
    names: BTreeMap<PathBuf, String>,
}

impl Sources {
    fn new(package: &Path) -> Self {
        Self { package: package.to_owned(), names: BTreeMap::new() }
    }

    /// Path of a file in the package.
    fn add(&mut self, file: &Path) -> String {
        if let Some(name) = self.names.get(file) {
            return name.clone();
        }
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        let name = |n: usize| match n {
            1 => format!("resources/{stem}.fmu"),
            n => format!("resources/{stem}-{n}.fmu"),
        };
        let taken = |name: &String| self.names.values().any(|other| other == name);
        let name = (1..).map(name).find(|name| !taken(name)).unwrap_or_default();
        self.names.insert(file.to_owned(), name.clone());
        name
    }

    /// Copies all files into the package.
    fn copy(&self) -> Result<(), SspError> {
        let folder = self.package.join("resources");
        std::fs::create_dir_all(&folder).map_err(io_error(&folder))?;
        for (file, name) in &self.names {
            std::fs::copy(file, self.package.join(name)).map_err(io_error(file))?;
        }
        Ok(())
    }
}

struct Exporter<'e> {
    lockstep: &'e mut Lockstep,
    sources: &'e mut Sources,
    folders: &'e Folders,
}

impl Exporter<'_> {
    fn structure(
        &mut self,
        scenario: &Scenario,
        controller: &Path,
    ) -> Result<Structure, ExportError> {
        let mut structure = Structure {
            name: TRAIN.to_owned(),
            start: Some(0.0),
            stop: Some(scenario.duration_s),
            step: Some(scenario.step_s),
            ..Structure::default()
        };
        for unit in self.lockstep.units_mut() {
            structure.components.push(Component {
                name: component_name(unit.name()),
                source: self.sources.add(Path::new(unit.source_file())),
                connectors: vec![],
                parameters: parameters(unit.as_mut(), self.folders)?,
            });
        }
        for rail in &self.lockstep.rails {
            let name = component_name(rail.unit.name());
            let component = structure.components.iter_mut().find(|other| other.name == name);
            component.into_iter().for_each(|rails| rails.parameters.extend(constants(rail)));
        }
        if !self.lockstep.vehicles.is_empty() {
            let source = self.sources.add(controller);
            let gains = gains(&Gains::from(&scenario.synchronisation));
            structure.components.extend((1..=self.lockstep.vehicles.len()).map(|place| {
                Component {
                    name: controller_name(place),
                    source: source.clone(),
                    connectors: vec![],
                    parameters: gains.clone(),
                }
            }));
        }
        for connection in self.connections() {
            structure.connect(connection);
        }
        Ok(structure)
    }

    fn connections(&self) -> Vec<Connection> {
        let mut connections = vec![];
        for place in 1..=self.lockstep.vehicles.len() {
            connections.extend(self.forces(place));
            connections.extend(self.controller(place));
        }
        for rail in &self.lockstep.rails {
            connections.extend(self.wheels(rail));
        }
        connections
    }

    /// From the train to a vehicle.
    fn forces(&self, place: usize) -> Vec<Connection> {
        let outputs = &self.lockstep.train.outputs;
        let inputs = &self.lockstep.vehicles[place - 1].inputs;
        let block = (place - 1) * train::NAMES.len();
        let pairs = [
            (train::COUPLER_FRONT, vehicle_input::COUPLER_FRONT),
            (train::COUPLER_REAR, vehicle_input::COUPLER_REAR),
            (train::RESISTANCE, vehicle_input::RESISTANCE),
            (train::TRACTION, vehicle_input::TRACTION),
            (train::BRAKE, vehicle_input::BRAKE),
        ];
        let connect = |(output, input)| {
            connection((TRAIN, outputs, block + output), (&vehicle_name(place), inputs, input))
        };
        pairs.into_iter().filter_map(connect).collect()
    }

    /// From a vehicle and its place in the train to its controller, and back to the vehicle.
    fn controller(&self, place: usize) -> Vec<Connection> {
        let vehicle = &self.lockstep.vehicles[place - 1];
        let block = (place - 1) * train::NAMES.len();
        let (name, controller) = (vehicle_name(place), controller_name(place));
        let into = |element: &str, port: &Port, at: usize, connector: &str| {
            let (variable, way) = port.variable(at)?;
            let to = endpoint(&controller, connector);
            Some(Connection::of(endpoint(element, variable), to, way))
        };
        let of_train = &self.lockstep.train.outputs;
        let force = vehicle.inputs.variable(vehicle_input::SYNCHRONISATION).map(|(input, way)| {
            let from = endpoint(&controller, "sync.force");
            Connection::of(from, endpoint(&name, input), way.inverse())
        });
        [
            into(&name, &vehicle.outputs, vehicle_output::POSITION, "vehicle.position"),
            into(&name, &vehicle.outputs, vehicle_output::VELOCITY, "vehicle.velocity"),
            into(TRAIN, of_train, block + train::POSITION, "train.position"),
            into(TRAIN, of_train, block + train::VELOCITY, "train.velocity"),
            force,
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    /// From the vehicles' wheelsets to the rail.
    fn wheels(&self, rail: &Rail) -> Vec<Connection> {
        let name = component_name(rail.unit.name());
        let mut connections = vec![];
        let mut block = 0;
        for (i, vehicle) in self.lockstep.vehicles.iter().enumerate() {
            for j in 0..vehicle.wheelsets() {
                let wheel = vehicle_output::wheel(j, rail.side);
                let of_wheel = rail_input::FROM_WHEEL.iter().map(|place| wheel + place);
                let outputs = [vehicle_output::wheelset(j), vehicle_output::VELOCITY];
                for (input, output) in outputs.into_iter().chain(of_wheel).enumerate() {
                    connections.extend(connection(
                        (&vehicle_name(i + 1), &vehicle.outputs, output),
                        (&name, &rail.inputs, block + input),
                    ));
                }
                let brake_power = i * train::NAMES.len() + train::WHEEL_BRAKE_POWER;
                connections.extend(connection(
                    (TRAIN, &self.lockstep.train.outputs, brake_power),
                    (&name, &rail.inputs, block + rail_input::BRAKE_POWER),
                ));
                block += rail_input::NAMES.len();
            }
        }
        connections
    }
}

/// Name of a unit's component: `vehicle_17` for `vehicle[17]`, as brackets are no part of an SSP
/// name.
fn component_name(unit: &str) -> String {
    unit.replace('[', "_").replace(']', "")
}

fn vehicle_name(place: usize) -> String {
    format!("vehicle_{place}")
}

fn controller_name(place: usize) -> String {
    format!("controller_{place}")
}

fn endpoint(element: &str, connector: &str) -> Endpoint {
    Endpoint { element: element.to_owned(), connector: connector.to_owned() }
}

/// A place in a port of a component.
type PortPlace<'p> = (&'p str, &'p Port, usize);

/// The connection of two places; none where a unit lacks the variable.
fn connection(output: PortPlace<'_>, input: PortPlace<'_>) -> Option<Connection> {
    let (from, from_way) = output.1.variable(output.2)?;
    let (to, to_way) = input.1.variable(input.2)?;
    let way = from_way.then(to_way.inverse());
    Some(Connection::of(endpoint(output.0, from), endpoint(input.0, to), way))
}

/// The inputs of a rail that keep a value throughout.
fn constants(rail: &Rail) -> Vec<Parameter> {
    let parameter = |&(reference, value)| {
        let name = rail.unit.interface().name_of(VariableType::Real, reference)?;
        Some(Parameter::new(name, Value::Real(value)))
    };
    rail.constants.iter().filter_map(parameter).collect()
}

fn gains(gains: &Gains) -> Vec<Parameter> {
    let real = |name: &str, value| Parameter::new(name, Value::Real(value));
    vec![
        real("gain.proportional", gains.proportional),
        real("gain.integral", gains.integral),
        real("gain.derivative", gains.derivative),
        real("force.limit", gains.limit),
    ]
}

/// The parameters of a unit that are not as its model description says, but for files in the
/// results of a run, which belong to this machine.
fn parameters(unit: &mut dyn Unit, folders: &Folders) -> Result<Vec<Parameter>, UnitError> {
    let results = folders.results.to_string_lossy().into_owned();
    let mut parameters = vec![];
    for (name, reference, kind, start) in stated_parameters(unit.interface()) {
        let value = match kind {
            VariableType::Real => {
                let mut value = [f64::NAN];
                unit.get_reals(&[reference], &mut value)?;
                Value::Real(value[0])
            }
            VariableType::Integer => {
                let mut value = [0];
                unit.get_integers(&[reference], &mut value)?;
                Value::Integer(value[0])
            }
            VariableType::Boolean => {
                let mut value = [0];
                unit.get_booleans(&[reference], &mut value)?;
                Value::Boolean(value[0] != 0)
            }
            VariableType::Text => Value::Text(unit.get_text(reference)?),
        };
        let of_results = matches!(&value, Value::Text(text) if text.starts_with(&results));
        if !of_results && Some(&value) != start.and_then(|text| parse(&text, kind)).as_ref() {
            parameters.push(Parameter::new(&name, value));
        }
    }
    Ok(parameters)
}

/// Name, value reference, type and start value of every parameter.
fn stated_parameters(interface: &Interface) -> Vec<(String, u32, VariableType, Option<String>)> {
    let parameters = interface.variables().into_iter().filter(|v| v.causality == "parameter");
    parameters.map(|v| (v.name.clone(), v.reference, v.kind, v.start.clone())).collect()
}

/// A start value as it is written.
fn parse(text: &str, kind: VariableType) -> Option<Value> {
    match kind {
        VariableType::Real => text.trim().parse().ok().map(Value::Real),
        VariableType::Integer => text.trim().parse().ok().map(Value::Integer),
        VariableType::Boolean => Some(Value::Boolean(matches!(text.trim(), "true" | "1"))),
        VariableType::Text => Some(Value::Text(text.to_owned())),
    }
}

impl Connection {
    /// A connection that is converted as `way` says and not otherwise.
    fn of(from: Endpoint, to: Endpoint, way: crate::si::Linear) -> Self {
        Self { from, to, transformation: way, convert_units: way.is_identity() }
    }
}

impl Parameter {
    fn new(name: &str, value: Value) -> Self {
        Self { name: name.to_owned(), value, unit: None, si: None }
    }
}

impl Structure {
    /// Adds a connection and the connectors at its ends.
    fn connect(&mut self, connection: Connection) {
        let ends =
            [(&connection.from, ConnectorKind::Output), (&connection.to, ConnectorKind::Input)];
        for (end, kind) in ends {
            let component = self.components.iter_mut().find(|c| c.name == end.element);
            let Some(component) = component else { continue };
            if component.connector(&end.connector).is_none() {
                let name = end.connector.clone();
                component.connectors.push(Connector { name, kind, unit: None });
            }
        }
        self.connections.push(connection);
    }
}
