//! The units of the rails that a scenario heats, with their parameters.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::fmi::Import;
use crate::scenario::{Heat, Scenario};
use crate::system::unit::{Unit, UnitError};
use crate::train::lockstep::Vehicle;
use crate::train::parameters::set_parameter;
use crate::train::prepare::{Builder, PrepareError, check_instances, connect};
use crate::train::rail::Rail;
use crate::train::resources;
use crate::train::roles::{self, SIDES};
use crate::train::tape::Tape;

/// Place of each rail to the right of the track's middle on standard gauge, m: half of 1435 mm and of
/// a head of 72 mm.
const LATERAL_POSITION: [f64; 2] = [-0.7535, 0.7535];

impl Builder<'_> {
    /// A unit for each heated rail.
    pub(crate) fn rails(
        &self,
        heat: &Heat,
        vehicles: &[Vehicle],
    ) -> Result<Vec<Rail>, PrepareError> {
        let wheelsets: Vec<usize> = vehicles.iter().map(Vehicle::wheelsets).collect();
        let import = match &self.scenario.fmus.railheat {
            Some(file) => Import::open(file)?,
            None => self.packed("railheat", "rail", |folder| {
                resources::write_railheat(self.scenario, heat, &wheelsets, folder)
            })?,
        };
        let sides = heat.rail.sides();
        check_instances(&import, sides.len())?;
        sides.iter().map(|&side| self.rail(heat, &import, &wheelsets, side)).collect()
    }

    fn rail(
        &self,
        heat: &Heat,
        import: &Arc<Import>,
        wheelsets: &[usize],
        side: usize,
    ) -> Result<Rail, PrepareError> {
        let signals = roles::railheat_signals(wheelsets);
        let inputs = connect(import, &signals, &BTreeMap::new(), "railheat")?.inputs;
        let name = match heat.rail.sides() {
            [_] => "rail".to_owned(),
            _ => format!("rail[{}]", SIDES[side]),
        };
        let mut unit = self.instance(import, &name)?;
        self.set_rail_parameters(heat, side, unit.as_mut())?;
        let mut constants = vec![];
        for (name, value) in &heat.parameters {
            let parameter = (name.as_str(), value);
            constants.extend(set_parameter(unit.as_mut(), import, "heat.parameters", parameter)?);
        }
        let every = heat.step_s.map_or(1, |step| (step / self.scenario.step_s).round() as u64);
        let mut rail = Rail::new(unit, inputs, wheelsets.to_vec(), side, every);
        rail.constants = constants;
        if heat.trains.count > 1 {
            rail.tape = Some(self.tape()?);
        }
        Ok(rail)
    }

    fn tape(&self) -> Result<Tape, PrepareError> {
        let folder = &self.folders.results;
        let error = |source| PrepareError::Tape { folder: folder.display().to_string(), source };
        Tape::new(folder).map_err(error)
    }

    /// The scenario's values for parameters that the rail's FMU has; its extent is set so that
    /// no wheel leaves it, unless the scenario says otherwise.
    fn set_rail_parameters(
        &self,
        heat: &Heat,
        side: usize,
        unit: &mut dyn Unit,
    ) -> Result<(), UnitError> {
        let extent = Extent::of(self.scenario, heat);
        for (name, value) in [
            ("track.begin", extent.begin),
            ("track.length", extent.length),
            ("field_interval", heat.field_interval_s),
            ("detection.threshold", 1e-3 * heat.detection_threshold_mk),
            ("rail.lateral_position", LATERAL_POSITION[side]),
        ] {
            if unit.interface().variable(name).is_some() {
                unit.set_real_parameter(name, value)?;
            }
        }
        let field_file = self.folders.results.join(field_file(heat, side));
        let field_file = field_file.to_string_lossy();
        for (name, value) in [
            ("field_file", &*field_file),
            ("field_failure", heat.field_failure.word()),
            ("model", &heat.model),
        ] {
            if unit.interface().variable(name).is_some() {
                unit.set_text_parameter(name, value)?;
            }
        }
        Ok(())
    }
}

/// Name of the store with the field of a rail.
pub(crate) fn field_file(heat: &Heat, side: usize) -> String {
    match heat.rail.sides() {
        [_] => "rail.zarr".to_owned(),
        _ => format!("rail-{}.zarr", SIDES[side]),
    }
}

/// Part of the track whose rail is modelled, m.
pub(crate) struct Extent {
    pub(crate) begin: f64,
    pub(crate) length: f64,
}

/// Longest vehicle that is thought of where the scenario leaves the extent of the rail open, m.
const LONGEST_VEHICLE: f64 = 30.0;
/// Largest mean acceleration that is thought of there, m/s².
const LARGEST_ACCELERATION: f64 = 0.1;

impl Extent {
    /// What the scenario says, or from behind the tail to as far as the train may come.
    pub(crate) fn of(scenario: &Scenario, heat: &Heat) -> Self {
        let train = &scenario.train;
        let head = train.leading_vehicle_position_m;
        let behind = scenario.vehicle_count() as f64 * LONGEST_VEHICLE;
        let duration = scenario.duration_s;
        let ahead = LONGEST_VEHICLE
            + train.speed_m_per_s * duration
            + LARGEST_ACCELERATION * duration * duration / 2.0;
        let begin = heat.begin_m.unwrap_or(head - behind);
        let length = heat.length_m.unwrap_or_else(|| (head + ahead - begin).ceil());
        Self { begin, length }
    }
}
