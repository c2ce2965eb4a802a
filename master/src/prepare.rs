//! From a scenario to units that are ready to be initialised: FMUs are packed for the consist,
//! imported, instantiated and wired.

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use controller::{Controller, Gains};

use crate::fmi::{FmuInstance, Import, ImportError};
use crate::lockstep::{Clock, Lockstep, Train, Vehicle};
use crate::pack::{Binary, PackError, pack};
use crate::parameters::set_parameter;
use crate::port::{Port, Signal};
use crate::resources::{self, Origins};
use crate::roles::{self, RoleSignals, wheelset_count};
use crate::scenario::{Scenario, Value, VehicleReplacement};
use crate::times::StepTimes;
use crate::unit::{Unit, UnitError};

/// Why a scenario cannot be set up.
#[derive(Debug, thiserror::Error)]
pub enum PrepareError {
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
    /// A parameter of the rail's FMU is not what the scenario takes it for.
    #[error("heat.parameters: \"{name}\" = {value}: {problem}")]
    Parameter {
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

/// FMUs that replace single vehicles, by their place.
type Replacements<'a> = HashMap<usize, (&'a VehicleReplacement, Arc<Import>)>;

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
        self.set_train_parameters(unit.as_mut())?;
        Ok(Train { unit, start: ports.parameters, outputs: ports.outputs })
    }

    /// What the scenario says of couplers and wind; an FMU that does not know them is refused.
    fn set_train_parameters(&self, unit: &mut dyn Unit) -> Result<(), UnitError> {
        if let Some(couplers) = self.scenario.train.couplers {
            unit.set_integer_parameter("initial.couplers", couplers as i32)?;
        }
        if let Some(wind) = &self.scenario.train.wind {
            unit.set_real_parameter("wind.speed", wind.speed_m_per_s)?;
            unit.set_real_parameter("wind.direction", wind.direction_deg.to_radians())?;
        }
        Ok(())
    }

    fn vehicles(&self) -> Result<Vec<Vehicle>, PrepareError> {
        let mut of_type: HashMap<&str, Arc<Import>> = HashMap::new();
        let mut vehicles = vec![];
        let common = self.scenario.fmus.vehicle.as_deref().map(Import::open).transpose()?;
        let replaced = self.replacements()?;
        if let Some(import) = &common {
            check_instances(import, self.scenario.vehicle_count() - replaced.len())?;
        }
        for group in &self.scenario.train.vehicles {
            for _ in 0..group.count {
                let place = vehicles.len() + 1;
                let replacement = replaced.get(&place);
                let import = match (replacement, &common, of_type.get(group.kind.as_str())) {
                    (Some((_, import)), _, _) => Arc::clone(import),
                    (None, Some(import), _) | (None, None, Some(import)) => Arc::clone(import),
                    (None, None, None) => {
                        let import = self.packed("vehicle", &group.kind, |folder| {
                            resources::write_vehicle(self.scenario, &group.kind, folder)
                        })?;
                        of_type.insert(&group.kind, Arc::clone(&import));
                        import
                    }
                };
                let nothing = (&BTreeMap::new(), &BTreeMap::new());
                let (names, parameters) = match (replacement, &common) {
                    (Some((other, _)), _) => (&other.names, &other.parameters),
                    (None, Some(_)) => (&self.scenario.fmus.vehicle_names, nothing.1),
                    (None, None) => nothing,
                };
                vehicles.push(self.vehicle(&import, place, names, parameters)?);
            }
        }
        Ok(vehicles)
    }

    /// The FMUs for single vehicles by place; a file that stands at several is loaded once.
    fn replacements(&self) -> Result<Replacements<'_>, PrepareError> {
        let named = &self.scenario.fmus.vehicle_at;
        let mut of_file: HashMap<&Path, Arc<Import>> = HashMap::new();
        let mut replacements = HashMap::new();
        for other in named {
            let import = match of_file.get(other.file.as_path()) {
                Some(import) => Arc::clone(import),
                None => Import::open(&other.file)?,
            };
            let count = named.iter().filter(|same| same.file == other.file).count();
            check_instances(&import, count)?;
            of_file.insert(&other.file, Arc::clone(&import));
            replacements.insert(other.place, (other, import));
        }
        Ok(replacements)
    }

    fn vehicle(
        &self,
        import: &Arc<Import>,
        place: usize,
        names: &BTreeMap<String, String>,
        parameters: &BTreeMap<String, Value>,
    ) -> Result<Vehicle, PrepareError> {
        let signals = roles::vehicle_signals(wheelset_count(import.interface(), names));
        let ports = connect(import, &signals, names, "vehicle")?;
        let mut unit = self.instance(import, &format!("vehicle[{place}]"))?;
        let mut constants = vec![];
        for (name, value) in parameters {
            constants.extend(set_parameter(unit.as_mut(), import, name, value)?);
        }
        Ok(Vehicle {
            unit,
            constants,
            start: ports.parameters,
            inputs: ports.inputs,
            outputs: ports.outputs,
            controller: Controller::new(Gains::from(&self.scenario.synchronisation)),
            controller_force: 0.0,
        })
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
        if !base.exists() {
            return Err(PrepareError::NoFmu { path: base.display().to_string() });
        }
        let folder = self.folders.results.join("fmus");
        let io = |source| PackError::Io { path: folder.display().to_string(), source };
        std::fs::create_dir_all(&folder).map_err(io)?;
        let resources = tempfile::tempdir().map_err(io)?;
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
