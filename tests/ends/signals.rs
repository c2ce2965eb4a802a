//! Signals that end a run in order: it stops at its next step and completes its results.

use std::process::{Child, Command, Output, Stdio};
use std::time::Instant;

use hotfoot_tests::package::{HostilePackage, times};

use super::{assert_complete, assert_says, child_of, is_running, said, send, start, wait_until};

/// A run of a quarter of an hour.
const LONG: [&str; 2] = ["--duration", "1000"];

/// The results are those of a run that was stopped, and nothing else is left.
fn assert_stopped(package: &HostilePackage, output: &Output, code: i32, by: &str) {
    let said = said(output);
    assert_eq!(output.status.code(), Some(code), "{said}");
    let results = package.results().display().to_string();
    assert_says(&said, &["interrupted by", by, "the results until then are in", &results]);
    assert_complete(&package.results(), "interrupted");
    assert!(times(&package.results()).len() > 1);
    assert!(package.left().is_empty());
}

#[test]
fn a_signal_stops_the_run_at_its_next_step() {
    for (signal, code) in [("INT", 130), ("TERM", 143), ("HUP", 129)] {
        let package = HostilePackage::new("SLOW");
        let run = start(&package, &LONG);
        send(signal, &[run.id()]);
        let output = run.wait_with_output().unwrap();
        assert_stopped(&package, &output, code, &format!("SIG{signal}"));
        let manifest = super::manifest(&package.results());
        let reason = manifest["end_reason"].as_str().unwrap();
        assert_says(reason, &["interrupted by", &format!("SIG{signal}")]);
        // The last record is the last that was due before the time of the stop.
        let stop: f64 = manifest["simulated_s"].as_float().unwrap();
        let last = *times(&package.results()).last().unwrap();
        assert!(
            stop - last < 0.01 + 1e-9 && stop >= last,
            "stopped at {stop} s, recorded {last} s"
        );
    }
}

/// A terminal sends Ctrl-C to both processes.
#[test]
fn a_signal_that_the_child_gets_too_counts_once() {
    let package = HostilePackage::new("SLOW");
    let run = start(&package, &LONG);
    send("INT", &[run.id(), child_of(run.id()).unwrap()]);
    assert_stopped(&package, &run.wait_with_output().unwrap(), 130, "Ctrl-C (SIGINT)");
}

/// An FMU that never returns keeps the run from stopping; a second Ctrl-C ends it at once, and its results
/// can be completed.
#[test]
fn a_second_signal_ends_the_run_at_once() {
    let package = HostilePackage::new("ENDS(BY_LOOP,AT_STEP)");
    let mut command = package.command(&LONG);
    let run = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    let open = package.results().join("series/b.parts/.open.arrows");
    wait_until("the records until 0.05 s", || open.exists());
    std::thread::sleep(std::time::Duration::from_millis(300));
    send("INT", &[run.id()]);
    std::thread::sleep(std::time::Duration::from_millis(300));
    assert!(is_running(run.id()), "it waits for the FMU");
    let begin = Instant::now();
    send("INT", &[run.id()]);
    let output = run.wait_with_output().unwrap();
    assert!(begin.elapsed().as_secs() < 5, "at once");
    assert_eq!(output.status.code(), Some(130));
    assert_says(
        &said(&output),
        &["Ctrl-C (SIGINT) again", "`hotfoot report", "completes its results"],
    );
    assert!(package.left().is_empty());
    assert!(package.program(&["report", "results"]).output().unwrap().status.success());
    assert_eq!(times(&package.results()).len(), 6);
    assert_complete(&package.results(), "killed");
}

/// Before the first record there is nothing to complete.
#[test]
fn a_signal_before_the_first_record_leaves_nothing() {
    let package = HostilePackage::new("ENDS(BY_LOOP,AT_INIT)");
    let mut command = package.command(&LONG);
    let run = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    wait_until("the manifest", || package.results().join("manifest.toml").exists());
    send("TERM", &[run.id()]);
    let output = run.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(143));
    assert_says(&said(&output), &["interrupted by SIGTERM; nothing was recorded before"]);
    assert!(!package.results().exists() && package.left().is_empty());
}

/// The terminal of a run, which is closed while it goes on: `script` makes one, and takes it along when it is
/// killed.
#[test]
fn a_closed_terminal_stops_the_run() {
    let package = HostilePackage::new("SLOW");
    let hotfoot = package.command(&LONG);
    let words = [hotfoot.get_program()].into_iter().chain(hotfoot.get_args());
    let words: Vec<_> = words.map(|word| word.to_str().unwrap()).collect();
    let line = words.join(" ").replace(" --quiet", "");
    let mut terminal = Command::new("script");
    terminal.args(["-q", "-c", &format!("exec {line}"), "/dev/null"]);
    terminal.current_dir(package.folder.path()).env("TMPDIR", package.temporary());
    let mut terminal: Child =
        terminal.stdin(Stdio::null()).stdout(Stdio::null()).spawn().expect("the command script");
    wait_until("the first part of a table", || {
        package.results().join("series/b.parts/part-00000.parquet").exists()
    });
    let run = child_of(terminal.id()).expect("the run");
    terminal.kill().unwrap();
    terminal.wait().unwrap();
    wait_until("the end of the run", || !is_running(run));
    assert_complete(&package.results(), "interrupted");
    assert!(times(&package.results()).len() > 1 && package.left().is_empty());
}

/// `nohup` has the end of the terminal ignored.
#[test]
fn a_run_under_nohup_goes_on_without_its_terminal() {
    let package = HostilePackage::new("SLOW");
    let hotfoot = package.command(&["--duration", "2"]);
    let mut command = Command::new("nohup");
    command.arg(hotfoot.get_program()).args(hotfoot.get_args()).current_dir(package.folder.path());
    let mut run = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    wait_until("the first part of a table", || {
        package.results().join("series/b.parts/part-00000.parquet").exists()
    });
    send("HUP", &[run.id(), child_of(run.id()).unwrap()]);
    assert!(run.wait().unwrap().success());
    assert_complete(&package.results(), "complete");
}
