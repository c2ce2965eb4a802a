//! What the run says of further outputs of vehicles that were recorded (`record.outputs`): for each
//! name the highest and the lowest mean over an interval of the record, and the largest standard
//! deviation of these means in time. Rules of acceptance judge such means, not single steps.

use numerics::seconds;

use super::data::MainFigure;
use crate::interface::name_pattern::matches;
use crate::recording::{RecordingError, SeriesReader};

/// Ending of the columns with the means.
const MEAN: &str = "_mean";

/// Means of one output of one vehicle at all records.
struct Means {
    output: String,
    unit: String,
    vehicle: f64,
    values: Vec<f64>,
}

/// A value with the mean and the record where it stands.
struct Found<'m> {
    value: f64,
    of: &'m Means,
    /// Number of the record, for a value of one instant.
    record: Option<usize>,
}

/// The figures of all names.
pub(super) fn of_run(
    patterns: &[String],
    outputs: &SeriesReader,
) -> Result<Vec<MainFigure>, RecordingError> {
    let time = outputs.read("time", &[])?;
    let vehicles = outputs.read("vehicle", &[])?;
    let mut figures = vec![];
    for pattern in patterns {
        let means = means(pattern, outputs, &vehicles)?;
        let highest = extreme(&means, |value, best| value > best);
        let lowest = extreme(&means, |value, best| value < best);
        let found = [
            ("highest", "Highest", highest),
            ("lowest", "Lowest", lowest),
            ("deviation", "Largest deviation of", widest(&means)),
        ];
        for (key, word, found) in found {
            figures.extend(found.map(|found| figure(pattern, key, word, &found, &time)));
        }
    }
    Ok(figures)
}

fn figure(pattern: &str, key: &str, word: &str, found: &Found<'_>, time: &[f64]) -> MainFigure {
    let Means { output, unit, vehicle, .. } = found.of;
    let name = format!("{word} {pattern}");
    let mut figure = MainFigure::new(format!("outputs.{pattern}.{key}"), name, found.value, unit);
    if unit == "1" {
        figure.text = format!("{:.3}", found.value);
    }
    let location = format!("{output} of vehicle {vehicle}");
    // The table has a row for each vehicle at each record.
    let rows = time.len() / found.of.values.len().max(1);
    match found.record.map(|record| time[record * rows]) {
        Some(at) => {
            let figure = figure.at(format!("{location} at {} s", seconds(at)));
            MainFigure { time_s: Some(at), ..figure }
        }
        None => figure.at(location),
    }
}

/// The means of all outputs of that name, each vehicle for itself.
fn means(
    pattern: &str,
    outputs: &SeriesReader,
    vehicles: &[f64],
) -> Result<Vec<Means>, RecordingError> {
    let mut means = vec![];
    let rows =
        vehicles.iter().skip(1).position(|v| *v == vehicles[0]).map_or(vehicles.len(), |n| n + 1);
    for field in outputs.columns() {
        let Some(output) = field.name().strip_suffix(MEAN) else { continue };
        if !matches(pattern, output) {
            continue;
        }
        let values = outputs.read(field.name(), &[])?;
        for (row, &vehicle) in vehicles.iter().enumerate().take(rows) {
            means.push(Means {
                output: output.to_owned(),
                unit: field.metadata().get("unit").cloned().unwrap_or_default(),
                vehicle,
                values: values.iter().copied().skip(row).step_by(rows).collect(),
            });
        }
    }
    Ok(means)
}

/// The first of the most extreme values; `None` if no value is finite.
fn extreme(means: &[Means], is_better: fn(f64, f64) -> bool) -> Option<Found<'_>> {
    let mut best: Option<Found<'_>> = None;
    for of in means {
        let finite = of.values.iter().enumerate().filter(|(_, value)| value.is_finite());
        for (record, &value) in finite {
            if best.as_ref().is_none_or(|best| is_better(value, best.value)) {
                best = Some(Found { value, of, record: Some(record) });
            }
        }
    }
    best
}

/// The largest standard deviation in time.
fn widest(means: &[Means]) -> Option<Found<'_>> {
    let deviation = |of: &Means| {
        let count = of.values.len() as f64;
        let mean = of.values.iter().sum::<f64>() / count;
        let squares: f64 = of.values.iter().map(|value| (value - mean).powi(2)).sum();
        (squares / count).sqrt()
    };
    let found = means.iter().map(|of| Found { value: deviation(of), of, record: None });
    let finite = found.filter(|found| found.value.is_finite());
    finite.max_by(|a, b| a.value.total_cmp(&b.value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recording::{Column, SeriesWriter, vehicle_keys_of};

    /// Vehicles 1 and 3 with two outputs over three records of two steps each; one output is missing in
    /// vehicle 3. By hand: means 0, 2, 4 and 0, -3, -6, whose deviations are
    /// sqrt(8/3) and sqrt(6).
    #[test]
    fn analytic_highest_lowest_and_deviation_of_the_means() {
        let folder = tempfile::tempdir().unwrap();
        let column = |name: &str| Column::new(name, "N", "Test").double().mean();
        let columns = vec![column("a.force"), column("b.force"), column("other")];
        let keys = vehicle_keys_of([1, 3]);
        let mut writer = SeriesWriter::create(folder.path(), "outputs", keys, columns, 10).unwrap();
        for record in 0..3 {
            for step in [-1.0, 1.0] {
                let at = f64::from(record);
                writer.observe(0, &[2.0 * at + step, 1.0, 100.0]);
                writer.observe(1, &[-3.0 * at + step, f64::NAN, -100.0]);
            }
            writer.record(0.1 * f64::from(record)).unwrap();
        }
        writer.finish().unwrap();
        let reader = SeriesReader::open(folder.path(), "outputs").unwrap();
        let figures = of_run(&["*.force".to_owned()], &reader).unwrap();
        let keys: Vec<&str> = figures.iter().map(|figure| figure.key.as_str()).collect();
        let expected =
            ["highest", "lowest", "deviation"].map(|key| format!("outputs.*.force.{key}"));
        assert_eq!(keys, expected);
        let values: Vec<f64> = figures.iter().filter_map(|figure| figure.value).collect();
        for (value, expected) in values.iter().zip([4.0, -6.0, 6.0_f64.sqrt()]) {
            assert!((value - expected).abs() < 1e-12, "{value}, expected {expected}");
        }
        assert_eq!(figures[0].location, "a.force of vehicle 1 at 0.2 s");
        assert_eq!(figures[1].time_s, Some(0.2));
        assert_eq!(figures[2].location, "a.force of vehicle 3");
    }
}
