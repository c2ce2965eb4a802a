//! The tables of a train: its vehicles, chosen wheels, what it and the rails say of themselves.

use std::path::Path;

use super::observe_error::ObserveError;
use super::output_table::OutputTable;
use super::outputs;
use super::recorder::{PART_S, Recorder};
use super::step_table::{Row, StepTable, signals};
use crate::interface::VariableType;
use crate::recording::{
    Key, KeyValues, RAIL_TABLE, SeriesWriter, Side, TRAIN_TABLE, VehicleRow, WheelRow,
    vehicle_keys, wheel_keys,
};
use crate::scenario::Scenario;
use crate::system::step::System;
use crate::system::tap::Tap;
use crate::train::layout::{Layout, RailHolder, VehicleHolder};
use crate::train::roles::tables::{SIDES, WHEEL};

/// The same of a train alone, s. It runs more than a hundred times faster than real time, so that
/// this is less than half a second by the clock; parts of 1 s took a third of the time of the run.
const PART_OF_A_TRAIN_ALONE_S: f64 = 50.0;

/// The sides in the order of the exchange.
const SERIES_SIDES: [Side; SIDES.len()] = [Side::Left, Side::Right];

/// Begins the series of a train in `folder`.
///
/// # Errors
/// When the folder cannot be written, or the scenario names outputs that are not there.
pub fn recorder(
    scenario: &Scenario,
    layout: &Layout,
    system: &mut System,
    folder: &Path,
) -> Result<Recorder, ObserveError> {
    let part = if scenario.train_alone { PART_OF_A_TRAIN_ALONE_S } else { PART_S };
    let per_part = (part / scenario.record.interval_s).ceil() as usize;
    let series = (folder, per_part);
    let mut tables = vec![vehicle_table(layout, system, series)?];
    let numbers = scenario.recorded_vehicles();
    let recorded: Vec<(usize, &VehicleHolder)> = numbers
        .iter()
        .filter_map(|&number| Some((number, layout.vehicles.get(number - 1)?)))
        .collect();
    tables.extend(wheel_table(&recorded, system, series)?);
    tables.extend(outputs::table(scenario, &recorded, system, series)?);
    let of_train: Vec<usize> = system.number(&layout.train).into_iter().collect();
    let of_rails: Vec<usize> =
        layout.rails.iter().filter_map(|rail| system.number(&rail.component)).collect();
    let rails = Key {
        name: "rail".to_owned(),
        description: "Rail, seen in the running direction".to_owned(),
        values: KeyValues::Text(
            layout.rails.iter().map(RailHolder::side_name).map(str::to_owned).collect(),
        ),
    };
    let table = |name, keys, parts: &[usize]| {
        OutputTable::create((folder, name, per_part), keys, system, parts, |variable| {
            variable.kind == VariableType::Real && !variable.name.starts_with("vehicle[")
        })
    };
    Ok(Recorder {
        outputs: table(TRAIN_TABLE, vec![], &of_train)?.into_iter().collect(),
        after: table(RAIL_TABLE, vec![rails], &of_rails)?,
        tables,
        every: (scenario.record.interval_s / scenario.step_s).round() as u64,
    })
}

/// The value of a signal; zero where an FMU does not have it.
fn value(system: &System, tap: &Option<Tap>) -> f64 {
    tap.as_ref().map_or(0.0, |tap| system.value(tap))
}

/// The table `vehicles`.
fn vehicle_table(
    layout: &Layout,
    system: &mut System,
    (folder, per_part): (&Path, usize),
) -> Result<StepTable, ObserveError> {
    let keys = vehicle_keys(layout.count);
    let series = SeriesWriter::create(folder, "vehicles", keys, VehicleRow::columns(), per_part)?;
    let mut row = |number| -> Row {
        let taps = VehicleTaps::new(layout, system, number);
        Box::new(move |k, system, values| values.extend(taps.row(k, system).values()))
    };
    Ok(StepTable::new(series, (1..=layout.count).map(&mut row).collect()))
}

/// The signals of a vehicle.
struct VehicleTaps {
    position: Option<Tap>,
    velocity: Option<Tap>,
    coupler_front: Option<Tap>,
    coupler_rear: Option<Tap>,
    resistance: Option<Tap>,
    traction: Option<Tap>,
    brake: Option<Tap>,
    /// What a vehicle in three dimensions adds.
    vehicle: Option<BodyTaps>,
}

/// The signals of a vehicle in three dimensions; those of the wheels in pairs of left and right.
struct BodyTaps {
    position: Option<Tap>,
    velocity: Option<Tap>,
    sync: Option<Tap>,
    creep_forces: Vec<[Option<Tap>; 2]>,
    friction_powers: Vec<[Option<Tap>; 2]>,
}

impl VehicleTaps {
    fn new(layout: &Layout, system: &mut System, number: usize) -> Self {
        let mut tap = |name| layout.tap_train(system, number, name);
        Self {
            position: tap("position"),
            velocity: tap("velocity"),
            coupler_front: tap("coupler.front.force"),
            coupler_rear: tap("coupler.rear.force"),
            resistance: tap("resistance.force"),
            traction: tap("traction.force"),
            brake: tap("brake.force"),
            vehicle: layout.vehicles.get(number - 1).map(|holder| BodyTaps::new(holder, system)),
        }
    }

    /// The row at point `k`.
    fn row(&self, k: u64, system: &System) -> VehicleRow {
        let of = |tap: &Option<Tap>| value(system, tap);
        let row = VehicleRow {
            position: of(&self.position),
            velocity: of(&self.velocity),
            train_position: of(&self.position),
            train_velocity: of(&self.velocity),
            coupler_front_force: of(&self.coupler_front),
            coupler_rear_force: of(&self.coupler_rear),
            traction_force: of(&self.traction),
            brake_force: of(&self.brake),
            resistance_force: of(&self.resistance),
            ..VehicleRow::default()
        };
        // What a train alone says of a vehicle is all that there is of it.
        let Some(vehicle) = &self.vehicle else { return row };
        let sum = |wheels: &[[Option<Tap>; 2]]| -> f64 {
            wheels.iter().map(|[left, right]| of(left) + of(right)).sum()
        };
        VehicleRow {
            position: of(&vehicle.position),
            velocity: of(&vehicle.velocity),
            // Before the first step no force has acted.
            sync_force: if k == 0 { 0.0 } else { of(&vehicle.sync) },
            position_error: of(&vehicle.position) - of(&self.position),
            creep_force: sum(&vehicle.creep_forces),
            friction_power: sum(&vehicle.friction_powers),
            ..row
        }
    }
}

impl BodyTaps {
    fn new(holder: &VehicleHolder, system: &mut System) -> Self {
        let mut pairs = |name| {
            let wheel = |system: &mut System, j, side| holder.tap_wheel(system, (j, side), name);
            let wheelsets = 1..=holder.wheelsets;
            wheelsets.map(|j| [wheel(system, j, 0), wheel(system, j, 1)]).collect()
        };
        Self {
            creep_forces: pairs("force.longitudinal"),
            friction_powers: pairs("friction_power"),
            position: holder.tap_output(system, "position"),
            velocity: holder.tap_output(system, "velocity"),
            sync: holder.tap_input(system, "sync.force"),
        }
    }
}

/// The table `wheels`: a row for each wheel of these vehicles, with the wheelset's position and the
/// wheel's outputs in the order of their role. None where no vehicle has wheels, as in a train alone.
fn wheel_table(
    recorded: &[(usize, &VehicleHolder)],
    system: &mut System,
    (folder, per_part): (&Path, usize),
) -> Result<Option<StepTable>, ObserveError> {
    let (mut keys, mut rows) = (vec![], vec![]);
    for &(number, holder) in recorded {
        for j in 1..=holder.wheelsets {
            for (side, of_series) in SERIES_SIDES.into_iter().enumerate() {
                let mut taps = vec![holder.tap_wheelset(system, j)];
                let mut wheel = |name| holder.tap_wheel(system, (j, side), name);
                taps.extend(WHEEL.iter().map(|variable| wheel(variable.name)));
                keys.push((number, j, of_series));
                rows.push(signals(taps, 0.0));
            }
        }
    }
    if rows.is_empty() {
        return Ok(None);
    }
    let keys = wheel_keys(&keys);
    let series = SeriesWriter::create(folder, "wheels", keys, WheelRow::columns(), per_part)?;
    Ok(Some(StepTable::new(series, rows)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The columns of the table are the outputs of the role, in the same order.
    #[test]
    fn a_wheels_columns_are_its_roles_outputs() {
        let columns = WheelRow::columns();
        let names: Vec<_> = columns[1..].iter().map(|column| column.name().to_owned()).collect();
        let outputs: Vec<_> =
            WHEEL.iter().map(|variable| variable.name.replace('.', "_")).collect();
        assert_eq!((columns[0].name(), names), ("position", outputs));
    }
}
