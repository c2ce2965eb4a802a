//! The units of a train's vehicles: which FMU stands at which place, and what the scenario says of
//! it.

use std::collections::{BTreeMap, HashMap};
use std::path::Path;
use std::sync::Arc;

use controller::{Controller, Gains};

use crate::fmi::Import;
use crate::train::lockstep::Vehicle;
use crate::train::parameters::set_parameter;
use crate::train::prepare::{Builder, PrepareError, check_instances, connect};
use crate::train::resources;
use crate::train::roles::{self, wheelset_count};

/// The names of an FMU that has ours.
static OUR_NAMES: BTreeMap<String, String> = BTreeMap::new();

/// An FMU for vehicles.
struct VehicleFmu<'s> {
    import: Arc<Import>,
    /// Its names for our signals, where they differ.
    names: &'s BTreeMap<String, String>,
}

impl Builder<'_> {
    /// A unit for each vehicle: at each place the FMU that the scenario names for it, else the one
    /// that it names for all, else ours for the vehicle's type.
    pub(crate) fn vehicles(&self) -> Result<Vec<Vehicle>, PrepareError> {
        let replacements = self.replacements()?;
        let common = self.common(self.scenario.vehicle_count() - replacements.len())?;
        let mut of_type: HashMap<&str, VehicleFmu<'_>> = HashMap::new();
        let groups = self.scenario.train.vehicles.iter();
        let kinds = groups.flat_map(|group| std::iter::repeat_n(group.kind.as_str(), group.count));
        let mut vehicles = vec![];
        for (place, kind) in (1..).zip(kinds) {
            let stated = replacements.get(&place).or(common.as_ref());
            if stated.is_none() && !of_type.contains_key(kind) {
                of_type.insert(kind, self.of_type(kind)?);
            }
            vehicles.push(self.vehicle(place, stated.unwrap_or_else(|| &of_type[kind]))?);
        }
        Ok(vehicles)
    }

    /// The FMUs for single vehicles by place; a file that stands at several is loaded once.
    fn replacements(&self) -> Result<HashMap<usize, VehicleFmu<'_>>, PrepareError> {
        let stated = &self.scenario.fmus.vehicle_at;
        let mut of_file: HashMap<&Path, Arc<Import>> = HashMap::new();
        let mut replacements = HashMap::new();
        for other in stated {
            let Some(file) = &other.file else { continue };
            let import = match of_file.get(file.as_path()) {
                Some(import) => Arc::clone(import),
                None => Import::open(file)?,
            };
            let count = stated.iter().filter(|same| same.file == other.file).count();
            check_instances(&import, count)?;
            of_file.insert(file, Arc::clone(&import));
            replacements.insert(other.place, VehicleFmu { import, names: &other.names });
        }
        Ok(replacements)
    }

    /// The FMU that the scenario names for all vehicles, of which there will be `count`.
    fn common(&self, count: usize) -> Result<Option<VehicleFmu<'_>>, PrepareError> {
        let fmus = &self.scenario.fmus;
        let Some(file) = &fmus.vehicle else { return Ok(None) };
        let import = Import::open(file)?;
        check_instances(&import, count)?;
        Ok(Some(VehicleFmu { import, names: &fmus.vehicle_names }))
    }

    /// Our FMU, packed for a type of vehicle.
    fn of_type(&self, kind: &str) -> Result<VehicleFmu<'static>, PrepareError> {
        let import = self.packed("vehicle", kind, |folder| {
            resources::write_vehicle(self.scenario, kind, folder)
        })?;
        Ok(VehicleFmu { import, names: &OUR_NAMES })
    }

    fn vehicle(&self, place: usize, fmu: &VehicleFmu<'_>) -> Result<Vehicle, PrepareError> {
        let VehicleFmu { import, names } = fmu;
        let signals = roles::vehicle_signals(wheelset_count(import.interface(), names));
        let ports = connect(import, &signals, names, "vehicle")?;
        let mut unit = self.instance(import, &format!("vehicle[{place}]"))?;
        let mut constants = vec![];
        let stated = self.scenario.fmus.vehicle_at.iter().enumerate();
        for (i, other) in stated.filter(|(_, other)| other.place == place) {
            let key = format!("fmus.vehicle_at[{i}].parameters");
            for (name, value) in &other.parameters {
                constants.extend(set_parameter(unit.as_mut(), import, &key, (name, value))?);
            }
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
}
