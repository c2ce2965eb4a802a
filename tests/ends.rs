//! Every end of a run, however it comes: what is told, the exit code, the records, and what stays behind.
//!
//! | file | the end |
//! |---|---|
//! | `ends/blame.rs` | an FMU that crashes, ends its process or never returns; killed from outside |
//! | `ends/signals.rs` | Ctrl-C, SIGTERM, SIGHUP, a closed terminal |
//! | `ends/kills.rs` | the program, its child or both are killed at any moment |
//! | `ends/left_behind.rs` | every misbehaviour of an FMU: no process and no temporary file stays |
//! | `ends/folders.rs` | a folder that is in use, has results, or whose run does not start |
//! | `ends/disk.rs` | a full disk, a read-only or removed folder, no more open files, a closed pipe |
//!
//! `hotfoot` runs packages of FMUs in C here, which start in an instant.

mod blame;
mod disk;
mod folders;
pub mod kills;
mod left_behind;
mod signals;

use std::path::Path;
use std::process::{Child, Output};
use std::time::{Duration, Instant};

use hotfoot_tests::package::HostilePackage;

/// The longest time that a test waits for what must come, s.
const PATIENCE: Duration = Duration::from_secs(120);

/// What a program has said on its terminal, on one line.
fn said(output: &Output) -> String {
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!text.contains("panicked"), "{text}");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn assert_says(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "'{part}' is missing in: {text}");
    }
}

/// Waits until something has happened.
pub fn wait_until(what: &str, happened: impl Fn() -> bool) {
    let begin = Instant::now();
    while !happened() {
        assert!(begin.elapsed() < PATIENCE, "{what}: it has not happened");
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// Starts a run and waits until it has recorded something.
pub fn start(package: &HostilePackage, further: &[&str]) -> Child {
    let mut command = package.command(further);
    command.stderr(std::process::Stdio::piped()).stdout(std::process::Stdio::piped());
    let run = command.spawn().expect("the program starts");
    wait_until("the first part of a table", || {
        package.results().join("series/b.parts/part-00000.parquet").exists()
    });
    run
}

/// The child of a process, which computes.
pub fn child_of(process: u32) -> Option<u32> {
    let children = format!("/proc/{process}/task/{process}/children");
    let children = std::fs::read_to_string(children).unwrap_or_default();
    children.split_whitespace().next().map(|child| child.parse().expect("a number"))
}

/// Sends a signal to processes.
pub fn send(signal: &str, processes: &[u32]) {
    let processes = processes.iter().map(u32::to_string);
    let kill =
        std::process::Command::new("kill").arg(format!("-{signal}")).args(processes).output();
    kill.expect("the command kill");
}

/// Whether a thread of a process computes, waits or is held: what has ended and is not yet taken notice of does
/// not. As long as one does, the process holds its files.
pub fn is_running(process: u32) -> bool {
    let threads = std::fs::read_dir(format!("/proc/{process}/task"));
    let is_there = |thread: std::fs::DirEntry| {
        let stat = std::fs::read_to_string(thread.path().join("stat")).unwrap_or_default();
        let state = stat.rsplit_once(") ").map(|(_, rest)| rest.chars().next());
        state.is_some_and(|state| state != Some('Z') && state != Some('X'))
    };
    threads.into_iter().flatten().flatten().any(is_there)
}

/// The manifest of a run.
fn manifest(results: &Path) -> toml::Table {
    std::fs::read_to_string(results.join("manifest.toml"))
        .expect("a manifest")
        .parse()
        .expect("TOML")
}

/// The results are complete: a file for each table, a report, and how the run ended.
fn assert_complete(results: &Path, end: &str) {
    let manifest = manifest(results);
    assert_eq!(manifest["end"].as_str(), Some(end), "{manifest:?}");
    assert!(results.join("report.html").exists());
    for table in ["a", "b"] {
        let series = results.join("series");
        assert!(series.join(format!("{table}.parquet")).exists());
        assert!(!series.join(format!("{table}.parts")).exists());
    }
    assert!(!results.join(".hotfoot-run").exists(), "the folder is free");
}
