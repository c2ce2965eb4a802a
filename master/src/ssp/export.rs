//! A scenario's train as a package that other tools run without Hotfoot: the FMUs as packed for
//! the train, a controller FMU for each vehicle, and what flows between them.

use std::path::Path;

use controller::Gains;

use super::error::SspError;
use super::export_parameters::{constants, gains, parameters};
use super::export_wiring::{TRAIN, component_name, controller_name};
use super::read::STRUCTURE_FILE;
use super::sources::Sources;
use super::write::write;
use crate::files::archive;
use crate::files::file_error::FileError;
use crate::run::error::RunError;
use crate::scenario::{self, Scenario, Scheme};
use crate::system::parallel::{default_threads, pool};
use crate::system::structure::{Component, Structure};
use crate::train::lockstep::Lockstep;
use crate::train::prepare::{Folders, check_fmu, prepare};
use crate::train::start::{StartError, start_of};

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

/// File of the controller's FMU.
const CONTROLLER_FMU: &str = "synchronisation.fmu";

/// Writes the scenario at `path` as the package `target`; Hotfoot's own FMUs lie in `fmus`.
///
/// # Errors
/// When the scenario is wrong, a unit fails, or the package cannot be written.
pub fn export(path: &Path, fmus: &Path, target: &Path) -> Result<Exported, RunError> {
    let (scenario, file, _) = scenario::load(path)?;
    let controller = fmus.join(CONTROLLER_FMU);
    if !scenario.train_alone {
        check_fmu(&controller).map_err(RunError::prepare(&file))?;
    }
    let folder = tempfile::tempdir().map_err(FileError::at(target))?;
    let folders = Folders { fmus: fmus.to_owned(), results: folder.path().join("results") };
    let mut lockstep = prepare(&scenario, &folders).map_err(RunError::prepare(&file))?;
    let (start, stop) = (start_of(&scenario), scenario.duration_s);
    let started = pool(default_threads())?.install(|| lockstep.initialize(start, stop, stop));
    started.map_err(StartError::from)?;

    let package = folder.path().join("package");
    let mut sources = Sources::new(&package);
    let mut exporter =
        Exporter { lockstep: &mut lockstep, sources: &mut sources, folders: &folders };
    let structure = exporter.structure(&scenario, &controller)?;
    sources.copy()?;
    let file = package.join(STRUCTURE_FILE);
    std::fs::write(&file, write(&structure)?).map_err(FileError::at(&file))?;
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

struct Exporter<'e> {
    lockstep: &'e mut Lockstep,
    sources: &'e mut Sources,
    folders: &'e Folders,
}

impl Exporter<'_> {
    fn structure(&mut self, scenario: &Scenario, controller: &Path) -> Result<Structure, SspError> {
        let mut structure = Structure {
            name: TRAIN.to_owned(),
            start: Some(0.0),
            stop: Some(scenario.duration_s),
            step: Some(scenario.step_s),
            ..Structure::default()
        };
        for (unit, kept) in self.lockstep.units_with_constants() {
            let mut parameters = parameters(unit.as_mut(), self.folders)?;
            parameters.extend(constants(unit.as_ref(), kept));
            structure.components.push(Component {
                name: component_name(unit.name()),
                source: self.sources.add(Path::new(unit.source_file())),
                connectors: vec![],
                parameters,
            });
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
        for connection in self.lockstep.connections() {
            structure.connect(connection);
        }
        Ok(structure)
    }
}
