//! A run that is killed, and what its results are compared by.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Duration;

/// Runs the program in `folder`, and kills it and all its children with signal 9 when the run into the folder
/// `results` in it has written its checkpoint of that number, or of number 0, is about to begin.
///
/// # Panics
/// When the run ends before.
pub fn kill_at(folder: &Path, arguments: &[&str], results: &str, number: u64) {
    kill(&mut run_until(folder, arguments, results, number));
}

/// Runs the program and lets it stop by Ctrl-C (SIGINT) at such a checkpoint; gives its exit code.
///
/// # Panics
/// When the run ends before.
pub fn interrupt_at(folder: &Path, arguments: &[&str], results: &str, number: u64) -> Option<i32> {
    let run = run_until(folder, arguments, results, number);
    let status = Command::new("kill").args(["-INT", &run.id().to_string()]).status();
    assert!(status.expect("a program `kill`").success());
    run.wait_with_output().expect("it is our child").status.code()
}

/// Starts the program and waits for the checkpoint.
fn run_until(folder: &Path, arguments: &[&str], results: &str, number: u64) -> Child {
    let mut command = crate::command(folder, arguments);
    let run = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped()).spawn();
    let mut run = run.expect("the program is there");
    let checkpoints = folder.join(results).join("checkpoint");
    while newest(&checkpoints) < Some(number) {
        if let Some(status) = run.try_wait().expect("it is our child") {
            let said = std::io::read_to_string(run.stderr.take().expect("a pipe"));
            panic!("{status} before checkpoint {number}: {said:?}");
        }
        thread::sleep(Duration::from_millis(1));
    }
    run
}

/// Number of the newest checkpoint in a folder, or 0 where there is only the order to run.
pub fn newest(checkpoints: &Path) -> Option<u64> {
    let names = std::fs::read_dir(checkpoints).ok()?.flatten().map(|entry| entry.file_name());
    let number = |name: std::ffi::OsString| match name.to_str()? {
        "run.toml" => Some(0),
        name => name.strip_suffix(".state")?.parse().ok(),
    };
    names.filter_map(number).max()
}

fn kill(run: &mut Child) {
    let id = run.id().to_string();
    // Any of its threads may have started the child.
    let threads = std::fs::read_dir(format!("/proc/{id}/task")).expect("it runs");
    let children = threads.flatten().map(|thread| thread.path().join("children"));
    let children: String = children.flat_map(std::fs::read_to_string).collect();
    // The parent last, so that it cannot complete anything: it stands still meanwhile.
    let signal = |signal: &str, ids: &mut dyn Iterator<Item = &str>| {
        let status = Command::new("kill").arg(signal).args(ids).status();
        assert!(status.expect("a program `kill`").success() || signal == "-KILL");
    };
    signal("-STOP", &mut [id.as_str()].into_iter());
    if !children.trim().is_empty() {
        signal("-KILL", &mut children.split_whitespace());
    }
    signal("-KILL", &mut [id.as_str()].into_iter());
    run.wait().expect("it is our child");
}

/// All files of a folder of results by their names, with their bytes; of manifest and report without wall times,
/// threads, the time and the command of the run, and the folder itself.
///
/// # Panics
/// When it cannot be read.
pub fn contents(results: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut folders = vec![results.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("it is readable") {
            let path = entry.expect("it is readable").path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let name = path.strip_prefix(results).expect("it lies below").to_owned();
            let bytes = std::fs::read(&path).expect("it is readable");
            let told = ["manifest.toml", "report.html"].iter().any(|told| name == Path::new(told));
            files.insert(name, if told { without_wall_times(&bytes, results) } else { bytes });
        }
    }
    files
}

fn without_wall_times(text: &[u8], results: &Path) -> Vec<u8> {
    let mut text = String::from_utf8_lossy(text).replace(&results.display().to_string(), "RESULTS");
    for section in ["<h2>Wall time</h2>", "<h2>What was run</h2>"] {
        if let Some(begin) = text.find(section) {
            let end = text[begin..].find("</section>").expect("a section ends");
            text.replace_range(begin..begin + end, "");
        }
    }
    let mut lines: Vec<&str> = vec![];
    let mut of_wall_time = false;
    for line in text.lines() {
        // A figure of the manifest is a table of several lines, of which the first is its name.
        of_wall_time = match line {
            "name = \"Wall time\"" => true,
            _ => of_wall_time && !line.starts_with('['),
        };
        let beginnings = [
            "threads = ",
            "wall_time_s = ",
            "slowest_",
            "recording_s = ",
            "seconds = ",
            "begun = ",
            "command = ",
        ];
        let wall = line.contains("Wall time") || line.contains(" threads");
        if !(of_wall_time || wall || beginnings.iter().any(|start| line.starts_with(start))) {
            lines.push(line);
        }
    }
    lines.join("\n").into_bytes()
}
