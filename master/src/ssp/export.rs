//! A scenario's train as a package that other tools run without Hotfoot: the FMUs as packed for
//! the train, a controller FMU for each vehicle, and what flows between them.

use std::path::Path;

use controller::{Gains, Motion};
use miette::Diagnostic;

use super::error::{SspError, io_error};
use super::export_parameters::{constants, gains, parameters};
use super::export_wiring::{TRAIN, component_name, controller_name};
use super::read::STRUCTURE_FILE;
use super::sources::Sources;
use super::structure::{Component, Structure};
use super::write::write;
use crate::archive;
use crate::lockstep::Lockstep;
use crate::parallel;
use crate::prepare::{Folders, PrepareError, prepare};
use crate::run::default_threads;
use crate::scenario::{self, Scenario, ScenarioError, Scheme};
use crate::unit::UnitError;

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
        let train = &self.lockstep.train;
        let rails = self.lockstep.rails.iter().map(|rail| (&rail.unit, &rail.constants));
        for (unit, kept) in std::iter::once((&train.unit, &train.constants)).chain(rails) {
            let name = component_name(unit.name());
            let component = structure.components.iter_mut().find(|other| other.name == name);
            component.into_iter().for_each(|own| own.parameters.extend(constants(&**unit, kept)));
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
