//! What is recorded of a run: the series of the train, the vehicles and chosen wheels, and of the
//! rails (`observe_rail.rs`), and further outputs of the vehicles (`observe_outputs.rs`).

use std::path::Path;

use crate::recording::{
    Column, RecordingError, SeriesWriter, Side, VehicleRow, WheelRow, vehicle_keys, wheel_keys,
};
use crate::report::EnergyLine;
use crate::run::observe_outputs::{OutputRecorder, OutputsError};
use crate::run::observe_rail::RailRecorder;
use crate::scenario::Scenario;
use crate::system::port::{Port, Signal};
use crate::system::unit::{Unit, UnitError};
use crate::train::lockstep::{Lockstep, Vehicle};
use crate::train::rail::Rail;
use crate::train::roles::{SIDES, train, vehicle_input, vehicle_output};

/// Simulated time in a part of a series on disk, s; a killed run loses less than this.
const PART_S: f64 = 1.0;

/// The same of a train alone, s. It runs more than a hundred times faster than real time, so that
/// this is less than half a second by the clock; parts of 1 s took a third of the time of the run.
const PART_OF_A_TRAIN_ALONE_S: f64 = 50.0;

/// Why recording failed.
#[derive(Debug, thiserror::Error)]
pub enum ObserveError {
    /// A file cannot be written.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// A unit does not give its outputs.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// The outputs that the scenario names are not there.
    #[error(transparent)]
    Outputs(#[from] OutputsError),
}

/// Records the series of a run.
pub struct Recorder {
    train: SeriesWriter,
    train_outputs: Port,
    vehicles: SeriesWriter,
    /// None where no vehicle has wheels, as in a train alone.
    wheels: Option<SeriesWriter>,
    /// None where the scenario names no further outputs.
    outputs: Option<OutputRecorder>,
    /// None where no rail is heated.
    rails: Option<RailRecorder>,
    /// Vehicle (from zero), wheelset and side of each row of the wheels.
    wheel_rows: Vec<(usize, usize, usize)>,
    /// Exchange steps per record.
    every: u64,
    /// Whether each vehicle has had traction.
    powered: Vec<bool>,
    /// Names of the recorded outputs of the train that are energies, with their places.
    energies: Vec<(String, usize)>,
}

impl Recorder {
    /// Begins the series of a run in `folder`.
    ///
    /// # Errors
    /// When the folder cannot be written.
    pub fn new(
        scenario: &Scenario,
        lockstep: &Lockstep,
        folder: &Path,
    ) -> Result<Self, ObserveError> {
        let every = (scenario.record.interval_s / scenario.step_s).round() as u64;
        let part = if scenario.train_alone { PART_OF_A_TRAIN_ALONE_S } else { PART_S };
        let per_part = (part / scenario.record.interval_s).ceil() as usize;
        let (train_outputs, columns) = all_outputs(lockstep.train.unit.as_ref());
        let is_energy = |(_, column): &(usize, &Column)| column.unit() == "J";
        let energies = columns.iter().enumerate().filter(is_energy);
        let energies = energies.map(|(i, column)| (column.name().to_owned(), i)).collect();
        let wheel_rows = wheel_rows(scenario, lockstep);
        let keys: Vec<_> =
            wheel_rows.iter().map(|&(i, j, side)| (i + 1, j + 1, SERIES_SIDES[side])).collect();
        let create =
            |name, keys, columns| SeriesWriter::create(folder, name, keys, columns, per_part);
        Ok(Self {
            train: create("train", vec![], columns)?,
            train_outputs,
            vehicles: create(
                "vehicles",
                vehicle_keys(scenario.vehicle_count()),
                VehicleRow::columns(),
            )?,
            wheels: match keys.is_empty() {
                true => None,
                false => Some(create("wheels", wheel_keys(&keys), WheelRow::columns())?),
            },
            outputs: OutputRecorder::new(
                &scenario.record.outputs,
                &scenario.recorded_vehicles(),
                &lockstep.vehicles,
                folder,
                per_part,
            )?,
            rails: RailRecorder::new(&lockstep.rails, folder, per_part)?,
            wheel_rows,
            every,
            powered: vec![false; scenario.vehicle_count()],
            energies,
        })
    }

    /// Takes the state at communication point `k`, and records it if it is due.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn observe(&mut self, k: u64, lockstep: &mut Lockstep) -> Result<(), ObserveError> {
        for (i, place) in lockstep.train.blocks().enumerate() {
            let row = match lockstep.vehicles.get(i) {
                Some(vehicle) => vehicle_row(vehicle, place),
                None => train_row(place),
            };
            self.vehicles.observe(i, &row.values());
            self.powered[i] |= place[train::TRACTION] != 0.0;
        }
        if let Some(wheels) = &mut self.wheels {
            for (row, &(i, j, side)) in self.wheel_rows.iter().enumerate() {
                wheels.observe(row, &wheel_row(&lockstep.vehicles[i], j, side).values());
            }
        }
        if let Some(outputs) = &mut self.outputs {
            outputs.observe(&mut lockstep.vehicles)?;
        }
        if k.is_multiple_of(self.every) {
            self.record(lockstep.clock.at(k), lockstep)?;
        }
        Ok(())
    }

    /// Places from one of the vehicles that have had traction.
    pub fn locomotives(&self) -> Vec<usize> {
        let powered = self.powered.iter().enumerate().filter(|(_, powered)| **powered);
        powered.map(|(i, _)| i + 1).collect()
    }

    /// Exchange steps per record.
    pub fn every(&self) -> u64 {
        self.every
    }

    /// The energies that the train gave at the last record.
    pub fn energy(&self) -> Vec<EnergyLine> {
        let values = &self.train_outputs.values;
        let line =
            |(name, i): &(String, usize)| EnergyLine { name: name.clone(), joules: values[*i] };
        self.energies.iter().map(line).collect()
    }

    fn record(&mut self, time: f64, lockstep: &mut Lockstep) -> Result<(), ObserveError> {
        self.train_outputs.get(lockstep.train.unit.as_mut())?;
        self.train.observe(0, &self.train_outputs.values);
        self.train.record(time)?;
        self.vehicles.record(time)?;
        if let Some(wheels) = &mut self.wheels {
            wheels.record(time)?;
        }
        if let Some(outputs) = &mut self.outputs {
            outputs.record(time)?;
        }
        self.record_rails(time, &mut lockstep.rails)
    }

    /// Records the rails only.
    ///
    /// # Errors
    /// When a unit does not give its outputs, or a file cannot be written.
    pub fn record_rails(&mut self, time: f64, rails: &mut [Rail]) -> Result<(), ObserveError> {
        self.rails.as_mut().map_or(Ok(()), |recorder| recorder.record(time, rails))
    }

    /// Completes the files.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn finish(self) -> Result<(), ObserveError> {
        self.train.finish()?;
        self.vehicles.finish()?;
        if let Some(wheels) = self.wheels {
            wheels.finish()?;
        }
        if let Some(outputs) = self.outputs {
            outputs.finish()?;
        }
        self.rails.map_or(Ok(()), RailRecorder::finish)
    }
}

/// The sides in the order of the exchange.
const SERIES_SIDES: [Side; SIDES.len()] = [Side::Left, Side::Right];

/// All Real outputs of a unit that do not belong to single vehicles, and their columns.
pub(crate) fn all_outputs(unit: &dyn Unit) -> (Port, Vec<Column>) {
    let outputs = unit.interface().real_outputs("vehicle[");
    let signals: Vec<_> = outputs.iter().map(|output| Signal::required(&output.name)).collect();
    let port = Port::connect(unit.interface(), &signals, "output", &Default::default());
    let column = |output: &&crate::interface::Variable| {
        let unit = output.unit.as_deref().unwrap_or("1");
        Column::new(&output.name, unit, &output.description).double()
    };
    (port.unwrap_or_default(), outputs.iter().map(column).collect())
}

/// The wheels of the recorded vehicles.
fn wheel_rows(scenario: &Scenario, lockstep: &Lockstep) -> Vec<(usize, usize, usize)> {
    let mut rows = vec![];
    for place in scenario.recorded_vehicles() {
        let vehicle = lockstep.vehicles.get(place - 1);
        let wheelsets = vehicle.map_or(0, Vehicle::wheelsets);
        for j in 0..wheelsets {
            rows.extend([(place - 1, j, 0), (place - 1, j, 1)]);
        }
    }
    rows
}

/// What the train says of a vehicle; without a vehicle in three dimensions the rest is zero.
fn train_row(place: &[f64]) -> VehicleRow {
    VehicleRow {
        position: place[train::POSITION],
        velocity: place[train::VELOCITY],
        train_position: place[train::POSITION],
        train_velocity: place[train::VELOCITY],
        coupler_front_force: place[train::COUPLER_FRONT],
        coupler_rear_force: place[train::COUPLER_REAR],
        traction_force: place[train::TRACTION],
        brake_force: place[train::BRAKE],
        resistance_force: place[train::RESISTANCE],
        ..VehicleRow::default()
    }
}

fn vehicle_row(vehicle: &Vehicle, place: &[f64]) -> VehicleRow {
    let (inputs, outputs) = (&vehicle.inputs.values, &vehicle.outputs.values);
    let wheels =
        || outputs[vehicle_output::NAMES.len()..].chunks_exact(vehicle_output::WHEELSET_BLOCK);
    let sum = |quantity: usize| -> f64 {
        let count = vehicle_output::WHEEL_NAMES.len();
        wheels().map(|block| block[1 + quantity] + block[1 + count + quantity]).sum()
    };
    VehicleRow {
        position: outputs[vehicle_output::POSITION],
        velocity: outputs[vehicle_output::VELOCITY],
        sync_force: inputs[vehicle_input::SYNCHRONISATION],
        position_error: outputs[vehicle_output::POSITION] - place[train::POSITION],
        creep_force: sum(vehicle_output::FORCE_LONGITUDINAL),
        friction_power: sum(vehicle_output::FRICTION_POWER),
        ..train_row(place)
    }
}

fn wheel_row(vehicle: &Vehicle, wheelset: usize, side: usize) -> WheelRow {
    let outputs = &vehicle.outputs.values;
    let wheel =
        &outputs[vehicle_output::wheel(wheelset, side)..][..vehicle_output::WHEEL_NAMES.len()];
    WheelRow {
        position: outputs[vehicle_output::wheelset(wheelset)],
        creepage_longitudinal: wheel[0],
        creepage_lateral: wheel[1],
        creepage_spin: wheel[2],
        force_longitudinal: wheel[3],
        force_lateral: wheel[4],
        force_normal: wheel[5],
        friction_power: wheel[6],
        contact_a: wheel[7],
        contact_b: wheel[8],
        contact_lateral_position: wheel[9],
    }
}
