//! The package of a scenario, run by Hotfoot, gives the bits of the scenario's own run: rates, stages and
//! means stand in its annotations.
//!
//! All shipped scenarios with vehicles, which takes a quarter of an hour: `cargo xtask packages`.

use std::path::{Path, PathBuf};

use hotfoot::recording::{KeyValue, SeriesReader};
use hotfoot_tests::{SmallScenario, hotfoot, root};

use crate::scenarios::shipped;

/// Time between two records, s.
const INTERVAL: &str = "0.1";

#[test]
fn property_packages_of_short_trains_give_the_bits_of_their_scenarios() {
    for name in ["acceptance-sine", "wet-rail"] {
        compare(&root().join("scenarios").join(name).join("scenario.toml"), "0.5");
    }
}

/// A rail that steps at every fourth point of the exchange, both rails, and the scheme in which all
/// values are exchanged at once.
#[test]
fn property_packages_keep_rates_and_both_schemes() {
    for (scheme, rail) in [("sequential", "both"), ("jacobi", "right")] {
        let mut scenario = SmallScenario::new(0.4);
        scenario.text = scenario.text.replace("count = 4", "count = 1").replace(
            "[heat]\n",
            &format!("[heat]\nrail = \"{rail}\"\nstep_s = 0.004\ndepths_mm = []\n"),
        );
        scenario.text = scenario
            .text
            .replace("step_s = 0.001\n", &format!("step_s = 0.001\nscheme = \"{scheme}\"\n"));
        scenario.hotfoot(&["schema"]);
        compare(&scenario.folder.path().join("scenario.toml"), "0.4");
    }
}

#[test]
#[ignore = "takes a quarter of an hour"]
fn property_packages_of_all_shipped_scenarios_give_their_bits() {
    let has_vehicles = |file: &PathBuf| {
        let text = std::fs::read_to_string(file).unwrap();
        !text.lines().any(|line| line.starts_with("train_alone = true"))
    };
    let scenarios: Vec<_> = shipped().into_iter().filter(has_vehicles).collect();
    assert!(scenarios.len() >= 20, "only {} scenarios were found", scenarios.len());
    for scenario in scenarios {
        eprintln!("{}", scenario.display());
        compare(&scenario, "2.0");
    }
}

/// Runs the scenario in `file` and its package for a time, s, and compares all values that both record.
fn compare(file: &Path, duration: &str) {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let run = |arguments: &[&str]| {
        let output = hotfoot(root(), arguments);
        let text = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}: {text}", file.display());
    };
    let (file, package) = (file.to_str().unwrap(), path("package.ssp"));
    run(&["export-ssp", file, "-o", &package]);
    let all: &[&str] = &["--record", "*"];
    for (what, results, more) in
        [(file, path("scenario"), &[][..]), (&package, path("package"), all)]
    {
        let times = ["--duration", duration, "--interval", INTERVAL];
        run(&[&["run", what, "--quiet", "--results", &results][..], &times, more].concat());
    }
    let results = Results {
        file: file.to_owned(),
        scenario: folder.path().join("scenario/series"),
        package: folder.path().join("package/series"),
    };
    results.compare_train();
    results.compare_vehicles();
    results.compare_wheels();
    results.compare_rails();
}

/// The series of both runs.
struct Results {
    file: String,
    scenario: PathBuf,
    package: PathBuf,
}

/// Columns that the scenario's tables have beside the values themselves.
fn is_value(column: &str) -> bool {
    !["time", "vehicle", "wheelset", "side", "rail"].contains(&column)
        && !["_min", "_max", "_mean"].iter().any(|end| column.ends_with(end))
}

impl Results {
    fn of_scenario(&self, table: &str) -> SeriesReader {
        SeriesReader::open(&self.scenario, table).unwrap()
    }

    fn of_package(&self, component: &str) -> SeriesReader {
        SeriesReader::open(&self.package, component).unwrap()
    }

    /// Compares a column of the scenario's table with that of a component of the package, as it is
    /// kept in the former.
    fn compare(
        &self,
        (table, column, keys): (&SeriesReader, &str, &[(&str, KeyValue<'_>)]),
        (component, variable): (&SeriesReader, &str),
    ) {
        let found = component.read(variable, &[]).unwrap();
        // What follows the run for the rails is not in the package.
        let end = *component.read("time", &[]).unwrap().last().unwrap();
        let records =
            table.read("time", keys).unwrap().into_iter().zip(table.read(column, keys).unwrap());
        let of_run = records.filter(|(time, _)| *time <= end).map(|(_, value)| value);
        let expected: Vec<f64> = of_run.collect();
        let single = table.columns().find(|other| other.name() == column).unwrap();
        let single = single.data_type().to_string() == "Float32";
        let bits = |value: &f64| if single { f64::from(*value as f32) } else { *value }.to_bits();
        let [expected, found] = [&expected, &found].map(|v| v.iter().map(bits).collect::<Vec<_>>());
        assert!(expected.len() > 3, "{}: {column} has {} records", self.file, expected.len());
        assert_eq!(expected, found, "{}: {column} {keys:?} {variable}", self.file);
    }

    fn compare_train(&self) {
        let (table, component) = (self.of_scenario("train"), self.of_package("train"));
        let names: Vec<String> = table.columns().map(|column| column.name().clone()).collect();
        for name in names.iter().filter(|name| is_value(name)) {
            self.compare((&table, name, &[]), (&component, name));
        }
    }

    /// The numbers of the vehicles of a table.
    fn vehicles(&self, table: &SeriesReader) -> Vec<i32> {
        let mut numbers = table.read("vehicle", &[]).unwrap();
        numbers.sort_unstable_by(f64::total_cmp);
        numbers.dedup();
        numbers.iter().map(|number| *number as i32).collect()
    }

    fn compare_vehicles(&self) {
        let (table, train) = (self.of_scenario("vehicles"), self.of_package("train"));
        for number in self.vehicles(&table) {
            let component = self.of_package(&format!("vehicle_{number}"));
            let keys = [("vehicle", KeyValue::Integer(number))];
            for name in ["position", "velocity"] {
                self.compare((&table, name, &keys), (&component, name));
                let in_train = format!("vehicle[{number}].{name}");
                self.compare((&table, &format!("train_{name}"), &keys), (&train, &in_train));
            }
        }
    }

    fn compare_wheels(&self) {
        let table = self.of_scenario("wheels");
        for number in self.vehicles(&table) {
            let component = self.of_package(&format!("vehicle_{number}"));
            for (side, wheelset) in [("left", 1), ("right", 2)] {
                let keys = [
                    ("vehicle", KeyValue::Integer(number)),
                    ("wheelset", KeyValue::Integer(wheelset)),
                    ("side", KeyValue::Text(side)),
                ];
                for (column, variable) in [
                    ("creepage_longitudinal", "creepage.longitudinal"),
                    ("creepage_spin", "creepage.spin"),
                    ("force_lateral", "force.lateral"),
                    ("force_normal", "force.normal"),
                    ("friction_power", "friction_power"),
                    ("contact_lateral_position", "contact.lateral_position"),
                ] {
                    let variable = format!("wheelset[{wheelset}].{side}.{variable}");
                    self.compare((&table, column, &keys), (&component, &variable));
                }
            }
        }
    }

    fn compare_rails(&self) {
        if !self.scenario.join("rail.parquet").exists() {
            return;
        }
        let table = self.of_scenario("rail");
        let names: Vec<String> = table.columns().map(|column| column.name().clone()).collect();
        let mut compared = 0;
        for side in ["left", "right"] {
            let keys = [("rail", KeyValue::Text(side))];
            if table.read("time", &keys).unwrap().is_empty() {
                continue;
            }
            let of_side = format!("rail_{side}");
            let component = match self.package.join(format!("{of_side}.parquet")).exists() {
                true => self.of_package(&of_side),
                false => self.of_package("rail"),
            };
            for name in names.iter().filter(|name| is_value(name)) {
                self.compare((&table, name, &keys), (&component, name));
            }
            compared += 1;
        }
        assert!(compared > 0, "{}: no rail was compared", self.file);
    }
}
