//! From a scenario to units that are ready to be initialised: FMUs are packed for the consist,
//! imported, instantiated and wired.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::files::file_error::FileError;
use crate::fmi::pack::{Binary, PackError, pack};
use crate::fmi::{FmuInstance, Import, ImportError};
use crate::scenario::Scenario;
use crate::system::port::{Port, Signal};
use crate::system::times::StepTimes;
use crate::system::unit::{Unit, UnitError};
use crate::train::lockstep::{Clock, Lockstep, Train};
use crate::train::resources::{self, Origins};
use crate::train::roles::{self, RoleSignals};

/// Why a scenario cannot be set up.
#[derive(Debug, thiserror::Error)]
pub enum PrepareError {
    /// A file or folder cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
    /// An FMU cannot be packed.
    #[error(transparent)]
    Pack(#[from] PackError),
    /// An FMU cannot be imported.
    #[error(transparent)]
    Import(#[from] ImportError),
    /// A unit refuses.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// An FMU lacks what its role needs.
    #[error("{file} cannot be used as {role}: {}", problems.join("; "))]
    Unfit {
        /// FMU.
        file: String,
        /// Role.
        role: &'static str,
        /// What is missing.
        problems: Vec<String>,
    },
    /// A model does not accept what the scenario gives it.
    #[error("{file} cannot be packed: {message}")]
    Refused {
        /// FMU that was to be packed.
        file: String,
        /// What the model says.
        message: String,
    },
    /// One of Hotfoot's own FMUs is not where it should be.
    #[error(
        "{path} is missing; build Hotfoot's FMUs with `cargo xtask fmus`, or name their folder with --fmus"
    )]
    NoFmu {
        /// Path looked at.
        path: String,
    },
    /// An FMU that allows one instance a process is wanted more than once.
    #[error(
        "{file} allows only one instance in a process (canBeInstantiatedOnlyOncePerProcess), but the train needs {count}"
    )]
    OncePerProcess {
        /// FMU.
        file: String,
        /// Instances wanted.
        count: usize,
    },
    /// A parameter of an FMU is not what the scenario takes it for.
    #[error("{key}: \"{name}\" = {value}: {problem}")]
    Parameter {
        /// The table of the scenario in which it stands.
        key: String,
        /// Its name.
        name: String,
        /// The scenario's value, as it stands there.
        value: String,
        /// What is wrong and what would be right.
        problem: String,
    },
    /// What the wheels do cannot be kept for further trains.
    #[error("{folder}: {source}; for heat.trains what the wheels do is kept on this disk")]
    Tape {
        /// Folder.
        folder: String,
        /// Reason.
        source: std::io::Error,
    },
}

/// Where FMUs come from and go to.
#[derive(Debug, Clone)]
pub struct Folders {
    /// Folder of Hotfoot's own FMUs.
    pub fmus: PathBuf,
    /// Folder of the results.
    pub results: PathBuf,
}

/// Packs, imports, instantiates and wires the units of a scenario.
///
/// # Errors
/// When an FMU is missing, damaged or unfit.
pub fn prepare(scenario: &Scenario, folders: &Folders) -> Result<Lockstep, PrepareError> {
    let builder = Builder { scenario, folders };
    let train = builder.train()?;
    let vehicles = if scenario.train_alone { vec![] } else { builder.vehicles()? };
    let rails = match &scenario.heat {
        Some(heat) => builder.rails(heat, &vehicles)?,
        None => vec![],
    };
    let clock = Clock { start: 0.0, length: scenario.step_s };
    let times = StepTimes::default();
    Ok(Lockstep { clock, scheme: scenario.scheme, train, vehicles, rails, times })
}

/// Makes units for a scenario.
pub(crate) struct Builder<'a> {
    pub(crate) scenario: &'a Scenario,
    pub(crate) folders: &'a Folders,
}

impl Builder<'_> {
    fn train(&self) -> Result<Train, PrepareError> {
        let import = match &self.scenario.fmus.longitudinal {
            Some(file) => Import::open(file)?,
            None => self.packed("longitudinal", "train", |folder| {
                resources::write_longitudinal(self.scenario, folder)
            })?,
        };
        let signals = roles::longitudinal_signals(self.scenario.vehicle_count());
        let ports = connect(&import, &signals, &BTreeMap::new(), "longitudinal")?;
        let mut unit = self.instance(&import, "train")?;
        let constants = self.set_train(unit.as_mut())?;
        Ok(Train { unit, start: ports.parameters, constants, outputs: ports.outputs })
    }

    /// Sets what the scenario says of the couplers, and gives the inputs of the wind with their values;
    /// an FMU that does not know them is refused.
    fn set_train(&self, unit: &mut dyn Unit) -> Result<Vec<(u32, f64)>, UnitError> {
        let train = &self.scenario.train;
        if let Some(couplers) = train.couplers {
            let reference = unit.reference("initial.couplers")?;
            unit.set_integers(&[reference], &[couplers as i32])?;
        }
        let Some(wind) = &train.wind else { return Ok(vec![]) };
        Ok(vec![
            (unit.reference("wind.speed")?, wind.speed_m_per_s),
            (unit.reference("wind.direction")?, wind.direction_deg.to_radians()),
        ])
    }

    pub(crate) fn instance(
        &self,
        import: &Arc<Import>,
        name: &str,
    ) -> Result<Box<dyn Unit>, PrepareError> {
        let instance = FmuInstance::new(import, name)?;
        Ok(Box::new(match self.scenario.fmus.retry_discarded_steps {
            true => instance.retrying(),
            false => instance,
        }))
    }

    /// Packs one of Hotfoot's own FMUs with the resources that `write` makes, and imports it.
    pub(crate) fn packed(
        &self,
        base: &str,
        name: &str,
        write: impl FnOnce(&Path) -> Result<Origins, PackError>,
    ) -> Result<Arc<Import>, PrepareError> {
        let base = self.folders.fmus.join(format!("{base}.fmu"));
        check_fmu(&base)?;
        let folder = self.folders.results.join("fmus");
        std::fs::create_dir_all(&folder).map_err(FileError::at(&folder))?;
        let resources = tempfile::tempdir().map_err(FileError::at(&folder))?;
        let origins = write(resources.path())?;
        let target = folder.join(format!("{name}.fmu"));
        pack(Binary::Fmu(&base), resources.path(), &target).map_err(|error| match error {
            PackError::Import(ImportError::Describe { message, .. }) => {
                let message = origins.rename(&message, resources.path());
                PrepareError::Refused { file: target.display().to_string(), message }
            }
            other => other.into(),
        })?;
        Ok(Import::open_copy(&target, origins)?)
    }
}

/// Refuses to go on without one of Hotfoot's own FMUs.
pub(crate) fn check_fmu(path: &Path) -> Result<(), PrepareError> {
    match path.exists() {
        true => Ok(()),
        false => Err(PrepareError::NoFmu { path: path.display().to_string() }),
    }
}

/// The ports of an FMU in its role.
pub(crate) struct Ports {
    pub(crate) parameters: Port,
    pub(crate) inputs: Port,
    pub(crate) outputs: Port,
}

/// Finds the signals of a role in an FMU, before anything is run; tells all that is missing.
pub(crate) fn connect(
    import: &Import,
    signals: &RoleSignals,
    names: &BTreeMap<String, String>,
    role: &'static str,
) -> Result<Ports, PrepareError> {
    let mut problems = vec![];
    let mut port = |signals: &[Signal], causality| {
        Port::connect(import.interface(), signals, causality, names).unwrap_or_else(|missing| {
            problems.extend(missing);
            Port::default()
        })
    };
    let ports = Ports {
        parameters: port(&signals.parameters, "parameter"),
        inputs: port(&signals.inputs, "input"),
        outputs: port(&signals.outputs, "output"),
    };
    match problems.is_empty() {
        true => Ok(ports),
        false => Err(PrepareError::Unfit { file: import.file().to_owned(), role, problems }),
    }
}

pub(crate) fn check_instances(import: &Import, count: usize) -> Result<(), PrepareError> {
    if import.interface().once_per_process && count > 1 {
        return Err(PrepareError::OncePerProcess { file: import.file().to_owned(), count });
    }
    Ok(())
}
