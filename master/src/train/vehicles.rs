//! The components of a train's vehicles: which FMU stands at which number, and what the scenario
//! says of it.

use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

use super::error::PrepareError;
use super::parameters::parameter;
use super::resources;
use super::roles::Names;
use super::structure::Builder;
use crate::fmi::{Import, Origins};
use crate::scenario::OnFailure;
use crate::system::structure::Home;

/// The names of an FMU that has ours.
static OUR_NAMES: Names = Names::new();

/// An FMU for vehicles.
struct VehicleFmu<'s> {
    import: Arc<Import>,
    /// Its names for our variables, where they differ.
    names: &'s Names,
}

impl<'a> Builder<'a> {
    /// A component for each vehicle: the FMU that the scenario names for its number, else the one
    /// that it names for all, else ours for the vehicle's type.
    pub(super) fn vehicles(&mut self) -> Result<(), PrepareError> {
        let scenario = self.scenario;
        let replacements = self.replacements()?;
        let common = self.common()?;
        let mut of_type: HashMap<&str, VehicleFmu<'_>> = HashMap::new();
        let groups = scenario.train.vehicles.iter();
        let kinds = groups.flat_map(|group| std::iter::repeat_n(group.kind.as_str(), group.count));
        for (number, kind) in (1..).zip(kinds) {
            let stated = replacements.get(&number).or(common.as_ref());
            if stated.is_none() && !of_type.contains_key(kind) {
                of_type.insert(kind, self.of_type(kind)?);
            }
            let of_all = stated.map_or(Home::AnyThread, |_| scenario.fmus.home());
            let (mut home, mut follows) = (of_all, scenario.fmus.on_failure.follows());
            let VehicleFmu { import, names } = stated.unwrap_or_else(|| &of_type[kind]);
            let mut parameters = vec![];
            let stated = scenario.fmus.vehicle_at.iter().enumerate();
            for (i, other) in stated.filter(|(_, other)| other.vehicle == number) {
                home = home.max(other.home());
                follows = other.on_failure.map_or(follows, OnFailure::follows);
                let check = scenario.check();
                let check = check.element("fmus.vehicle_at", i).section("parameters");
                for (name, value) in &other.parameters {
                    parameters.push(parameter(import, &check, name, value)?);
                }
            }
            self.vehicle(import, names, parameters, (home, follows))?;
        }
        Ok(())
    }

    /// The FMUs for single vehicles by number; a file that stands at several is loaded once.
    fn replacements(&self) -> Result<HashMap<usize, VehicleFmu<'a>>, PrepareError> {
        let stated = &self.scenario.fmus.vehicle_at;
        let mut of_file: HashMap<&Path, Arc<Import>> = HashMap::new();
        let mut replacements = HashMap::new();
        for other in stated {
            let Some(file) = &other.file else { continue };
            let import = match of_file.get(file.as_path()) {
                Some(import) => Arc::clone(import),
                None => Import::unpack(file, Origins::default())?,
            };
            of_file.insert(file, Arc::clone(&import));
            replacements.insert(other.vehicle, VehicleFmu { import, names: &other.names });
        }
        Ok(replacements)
    }

    /// The FMU that the scenario names for all vehicles.
    fn common(&self) -> Result<Option<VehicleFmu<'a>>, PrepareError> {
        let fmus = &self.scenario.fmus;
        let Some(file) = &fmus.vehicle else { return Ok(None) };
        let import = Import::unpack(file, Origins::default())?;
        Ok(Some(VehicleFmu { import, names: &fmus.vehicle_names }))
    }

    /// Our FMU, packed for a type of vehicle.
    fn of_type(&self, kind: &str) -> Result<VehicleFmu<'static>, PrepareError> {
        let import = self.folders.packed("vehicle", kind, |folder| {
            resources::write_vehicle(self.scenario, kind, folder)
        })?;
        Ok(VehicleFmu { import, names: &OUR_NAMES })
    }
}
