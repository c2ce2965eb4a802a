//! The program, its child or both are killed at any moment (kill −9): what was recorded is there.
//!
//! `cargo xtask crash-test COUNT` sets the number of kills.

use std::fs::{self, File};
use std::path::Path;
use std::process::{Child, Stdio};
use std::time::Duration;

use arrow_ipc::reader::StreamReader;
use hotfoot::recording::SeriesReader;
use hotfoot_tests::package::{HostilePackage, times};

use super::{child_of, is_running, send, wait_until};

/// Kills in the quick tests.
const FEW: u64 = 9;

/// Which processes are killed.
#[derive(Debug, Clone, Copy)]
pub enum Killed {
    Child,
    Parent,
    Both,
}

/// The kills of a test: whom, and how long after the start, spread over this time.
pub fn kills(longest: Duration) -> impl Iterator<Item = (Killed, Duration)> {
    let kills = std::env::var("HOTFOOT_KILLS").ok();
    let kills = kills.map_or(FEW, |kills| kills.parse().expect("HOTFOOT_KILLS is a number"));
    let longest = u64::try_from(longest.as_micros()).expect("a short time");
    (0..kills).map(move |kill| {
        let who = [Killed::Child, Killed::Parent, Killed::Both][kill as usize % 3];
        // Multiples of the golden ratio fill a range evenly.
        (who, Duration::from_micros(kill.wrapping_mul(0x9E37_79B9_7F4A_7C15) % longest))
    })
}

impl Killed {
    /// Kills what is to be killed of a run and waits for the end of all of it. While both processes are held, so
    /// that they leave the files alone, `look` looks at these; gives what it has found, and whether the run had
    /// ended before.
    pub fn kill<T>(self, run: &mut Child, look: impl FnOnce() -> T) -> (T, bool) {
        let (parent, child) = (run.id(), child_of(run.id()));
        let both: Vec<u32> = [parent].into_iter().chain(child).collect();
        send("STOP", &both);
        let found = look();
        let had_ended = run.try_wait().unwrap().is_some();
        match self {
            Self::Child => send("KILL", &child.map_or(vec![parent], |child| vec![child])),
            Self::Parent => send("KILL", &[parent]),
            Self::Both => send("KILL", &both),
        }
        send("CONT", &both);
        run.wait().unwrap();
        wait_until("the end of all processes", || !both.iter().any(|&own| is_running(own)));
        (found, had_ended)
    }
}

#[test]
fn a_kill_at_any_moment_loses_no_whole_record() {
    let (mut count, mut recorded) = (0, 0);
    // Two seconds and a bit are steps.
    for (who, moment) in kills(Duration::from_millis(2500)) {
        let package = HostilePackage::new("SLOW");
        count += 1;
        recorded += usize::from(kill_at(&package, who, moment) > 0);
    }
    assert!(recorded > count / 3, "most kills come after the first record");
}

/// Kills a run after a time, completes its results, and gives their number of records.
fn kill_at(package: &HostilePackage, who: Killed, moment: Duration) -> usize {
    let mut command = package.command(&["--duration", "2"]);
    let mut run = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    std::thread::sleep(moment);
    let (whole, had_ended) = who.kill(&mut run, || whole_records(&package.results()));
    let circumstances = format!("{who:?} killed after {moment:?}, {whole} whole records");

    let report = package.program(&["report", "results"]).output().unwrap();
    assert!(package.left().is_empty(), "{circumstances}: {:?}", package.left());
    let said = String::from_utf8_lossy(&report.stderr).into_owned();
    if !report.status.success() {
        assert_eq!(whole, 0, "{circumstances}: {said}");
        let nothing = !package.results().join("manifest.toml").exists()
            || said.contains("has recorded nothing");
        assert!(nothing, "{circumstances}: {said}");
        return 0;
    }
    let times = times(&package.results());
    assert!(times.len() >= whole, "{circumstances}: {} records are left", times.len());
    let due = |k: usize| k as f64 * 10.0 * 1e-3;
    assert!(times.iter().enumerate().all(|(k, &time)| (time - due(k)).abs() < 1e-9), "{times:?}");
    let end = super::manifest(&package.results())["end"].as_str().unwrap().to_owned();
    assert!(end != "complete" || had_ended || times.len() == 201, "{circumstances}: {end}");
    super::assert_complete(&package.results(), &end);
    times.len()
}

/// Records that are whole in both tables, as they lie in the files.
fn whole_records(results: &Path) -> usize {
    let series = results.join("series");
    let records = |table: &str| {
        let in_parts = SeriesReader::open(&series, table).and_then(|table| table.read("time", &[]));
        let mut times = in_parts.unwrap_or_default();
        let open = File::open(series.join(format!("{table}.parts/.open.arrows"))).ok();
        let open = open.and_then(|file| StreamReader::try_new(file, None).ok());
        // What a part has already may still lie in the stream.
        let last = times.last().copied().unwrap_or(-1.0);
        for batch in open.into_iter().flatten().map_while(Result::ok) {
            let column = batch.column(0).to_data();
            let values: &[f64] = column.buffer(0);
            times.extend(values.iter().filter(|&&time| time > last));
        }
        times.len()
    };
    records("a").min(records("b"))
}

/// The folder of a run that goes on is not completed under its hands.
#[test]
fn a_report_of_a_run_that_goes_on_leaves_it_alone() {
    let package = HostilePackage::new("SLOW");
    let run = super::start(&package, &["--duration", "4"]);
    let report = package.program(&["report", "results"]).output().unwrap();
    assert!(report.status.success());
    assert!(String::from_utf8_lossy(&report.stderr).contains("the run goes on"));
    assert!(run.wait_with_output().unwrap().status.success());
    assert_eq!(times(&package.results()).len(), 401);
    super::assert_complete(&package.results(), "complete");
}

/// A train with its vehicles, a heated rail and a field: both processes are killed.
#[test]
fn a_train_that_was_killed_is_completed_with_its_field() {
    let keys = "field_interval_s = 0.1";
    let scenario = hotfoot_tests::SmallScenario::heating_a_short_rail(30.0, keys, "");
    let mut run = scenario.command(&[]).stdout(Stdio::null()).spawn().unwrap();
    let results = scenario.results();
    wait_until("the second part", || results.join("series/rail.parts/part-00001.parquet").exists());
    send("KILL", &[run.id(), child_of(run.id()).unwrap()]);
    run.wait().unwrap();
    assert!(scenario.hotfoot(&["report", "results"]).status.success());
    let last = |table: &str| {
        let table = SeriesReader::open(&results.join("series"), table).unwrap();
        *table.read("time", &[]).unwrap().last().unwrap()
    };
    let end = last("vehicles");
    assert!(end > 1.5 && ["train", "wheels", "rail"].iter().all(|table| last(table) == end));
    let field = field::FieldReader::open(&results.join("rail.zarr")).unwrap();
    assert!(*field.times().last().unwrap() > end - 0.2);
    assert!(fs::read_dir(results.join("series")).unwrap().count() == 4, "no parts are left");
}
