//! A temperature field that is lost in the middle of a run, as on a disk that fills up or by a folder that
//! somebody removes: the run stops or goes on by the scenario's choice, says so, and loses nothing else.

use std::fs;
use std::path::Path;
use std::process::Output;
use std::thread;
use std::time::Duration;

use field::FieldReader;
use hotfoot::recording::SeriesReader;
use hotfoot_tests::SmallScenario;

/// Simulated time, s: a run of a second or two, while which there is time to interfere.
const RUN: f64 = 30.0;

/// The snapshot, one a second, for which there is no room.
const LOST: usize = 20;

/// Two vehicles on a rail of 60 m whose field is written every second.
fn scenario(failure: &str) -> SmallScenario {
    let keys = format!("field_interval_s = 1.0\nfield_failure = \"{failure}\"");
    SmallScenario::heating_a_short_rail(RUN, &keys, "")
}

/// Runs a scenario, and does something to its field between two snapshots, once it has some.
fn run_and(scenario: &SmallScenario, interfere: impl FnOnce(&Path)) -> Output {
    let field = scenario.results().join("rail.zarr");
    thread::scope(|scope| {
        let run = scope.spawn(|| scenario.run(&[]));
        // The times of a snapshot are written after it: while it is written it has none.
        let snapshots = || FieldReader::open(&field).map_or(0, |field| field.times().len());
        while snapshots() < 2 {
            assert!(!run.is_finished(), "the run ended before its field had begun");
            thread::sleep(Duration::from_millis(1));
        }
        // The last file of a snapshot follows its times at once; the next snapshot is some 50 ms away.
        thread::sleep(Duration::from_millis(5));
        interfere(&field);
        run.join().unwrap()
    })
}

/// Leaves no room for one snapshot: what is written to `/dev/full` finds the disk full.
fn fill_the_disk(field: &Path) {
    let snapshot = field.join(format!("temperature_rise/c/{LOST}/0"));
    fs::create_dir_all(&snapshot).unwrap();
    std::os::unix::fs::symlink("/dev/full", snapshot.join("0")).unwrap();
}

/// Takes the whole field away.
fn take_away(field: &Path) {
    fs::rename(field, field.with_file_name("elsewhere")).unwrap();
}

fn last_time_of(table: &str, scenario: &SmallScenario) -> f64 {
    let table = SeriesReader::open(&scenario.results().join("series"), table).unwrap();
    *table.read("time", &[]).unwrap().last().unwrap()
}

/// The run stops at the snapshot that finds no room, in a sentence with the reason; what came before is
/// complete: snapshots, series, manifest, and a report can be made.
#[test]
fn a_full_disk_stops_the_run_and_what_came_before_is_kept() {
    let scenario = scenario("stop");
    let output = run_and(&scenario, fill_the_disk);
    let said = String::from_utf8_lossy(&output.stderr).replace('\n', " ");
    assert!(!output.status.success(), "{said}");
    for part in ["at 19.999 s", "rail.zarr", "No space left on device", "results until then"] {
        assert!(said.contains(part), "{part} in {said}");
    }
    let field = FieldReader::open(&scenario.results().join("rail.zarr")).unwrap();
    assert_eq!(field.times().len(), LOST);
    for table in ["train", "vehicles", "wheels", "rail"] {
        let last = last_time_of(table, &scenario);
        assert!((last - 19.9).abs() < 1e-9, "{table}: records every 0.1 s, the last at {last} s");
    }
    let report = scenario.hotfoot(&["report", "results"]);
    assert!(report.status.success(), "{}", String::from_utf8_lossy(&report.stderr));
}

/// The run goes on to its end without the field and says so on the terminal, in the manifest and in the report.
#[test]
fn a_run_goes_on_without_the_field_if_the_scenario_wants_it() {
    for (loss, reason, snapshots) in [
        (fill_the_disk as fn(&Path), "No space left on device", Some(LOST)),
        (take_away, "is no longer there", None),
    ] {
        let scenario = scenario("go-on");
        let output = run_and(&scenario, loss);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let results = scenario.results();
        let manifest = fs::read_to_string(results.join("manifest.toml")).unwrap();
        let report = fs::read_to_string(results.join("report.html")).unwrap();
        let terminal = String::from_utf8_lossy(&output.stdout);
        for place in [&*terminal, &manifest, &report] {
            assert!(place.contains(reason), "{reason} in {place}");
            assert!(place.contains("the run goes on without writing the field"), "{place}");
        }
        for table in ["train", "vehicles", "wheels", "rail"] {
            assert_eq!(last_time_of(table, &scenario), RUN, "{table}");
        }
        let field = FieldReader::open(&results.join("rail.zarr"));
        assert_eq!(field.ok().map(|field| field.times().len()), snapshots, "half a store is none");
    }
}

/// A field that is taken away stops the run too; what a snapshot may have left there, if it was just being written,
/// does not pass for a field.
#[test]
fn a_field_that_is_taken_away_stops_the_run() {
    let scenario = scenario("stop");
    let output = run_and(&scenario, take_away);
    let said = String::from_utf8_lossy(&output.stderr).replace('\n', " ");
    assert!(!output.status.success() && said.contains("is no longer there"), "{said}");
    assert!(FieldReader::open(&scenario.results().join("rail.zarr")).is_err());
    assert!(!FieldReader::open(&scenario.results().join("elsewhere")).unwrap().times().is_empty());
    assert!(last_time_of("rail", &scenario) > 0.9);
}
