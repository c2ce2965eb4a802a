//! The wheels of the recorded vehicles.

use std::path::Path;

use serde::Serialize;

use super::decimate::{FEWEST, Picks};
use super::packed::Packed;
use super::quantities::Quantity;
use super::train::recorded_numbers;
use crate::recording::{KeyValue, RecordingError, SeriesReader, Side};
use crate::report::facts::RunFacts;

/// What of a wheel is shown, with its unit, and whether with its extremes.
const OF_WHEEL: [(&str, &str, bool); 5] = [
    ("creepage_longitudinal", "1", false),
    ("creepage_lateral", "1", false),
    ("creepage_spin", "1/m", false),
    ("force_normal", "N", false),
    (FRICTION_POWER, "W", true),
];

/// The column from which the wear number is.
const FRICTION_POWER: &str = "friction_power";

/// Numbers that all wheels together may take.
const BUDGET: usize = 40_000;

/// Below this speed heat per metre says nothing, m/s.
const SLOW: f64 = 0.1;

/// The recorded wheels.
#[derive(Debug, Clone, Default, Serialize)]
pub(super) struct Wheels {
    /// One record of so many is shown.
    every: usize,
    /// Times of the shown records, s.
    time: Packed,
    wheels: Vec<Wheel>,
    /// Recorded wheels that have no room.
    left_out: usize,
}

/// A wheel.
#[derive(Debug, Clone, Serialize)]
struct Wheel {
    vehicle: usize,
    wheelset: usize,
    side: &'static str,
    /// Chainage of its wheelset, m.
    position: Packed,
    quantities: Vec<Quantity>,
}

impl Wheels {
    /// Reads the wheels of a run; none where there is no table of them.
    pub fn of(folder: &Path, facts: &RunFacts) -> Result<Self, RecordingError> {
        let series = folder.join("series");
        let table = match SeriesReader::open(&series, "wheels") {
            Err(RecordingError::NoTable { .. }) => return Ok(Self::default()),
            table => table?,
        };
        let numbers = recorded_numbers(facts);
        let mut wheels = vec![];
        for &vehicle in &numbers {
            let of_vehicle = [("vehicle", KeyValue::Integer(vehicle as i32))];
            let wheelsets = table.read("wheelset", &of_vehicle)?;
            let count = wheelsets.into_iter().fold(0.0, f64::max) as usize;
            wheels.extend(
                (1..=count)
                    .flat_map(|j| [Side::Left, Side::Right].map(|side| (vehicle, j, side.name()))),
            );
        }
        let Some(&(vehicle, wheelset, side)) = wheels.first() else { return Ok(Self::default()) };
        let time = table.read("time", &keys(vehicle, wheelset, side))?;
        // Those of the table, the extremes, the wear number and the position.
        let each = OF_WHEEL.len() + 4;
        let left_out = wheels.len().saturating_sub(BUDGET / (each * FEWEST));
        wheels.truncate(wheels.len() - left_out);
        let columns = wheels.len() * each;
        let picks = Picks::within(BUDGET, columns, time.len());
        let vehicles = SeriesReader::open(&series, "vehicles")?;
        let wheel =
            |&wheel: &(usize, usize, &'static str)| of_wheel(&table, &vehicles, wheel, &picks);
        Ok(Self {
            every: picks.every,
            time: Packed::of(picks.values(&time)),
            wheels: wheels.iter().map(wheel).collect::<Result<_, _>>()?,
            left_out,
        })
    }
}

/// The keys of the rows of a wheel.
fn keys(vehicle: usize, wheelset: usize, side: &str) -> [(&'static str, KeyValue<'_>); 3] {
    [
        ("vehicle", KeyValue::Integer(vehicle as i32)),
        ("wheelset", KeyValue::Integer(wheelset as i32)),
        ("side", KeyValue::Text(side)),
    ]
}

fn of_wheel(
    table: &SeriesReader,
    vehicles: &SeriesReader,
    (vehicle, wheelset, side): (usize, usize, &'static str),
    picks: &Picks,
) -> Result<Wheel, RecordingError> {
    let keys = keys(vehicle, wheelset, side);
    let read = |name: &str| table.read(name, &keys);
    let (mut quantities, mut power) = (vec![], vec![]);
    for (name, unit, extremes) in OF_WHEEL {
        let values = read(name)?;
        let plain = Quantity::plain(name, unit, &values, picks);
        if name == FRICTION_POWER {
            power = values;
        }
        quantities.push(match extremes {
            true => {
                let ends = (read(&format!("{name}_min"))?, read(&format!("{name}_max"))?);
                plain.between(&ends.0, &ends.1, picks)
            }
            false => plain,
        });
    }
    let speed = vehicles.read("velocity", &keys[..1])?;
    let wear = power.iter().zip(speed).map(|(power, speed)| match speed.abs() > SLOW {
        true => power / speed.abs(),
        false => f64::NAN,
    });
    let wear: Vec<f64> = wear.collect();
    quantities.push(Quantity::plain("wear_number", "J/m", &wear, picks));
    let position = Packed::of(picks.values(&read("position")?));
    Ok(Wheel { vehicle, wheelset, side, position, quantities })
}
