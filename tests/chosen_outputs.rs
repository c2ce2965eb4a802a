//! Which outputs a run records, and its tables as CSV.

use std::path::Path;

use hotfoot::recording::SeriesReader;
use hotfoot_tests::SmallScenario;
use hotfoot_tests::probe::{Package, component, connections};

/// Two probes, of which the first one's y goes to the second one's u.
fn chain() -> Package {
    let elements = component("a", &[("u", 1.0)]) + &component("b", &[]);
    let system =
        format!("<ssd:Elements>{elements}</ssd:Elements>") + &connections(&[("a.y", "b.u", "")]);
    Package::new(&system, &[])
}

fn columns(results: &Path, table: &str) -> Vec<String> {
    let table = SeriesReader::open(&results.join("series"), table).unwrap();
    table.columns().skip(1).map(|column| column.name().clone()).collect()
}

fn tables(results: &Path) -> Vec<String> {
    hotfoot::recording::table_names(&results.join("series")).unwrap().into_iter().collect()
}

/// What is connected is recorded; of the last component, of which nothing is, all.
#[test]
fn a_package_records_what_is_connected_or_asked_for() {
    let package = chain();
    package.run_well(&[]);
    let all = columns(&package.results(), "b");
    assert_eq!(columns(&package.results(), "a"), ["y"]);
    assert!(all.contains(&"y".to_owned()));
    package.run_well(&["--record", "b.y"]);
    assert_eq!(tables(&package.results()), ["b"]);
    assert_eq!(columns(&package.results(), "b"), ["y"]);
    package.run_well(&["--record", "*"]);
    assert_eq!(columns(&package.results(), "a"), all);
}

#[test]
fn a_pattern_that_no_output_fits_is_answered_with_the_nearest() {
    let package = chain();
    for (pattern, wanted) in [
        ("a.yy", "--record 'a.yy': no output that is a number has this name; did you mean `a.y`?"),
        ("*.yy", "did you mean `*.y`?"),
        ("nothing", "there are outputs of a, b"),
    ] {
        let output = package.run(&["--record", pattern]);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && message.contains(wanted), "{message}");
    }
    let mut scenario = SmallScenario::new(0.05);
    scenario.leave_out_heat();
    let output = scenario.run(&["--record", "*.derailment_quotien"]);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    let wanted = "did you mean `*.derailment_quotient`?";
    assert!(!output.status.success() && message.contains(wanted), "{message}");
}

/// The values of the CSV are those of the Parquet, digit by digit, and the names of the keys are there.
#[test]
fn csv_has_what_the_tables_have() {
    let mut scenario = SmallScenario::new(0.2);
    scenario.leave_out_heat();
    scenario.run_well(&["--record", "body.vertical", "--csv"]);
    let read =
        |name: &str| std::fs::read_to_string(scenario.results().join("csv").join(name)).unwrap();
    let series = scenario.results().join("series");
    let table = SeriesReader::open(&series, "outputs").unwrap();
    let expected = table.read("body.vertical", &[]).unwrap();
    let text = read("outputs.csv");
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!(names[..3], ["time", "vehicle", "body.vertical"]);
    let found: Vec<f64> =
        lines.map(|line| line.split(',').nth(2).unwrap().parse().unwrap()).collect();
    assert_eq!(found, expected);
    assert!(read("wheels.csv").lines().nth(1).unwrap().starts_with("0.0,1,1,left,"));
    assert!(read("columns.csv").contains("\nvehicles,velocity,m/s,"));
    std::fs::remove_dir_all(scenario.results().join("csv")).unwrap();
    let again = scenario.hotfoot(&["report", "results", "--csv"]);
    assert!(again.status.success(), "{}", String::from_utf8_lossy(&again.stderr));
    assert_eq!(read("outputs.csv"), text);
}
