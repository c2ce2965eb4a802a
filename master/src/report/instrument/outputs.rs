//! Further outputs of the recorded vehicles over time (`record.outputs`).

use serde::Serialize;

use super::decimate::Picks;
use super::packed::Packed;
use super::quantities::Quantity;
use crate::recording::{KeyValue, RecordingError, SeriesReader};

/// Numbers that all outputs together may take.
const BUDGET: usize = 35_000;

/// Records of an output that are shown at least: outputs that have no room for these are left out.
const FEWEST: usize = 100;

/// Further outputs of the recorded vehicles.
#[derive(Debug, Clone, Default, Serialize)]
pub(super) struct Outputs {
    /// One record of so many is shown.
    every: usize,
    /// Times of the shown records, s.
    time: Packed,
    vehicles: Vec<OfVehicle>,
    /// Outputs, over all vehicles, that have no room.
    left_out: usize,
}

/// The outputs of a vehicle.
#[derive(Debug, Clone, Serialize)]
struct OfVehicle {
    /// Number of the vehicle, from 1.
    number: usize,
    quantities: Vec<Quantity>,
}

impl Outputs {
    /// Reads the outputs of a table; none without a table.
    pub fn of(table: Option<&SeriesReader>) -> Result<Self, RecordingError> {
        let Some(table) = table else { return Ok(Self::default()) };
        let mut numbers: Vec<i32> = vec![];
        for number in table.read("vehicle", &[])? {
            let number = number as i32;
            if numbers.contains(&number) {
                break;
            }
            numbers.push(number);
        }
        let Some(&first) = numbers.first() else { return Ok(Self::default()) };
        let time = table.read("time", &[("vehicle", KeyValue::Integer(first))])?;
        // The mean stands beside each value that is recorded.
        let columns: Vec<(&str, &str)> = table
            .columns()
            .filter_map(|column| {
                let unit = column.metadata().get("unit").map_or("1", String::as_str);
                Some((column.name().strip_suffix("_mean")?, unit))
            })
            .collect();
        // A value and its extremes.
        let room = (BUDGET / (3 * FEWEST * numbers.len())).max(1);
        let shown = &columns[..columns.len().min(room)];
        let picks = Picks::within(BUDGET, 3 * numbers.len() * shown.len(), time.len());
        let of_vehicle = |&number: &i32| {
            let read = |name: &str| table.read(name, &[("vehicle", KeyValue::Integer(number))]);
            let mut quantities = vec![];
            for (name, unit) in shown {
                let values = read(name)?;
                // What a vehicle has not is not-a-number.
                if values.iter().any(|value| value.is_finite()) {
                    let ends = (read(&format!("{name}_min"))?, read(&format!("{name}_max"))?);
                    let plain = Quantity::plain(name, unit, &values, &picks);
                    quantities.push(plain.between(&ends.0, &ends.1, &picks));
                }
            }
            Ok::<_, RecordingError>(OfVehicle { number: number as usize, quantities })
        };
        Ok(Self {
            every: picks.every,
            time: Packed::of(picks.values(&time)),
            vehicles: numbers.iter().map(of_vehicle).collect::<Result<_, _>>()?,
            left_out: (columns.len() - shown.len()) * numbers.len(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recording::{Column, SeriesWriter, vehicle_keys_of};

    /// Vehicles 2 and 5; what the second lacks it does not show, and the others have their extremes.
    #[test]
    fn each_vehicle_shows_what_it_has() {
        let folder = tempfile::tempdir().unwrap();
        let column = |name: &str| Column::new(name, "N", "Test").double().mean().extremes();
        let columns = vec![column("a.force"), column("b.force")];
        let keys = vehicle_keys_of([2, 5]);
        let mut writer = SeriesWriter::create(folder.path(), "outputs", keys, columns, 10).unwrap();
        for record in 0..3 {
            writer.observe(0, &[f64::from(record), 1.0]);
            writer.observe(1, &[2.0 - f64::from(record), f64::NAN]);
            writer.record(0.1 * f64::from(record)).unwrap();
        }
        writer.finish().unwrap();
        let reader = SeriesReader::open(folder.path(), "outputs").unwrap();
        let outputs = Outputs::of(Some(&reader)).unwrap();
        let names = |of: &OfVehicle| -> Vec<String> {
            of.quantities.iter().map(|quantity| quantity.name.clone()).collect()
        };
        assert_eq!((outputs.every, outputs.left_out), (1, 0));
        assert_eq!(outputs.vehicles[0].number, 2);
        assert_eq!(names(&outputs.vehicles[0]), ["a.force", "b.force"]);
        assert_eq!(names(&outputs.vehicles[1]), ["a.force"]);
        assert_eq!(outputs.vehicles[1].quantities[0].value, Packed::of([2.0, 1.0, 0.0]));
        assert!(outputs.vehicles[1].quantities[0].lowest.is_some());
    }
}
