//! The crate `fmi` as an independent importer: it runs the experiment that each of Hotfoot's FMUs
//! carries, and gets the result that Hotfoot's master got when the FMU was made.
//!
//! `cargo xtask test` runs it; it gives libclang, which the crate needs to build, and the folder of
//! the FMUs.

use std::path::Path;

use fmi::fmi2::import::Fmi2Import;
use fmi::fmi2::instance::{CoSimulation, Common};
use fmi::traits::FmiImport;
use toml::Table;

/// Where an FMU keeps its reference result.
const FOLDER: &str = "extra/org.fmi-standard.fmi-ls-ref";

/// Numbers of a CSV file: names, and rows with the time first.
struct Csv {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Csv {
    fn read(file: &Path) -> Self {
        let text = std::fs::read_to_string(file).expect("the FMU carries it");
        let mut lines = text.lines();
        let names = lines.next().expect("a line of names").split(',').skip(1);
        let row = |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
        Self { names: names.map(str::to_owned).collect(), rows: lines.map(row).collect() }
    }

    /// Values at a time, on the line between two rows; where two rows have one time, the later one.
    fn at(&self, time: f64) -> Vec<f64> {
        let after = self.rows.partition_point(|row| row[0] <= time);
        let (before, next) = (after.saturating_sub(1), after.min(self.rows.len() - 1));
        let (before, next) = (&self.rows[before], &self.rows[next]);
        let length = next[0] - before[0];
        let share = if length > 0.0 { (time - before[0]) / length } else { 0.0 };
        before.iter().zip(next).skip(1).map(|(a, b)| a + share * (b - a)).collect()
    }
}

/// Runs the experiment of a model and compares every row.
fn replay(model: &str) {
    let folder = std::env::var("HOTFOOT_FMUS").expect("`cargo xtask test` sets it");
    let file = Path::new(&folder).join(format!("{model}.fmu"));
    let import: Fmi2Import = fmi::import::from_path(file).expect("`cargo xtask fmus` makes it");
    let files = import.archive_path().join(FOLDER);
    let experiment: Table =
        std::fs::read_to_string(files.join("experiment.toml")).unwrap().parse().unwrap();
    let number = |key: &str| experiment[key].as_float().expect("a number");
    let (stop, step) = (number("stop_time_s"), number("step_s"));
    let record_every = experiment["record_every"].as_integer().expect("a number") as u32;
    let (inputs, expected) = (Csv::read(&files.join("in.csv")), Csv::read(&files.join("ref.csv")));

    let reference = |name: &str| {
        let variables = &import.model_description().model_variables.variables;
        let variable = variables.iter().find(|variable| variable.name == name);
        variable.unwrap_or_else(|| panic!("no variable {name}")).value_reference
    };
    let into: Vec<u32> = inputs.names.iter().map(|name| reference(name)).collect();
    let from: Vec<u32> = expected.names.iter().map(|name| reference(name)).collect();
    let mut instance = import.instantiate_cs(model, false, true).unwrap();
    let start_values = experiment.get("start_values").and_then(|values| values.as_table());
    for (name, value) in start_values.into_iter().flatten() {
        instance.set_real(&[reference(name)], &[value.as_float().expect("a number")]).unwrap();
    }
    instance.setup_experiment(None, 0.0, Some(stop)).unwrap();
    instance.enter_initialization_mode().unwrap();
    instance.set_real(&into, &inputs.at(0.0)).unwrap();
    instance.exit_initialization_mode().unwrap();

    let mut found = vec![vec![0.0; from.len()]];
    instance.get_real(&from, &mut found[0]).unwrap();
    for k in 0..(stop / step).round() as u32 {
        let time = f64::from(k) * step;
        instance.set_real(&into, &inputs.at(time)).unwrap();
        instance.do_step(time, step, true).unwrap();
        if (k + 1) % record_every == 0 {
            let mut row = vec![0.0; from.len()];
            instance.get_real(&from, &mut row).unwrap();
            found.push(row);
        }
    }
    instance.terminate().unwrap();

    assert_eq!(found.len(), expected.rows.len());
    for (signal, name) in expected.names.iter().enumerate() {
        let then = || expected.rows.iter().map(|row| row[signal + 1]);
        let scale = then().map(f64::abs).fold(0.0, f64::max);
        for (now, then) in found.iter().map(|row| row[signal]).zip(then()) {
            // The same binary gets the same calls; 1e-9 leaves room for the rounding of the inputs
            // between two rows.
            assert!((now - then).abs() <= 1e-9 * scale, "{model}: {name}: {now} was {then}");
        }
    }
}

#[test]
fn the_vehicle_gives_its_reference_result() {
    replay("vehicle");
}

#[test]
fn the_train_gives_its_reference_result() {
    replay("longitudinal");
}

#[test]
fn the_rail_gives_its_reference_result() {
    replay("railheat");
}

#[test]
fn the_controller_gives_its_reference_result() {
    replay("synchronisation");
}
