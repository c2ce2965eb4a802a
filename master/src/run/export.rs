//! A scenario's train as a package: its structure, with the FMUs as packed for the train and that of
//! the controllers. Hotfoot runs the package exactly as the scenario; other tools run it without
//! Hotfoot.

use std::collections::{HashMap, HashSet};
use std::path::Path;

use files::Setting;

use super::error::RunError;
use super::scenario::placed;
use super::sources::Sources;
use crate::files::archive;
use crate::files::file_error::FileError;
use crate::interface::Interface;
use crate::scenario;
use crate::ssp::{STRUCTURE_FILE, SspError, write};
use crate::system::structure::{Connector, ConnectorKind, Endpoint, Parameter, Structure, Value};
use crate::system::substitute::Substitutes;
use crate::train::fmus::Folders;

/// What an export tells.
#[derive(Debug)]
pub struct Exported {
    /// Number of components.
    pub components: usize,
    /// Number of connections.
    pub connections: usize,
}

/// Writes the scenario at `path`, with these settings, as the package `target`.
///
/// Hotfoot's own FMUs lie in `fmus`.
///
/// # Errors
/// When the scenario is wrong, a unit fails, or the package cannot be written.
pub fn export(
    path: &Path,
    settings: &[Setting],
    fmus: &Path,
    target: &Path,
) -> Result<Exported, RunError> {
    let (scenario, file, _) = scenario::load(path, settings)?;
    let folder = tempfile::tempdir().map_err(FileError::at(target))?;
    let folders = Folders { fmus: fmus.to_owned(), results: folder.path().join("results") };
    let train = placed(&scenario, &file, &folders)?;
    // What does not fit its FMUs is told now and not by the tool that runs the package.
    train.system(&mut Substitutes::new()).map_err(RunError::prepare(&file))?;

    let package = folder.path().join("package");
    let mut sources = Sources::new(&package);
    let interfaces = train.interfaces().map_err(RunError::prepare(&file))?;
    let structure = packaged(train.structure, &interfaces, &mut sources);
    sources.copy()?;
    let file = package.join(STRUCTURE_FILE);
    std::fs::write(&file, write(&structure)?).map_err(FileError::at(&file))?;
    archive::pack(&package, target).map_err(SspError::from)?;
    Ok(Exported {
        components: structure.components.len(),
        connections: structure.connections.len(),
    })
}

/// The structure as it stands in a package: without what belongs to this machine, or what the FMUs begin
/// with anyway, with its FMUs inside, and with the connectors that are connected.
fn packaged(
    mut structure: Structure,
    interfaces: &HashMap<String, Interface>,
    sources: &mut Sources,
) -> Structure {
    for component in &mut structure.components {
        component.parameters.retain(|parameter| !parameter.local);
        if let Some(interface) = interfaces.get(&component.source) {
            leave_out_starts(&mut component.parameters, interface);
        }
        component.name = name_in_package(&component.name);
        component.source = sources.add(Path::new(&component.source));
    }
    for connection in &mut structure.connections {
        for end in [&mut connection.from, &mut connection.to] {
            end.element = name_in_package(&end.element);
        }
    }
    with_connectors(structure)
}

/// Takes out the values with which an FMU begins anyway: of the tools that run a package, FMPy's
/// `simulate_ssp` sets no texts. Of several values for a variable the last one counts.
fn leave_out_starts(parameters: &mut Vec<Parameter>, interface: &Interface) {
    let start = |name: &str| {
        let variable = interface.variable(name)?;
        Value::parse(variable.start.as_ref()?, variable.kind)
    };
    let last: HashMap<String, Value> =
        parameters.iter().map(|own| (own.name.clone(), own.value.clone())).collect();
    parameters.retain(|parameter| start(&parameter.name).as_ref() != last.get(&parameter.name));
}

/// Name of a component: `vehicle_17` for `vehicle[17]`, as brackets are no part of an SSP name.
fn name_in_package(component: &str) -> String {
    component.replace('[', "_").replace(']', "")
}

/// The structure with a connector at each end of a connection.
fn with_connectors(mut structure: Structure) -> Structure {
    let Structure { components, connections, .. } = &mut structure;
    let numbers: HashMap<String, usize> =
        components.iter().map(|component| component.name.clone()).zip(0..).collect();
    let mut known: HashSet<&Endpoint> = HashSet::new();
    for connection in connections.iter() {
        let ends =
            [(&connection.from, ConnectorKind::Output), (&connection.to, ConnectorKind::Input)];
        for (end, kind) in ends {
            if let Some(&number) = numbers.get(&end.element)
                && known.insert(end)
            {
                let name = end.connector.clone();
                components[number].connectors.push(Connector { name, kind, unit: None });
            }
        }
    }
    structure
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::si::Linear;
    use crate::interface::{Variable, VariableType};
    use crate::system::structure::{Component, Connection, Sampling};

    #[test]
    fn what_an_fmu_begins_with_is_not_stated() {
        let variable = |name: &str, kind, start: Option<&str>| Variable {
            name: name.to_owned(),
            reference: 0,
            kind,
            causality: "parameter".to_owned(),
            discrete: false,
            unit: None,
            si: None,
            range: crate::interface::range::Range::FINITE,
            start: start.map(str::to_owned),
            description: String::new(),
        };
        let interface = Interface::of([
            variable("mass", VariableType::Real, Some("1e3")),
            variable("count", VariableType::Integer, Some("2")),
            variable("worn", VariableType::Boolean, Some("false")),
            variable("model", VariableType::Text, Some("paper")),
            variable("speed", VariableType::Real, Some("0")),
            variable("free", VariableType::Real, None),
        ]);
        let text = |text: &str| Value::Text(text.to_owned());
        let stated = |mass, count, worn, model: &str, speeds: [f64; 2]| {
            let mut parameters: Vec<_> = [
                ("mass", Value::Real(mass)),
                ("count", Value::Integer(count)),
                ("worn", Value::Boolean(worn)),
                ("model", text(model)),
                ("speed", Value::Real(speeds[0])),
                ("speed", Value::Real(speeds[1])),
                ("free", Value::Real(0.0)),
            ]
            .map(|(name, value)| Parameter::new(name, value))
            .into();
            leave_out_starts(&mut parameters, &interface);
            parameters.into_iter().map(|parameter| parameter.name).collect::<Vec<_>>()
        };
        assert_eq!(stated(1000.0, 2, false, "paper", [5.0, 0.0]), ["free"]);
        let all = ["mass", "count", "worn", "model", "speed", "speed", "free"];
        assert_eq!(stated(1000.5, 3, true, "energy", [0.0, 5.0]), all);
    }

    #[test]
    fn a_package_holds_its_fmus_its_connectors_and_nothing_of_this_machine() {
        let component = |name: &str| Component {
            name: name.to_owned(),
            source: "/somewhere/wagon.fmu".to_owned(),
            parameters: vec![
                Parameter::new("mass", Value::Real(2.0)),
                Parameter { local: true, ..Parameter::new("file", Value::Text("/tmp".to_owned())) },
            ],
            ..Component::default()
        };
        let (from, to) = (Endpoint::new("vehicle[1]", "y"), Endpoint::new("vehicle[2]", "u"));
        let connection = Connection::of(from.clone(), to, Linear::IDENTITY, Sampling::Mean);
        let other = Connection::of(
            from,
            Endpoint::new("vehicle[2]", "w"),
            Linear::IDENTITY,
            Sampling::Mean,
        );
        let structure = Structure {
            components: vec![component("vehicle[1]"), component("vehicle[2]")],
            connections: vec![connection, other],
            ..Structure::default()
        };
        let packaged =
            packaged(structure, &HashMap::new(), &mut Sources::new(Path::new("package")));
        let [first, second] = packaged.components.as_slice() else { panic!("{packaged:?}") };
        assert_eq!(
            (first.name.as_str(), first.source.as_str()),
            ("vehicle_1", "resources/wagon.fmu")
        );
        assert_eq!(first.connectors.len(), 1, "an output that is connected twice");
        assert_eq!(second.connectors.len(), 2);
        assert_eq!(first.parameters, [Parameter::new("mass", Value::Real(2.0))]);
        assert_eq!(packaged.connections[0].to, Endpoint::new("vehicle_2", "u"));
    }
}
