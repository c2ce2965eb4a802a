//! From a scenario to units that are ready to be initialised: FMUs are packed for the consist,
//! imported, instantiated and wired.

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use controller::{Controller, Gains};

use crate::fmi::{FmuInstance, Import, ImportError};
use crate::lockstep::{Clock, Lockstep, Train, Vehicle};
use crate::pack::{Binary, PackError, pack};
use crate::port::{Port, Signal};
use crate::rail::Rail;
use crate::resources::{self, Origins};
use crate::roles::{self, RoleSignals, wheelset_count};
use crate::scenario::{Heat, Rail as RailSide, Scenario};
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
    let rail = match &scenario.heat {
        Some(heat) => Some(builder.rail(heat, &vehicles)?),
        None => None,
    };
    let clock = Clock { start: 0.0, length: scenario.step_s };
    let times = StepTimes::default();
    Ok(Lockstep { clock, scheme: scenario.scheme, train, vehicles, rail, times })
}

struct Builder<'a> {
    scenario: &'a Scenario,
    folders: &'a Folders,
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
        let unit = Box::new(FmuInstance::new(&import, "train")?);
        Ok(Train { unit, start: ports.parameters, outputs: ports.outputs })
    }

    fn vehicles(&self) -> Result<Vec<Vehicle>, PrepareError> {
        let mut of_type: HashMap<&str, Arc<Import>> = HashMap::new();
        let mut vehicles = vec![];
        let common = self.scenario.fmus.vehicle.as_deref().map(Import::open).transpose()?;
        if let Some(import) = &common {
            check_instances(import, self.scenario.vehicle_count())?;
        }
        for group in &self.scenario.train.vehicles {
            for _ in 0..group.count {
                let place = vehicles.len() + 1;
                let replacement =
                    self.scenario.fmus.vehicle_at.iter().find(|other| other.place == place);
                let import = match (replacement, &common, of_type.get(group.kind.as_str())) {
                    (Some(other), _, _) => Import::open(&other.file)?,
                    (None, Some(import), _) | (None, None, Some(import)) => Arc::clone(import),
                    (None, None, None) => {
                        let import = self.packed("vehicle", &group.kind, |folder| {
                            resources::write_vehicle(self.scenario, &group.kind, folder)
                        })?;
                        of_type.insert(&group.kind, Arc::clone(&import));
                        import
                    }
                };
                let names = match (replacement, &common) {
                    (Some(other), _) => &other.names,
                    (None, Some(_)) => &self.scenario.fmus.vehicle_names,
                    (None, None) => &BTreeMap::new(),
                };
                vehicles.push(self.vehicle(&import, place, names)?);
            }
        }
        Ok(vehicles)
    }

    fn vehicle(
        &self,
        import: &Arc<Import>,
        place: usize,
        names: &BTreeMap<String, String>,
    ) -> Result<Vehicle, PrepareError> {
        let signals = roles::vehicle_signals(wheelset_count(import.interface(), names));
        let ports = connect(import, &signals, names, "vehicle")?;
        let unit = Box::new(FmuInstance::new(import, &format!("vehicle[{place}]"))?);
        Ok(Vehicle {
            unit,
            start: ports.parameters,
            inputs: ports.inputs,
            outputs: ports.outputs,
            controller: Controller::new(Gains::from(&self.scenario.synchronisation)),
            controller_force: 0.0,
        })
    }

    fn rail(&self, heat: &Heat, vehicles: &[Vehicle]) -> Result<Rail, PrepareError> {
        let wheelsets: Vec<usize> = vehicles.iter().map(Vehicle::wheelsets).collect();
        let import = match &self.scenario.fmus.railheat {
            Some(file) => Import::open(file)?,
            None => self.packed("railheat", "rail", |folder| {
                resources::write_railheat(heat, &wheelsets, folder)
            })?,
        };
        let signals = roles::railheat_signals(&wheelsets);
        let inputs = connect(&import, &signals, &BTreeMap::new(), "railheat")?.inputs;
        let mut unit: Box<dyn Unit> = Box::new(FmuInstance::new(&import, "rail")?);
        self.set_rail_parameters(heat, unit.as_mut())?;
        let every = heat.step_s.map_or(1, |step| (step / self.scenario.step_s).round() as u64);
        let side = usize::from(heat.rail == RailSide::Right);
        Ok(Rail::new(unit, inputs, wheelsets, side, every))
    }

    /// The scenario's values for parameters that the rail's FMU has; its extent is set so that
    /// no wheel leaves it, unless the scenario says otherwise.
    fn set_rail_parameters(&self, heat: &Heat, unit: &mut dyn Unit) -> Result<(), PrepareError> {
        let extent = Extent::of(self.scenario, heat);
        let field_file = self.folders.results.join("rail.zarr");
        for (name, value) in [
            ("track.begin", extent.begin),
            ("track.length", extent.length),
            ("field_interval", heat.field_interval_s),
        ] {
            if unit.interface().variable(name).is_some() {
                unit.set_real_parameter(name, value)?;
            }
        }
        let field_file = field_file.to_string_lossy();
        for (name, value) in [("field_file", &*field_file), ("model", &heat.model)] {
            if unit.interface().variable(name).is_some() {
                unit.set_text_parameter(name, value)?;
            }
        }
        for (name, &value) in &heat.parameters {
            unit.set_real_parameter(name, value)?;
        }
        Ok(())
    }

    /// Packs one of Hotfoot's own FMUs with the resources that `write` makes, and imports it.
    fn packed(
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

/// Part of the track whose rail is modelled, m.
struct Extent {
    begin: f64,
    length: f64,
}

/// Longest vehicle that is thought of where the scenario leaves the extent of the rail open, m.
const LONGEST_VEHICLE: f64 = 30.0;
/// Largest mean acceleration that is thought of there, m/s².
const LARGEST_ACCELERATION: f64 = 0.1;

impl Extent {
    /// What the scenario says, or from behind the tail to as far as the train may come.
    fn of(scenario: &Scenario, heat: &Heat) -> Self {
        let train = &scenario.train;
        let head = train.leading_vehicle_position_m;
        let behind = scenario.vehicle_count() as f64 * LONGEST_VEHICLE;
        let duration = scenario.duration_s;
        let ahead = LONGEST_VEHICLE
            + train.speed_m_per_s * duration
            + LARGEST_ACCELERATION * duration * duration / 2.0;
        let begin = heat.begin_m.unwrap_or(head - behind);
        Self { begin, length: heat.length_m.unwrap_or(head + ahead - begin) }
    }
}

/// The ports of an FMU in its role.
struct Ports {
    parameters: Port,
    inputs: Port,
    outputs: Port,
}

/// Finds the signals of a role in an FMU, before anything is run; tells all that is missing.
fn connect(
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

fn check_instances(import: &Import, count: usize) -> Result<(), PrepareError> {
    if import.interface().once_per_process && count > 1 {
        return Err(PrepareError::OncePerProcess { file: import.file().to_owned(), count });
    }
    Ok(())
}
