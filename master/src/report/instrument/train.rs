//! The train: what its driver does, all vehicles at some instants, and the recorded vehicles over time.

use serde::Serialize;

use super::couplings::{Exchanged, Residual};
use super::decimate::{FEWEST, Picks};
use super::packed::Packed;
use super::quantities::{Quantities, Quantity};
use crate::recording::{KeyValue, RecordingError, SeriesReader};
use crate::report::facts::RunFacts;
use crate::report::results::Results;

/// What of the train's own outputs is shown, where it is there and not always zero.
pub(in crate::report) const OF_TRAIN: [&str; 8] = [
    "driver.in_force.notch",
    "driver.in_force.dynamic_brake",
    "driver.in_force.train_brake",
    "driver.in_force.locomotive_brake",
    "driver.target_speed",
    "driver.measured_speed",
    "train.coupler.tension",
    "train.coupler.buff",
];

/// What of a recorded vehicle is shown over time.
const OF_VEHICLE: [&str; 6] = [
    "velocity",
    "coupler_rear_force",
    "creep_force",
    "friction_power",
    "sync_force",
    "position_error",
];

/// What is shown of all vehicles at an instant.
const OF_ALL: [&str; 4] = ["position", "coupler_rear_force", "creep_force", "friction_power"];

/// Name and unit of the residual, which no table has.
const RESIDUAL: (&str, &str) = ("coupling_residual", "W");

/// Numbers that the instants of all vehicles may take, and those of the recorded ones.
const BUDGETS: [usize; 2] = [50_000, 40_000];

/// The train.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Train {
    /// Train, driver and the leading vehicle's motion.
    driver: Quantities,
    /// All vehicles: of each quantity all vehicles at the first instant, then at the next.
    all: Quantities,
    /// Lowest force in the rear coupler of each vehicle in the run, N.
    coupler_lowest: Packed,
    /// Highest force in the rear coupler of each vehicle in the run, N.
    coupler_highest: Packed,
    /// The recorded vehicles, at the times of the driver.
    recorded: Vec<Recorded>,
}

/// A recorded vehicle.
#[derive(Debug, Clone, Serialize)]
struct Recorded {
    /// Its number, from 1.
    number: usize,
    quantities: Vec<Quantity>,
}

/// The table of the vehicles, with its shape.
struct Vehicles<'r> {
    table: &'r SeriesReader,
    count: usize,
}

impl Train {
    /// Reads the train, and gives the residual power of its couplings.
    pub fn of(results: &Results) -> Result<(Self, Option<Residual>), RecordingError> {
        let Results { facts, train, vehicles: table, .. } = results;
        let vehicles = Vehicles { table, count: facts.vehicles.max(1) };
        let time = table.read("time", &[("vehicle", KeyValue::Integer(1))])?;
        let residuals = match facts.train_alone {
            true => vec![],
            false => vehicles.residuals()?,
        };
        let mut numbers = recorded_numbers(facts);
        // The others have what all vehicles have.
        numbers.truncate(BUDGETS[1] / (3 * (OF_VEHICLE.len() + 1) * FEWEST));
        let columns = OF_TRAIN.len() + 3 * (OF_VEHICLE.len() + 1) * numbers.len();
        let picks = Picks::within(BUDGETS[1], columns, time.len());
        let mut recorded = vec![];
        for &number in &numbers {
            let mut quantities = vehicles.recorded(number, &picks, facts.train_alone)?;
            if !facts.train_alone {
                let of_one = residuals.iter().copied().skip(number - 1).step_by(vehicles.count);
                let of_one: Vec<f64> = of_one.collect();
                quantities.push(
                    Quantity::plain(RESIDUAL.0, RESIDUAL.1, &of_one, &picks)
                        .between(&of_one, &of_one, &picks),
                );
            }
            recorded.push(Recorded { number, quantities });
        }
        let (coupler_lowest, coupler_highest) = vehicles.envelope()?;
        let mut of_driver = of_train(train, &picks)?;
        for name in ["velocity", "position"] {
            let values = table.read(name, &[("vehicle", KeyValue::Integer(1))])?;
            of_driver.push(Quantity::plain(name, &vehicles.unit(name), &values, &picks));
        }
        let driver = Quantities {
            every: picks.every,
            time: Packed::of(picks.values(&time)),
            quantities: of_driver,
        };
        let all = vehicles.all(&time, &residuals)?;
        let residual = Residual::of(&time, vehicles.count, &residuals);
        Ok((Self { driver, all, coupler_lowest, coupler_highest, recorded }, residual))
    }
}

/// The numbers of the recorded vehicles that the train has.
pub(super) fn recorded_numbers(facts: &RunFacts) -> Vec<usize> {
    let numbers = facts.plotted.iter().copied();
    numbers.filter(|number| (1..=facts.vehicles).contains(number)).collect()
}

/// The outputs of the train that are worth a line.
fn of_train(train: &SeriesReader, picks: &Picks) -> Result<Vec<Quantity>, RecordingError> {
    let mut quantities = vec![];
    for name in OF_TRAIN {
        let Some(unit) = unit(train, name) else { continue };
        let values = train.read(name, &[])?;
        if values.iter().any(|value| *value != 0.0) {
            quantities.push(Quantity::plain(name, &unit, &values, picks));
        }
    }
    Ok(quantities)
}

/// The unit of a column; `None` without such a column.
fn unit(table: &SeriesReader, name: &str) -> Option<String> {
    let column = table.columns().find(|column| column.name() == name)?;
    Some(column.metadata().get("unit").cloned().unwrap_or_default())
}

impl Vehicles<'_> {
    /// Unit of a column of the table.
    fn unit(&self, name: &str) -> String {
        unit(self.table, name).unwrap_or_default()
    }

    /// What a recorded vehicle does over time.
    fn recorded(
        &self,
        number: usize,
        picks: &Picks,
        train_alone: bool,
    ) -> Result<Vec<Quantity>, RecordingError> {
        let key = KeyValue::Integer(i32::try_from(number).unwrap_or(i32::MAX));
        let read = |name: &str| self.table.read(name, &[("vehicle", key)]);
        // Alone, a train has couplers only.
        let names = if train_alone { &OF_VEHICLE[..2] } else { &OF_VEHICLE[..] };
        let quantity = |&name: &&str| {
            let plain = Quantity::plain(name, &self.unit(name), &read(name)?, picks);
            if unit(self.table, &format!("{name}_min")).is_none() {
                return Ok(plain);
            }
            let (lowest, highest) = (read(&format!("{name}_min"))?, read(&format!("{name}_max"))?);
            Ok(plain.between(&lowest, &highest, picks))
        };
        names.iter().map(quantity).collect()
    }

    /// All vehicles at some instants.
    fn all(&self, time: &[f64], residuals: &[f64]) -> Result<Quantities, RecordingError> {
        let columns = (OF_ALL.len() + 1) * self.count;
        let picks = Picks::within(BUDGETS[0], columns, time.len());
        let chosen = |values: &[f64]| {
            let row = |&record: &usize| values[record * self.count..][..self.count].to_vec();
            Packed::of(picks.records.iter().flat_map(row))
        };
        let quantity = |name: &str, unit: String, values: &[f64]| Quantity {
            name: name.to_owned(),
            unit,
            value: chosen(values),
            lowest: None,
            highest: None,
        };
        let mut quantities = vec![];
        // Alone, a train has neither creep nor friction.
        let names = if residuals.is_empty() { &OF_ALL[..2] } else { &OF_ALL[..] };
        for name in names {
            quantities.push(quantity(name, self.unit(name), &self.table.read(name, &[])?));
        }
        if !residuals.is_empty() {
            quantities.push(quantity(RESIDUAL.0, RESIDUAL.1.to_owned(), residuals));
        }
        Ok(Quantities { every: picks.every, time: Packed::of(picks.values(time)), quantities })
    }

    /// Lowest and highest force in the rear coupler of each vehicle, in the whole run.
    fn envelope(&self) -> Result<(Packed, Packed), RecordingError> {
        let extreme = |suffix: &str, better: fn(f64, f64) -> f64| {
            let values = self.table.read(&format!("coupler_rear_force_{suffix}"), &[])?;
            let of_one = |index: usize| {
                let values = values.iter().copied().skip(index).step_by(self.count);
                values.fold(f64::NAN, better)
            };
            Ok::<_, RecordingError>(Packed::of((0..self.count).map(of_one)))
        };
        Ok((extreme("min", f64::min)?, extreme("max", f64::max)?))
    }

    /// Residual power of the coupling of each vehicle at each record, W.
    fn residuals(&self) -> Result<Vec<f64>, RecordingError> {
        let read = |name: &str| self.table.read(name, &[]);
        let mut exchanged: Vec<Exchanged> = vec![];
        let mut set = |name: &str, set: fn(&mut Exchanged, f64)| {
            let values = read(name)?;
            exchanged.resize(values.len(), Exchanged::default());
            exchanged.iter_mut().zip(values).for_each(|(of, value)| set(of, value));
            Ok::<_, RecordingError>(())
        };
        set("coupler_front_force", |of, force| of.coupler_front = force)?;
        set("coupler_rear_force", |of, force| of.coupler_rear = force)?;
        set("traction_force", |of, force| of.traction = force)?;
        set("brake_force", |of, force| of.brake = force)?;
        set("resistance_force", |of, force| of.resistance = force)?;
        set("sync_force", |of, force| of.synchronisation = force)?;
        set("train_velocity", |of, speed| of.train_speed = speed)?;
        set("velocity", |of, speed| of.vehicle_speed = speed)?;
        Ok(exchanged.iter().map(Exchanged::residual).collect())
    }
}
