//! Disks and descriptors that run out, folders that cannot be written or are removed, pipes that are closed:
//! a sentence says what has failed, and whole records stay.

use std::fs;
use std::process::{Command, Output, Stdio};

use hotfoot_tests::package::{HostilePackage, times};

use super::{assert_says, said, start};

/// Runs a script in which `$HOTFOOT` is the program, with mounts of its own.
fn with_mounts(package: &HostilePackage, script: &str) -> Output {
    let hotfoot = package.program(&[]);
    let mut command = Command::new("unshare");
    command.args(["--user", "--map-root-user", "--mount", "sh", "-ec", script]);
    command.env("HOTFOOT", hotfoot.get_program()).env("TMPDIR", package.temporary());
    command.current_dir(package.folder.path()).output().expect("the command unshare")
}

const RUN: &str = "\"$HOTFOOT\" run hostile.ssp --quiet --interval 0.01 --results disk/results";

/// A disk of 1 MB that a file fills while the run goes on; what is on it is copied away afterwards, and
/// completed there.
#[test]
fn a_full_disk_ends_the_run_and_keeps_the_whole_records() {
    let package = HostilePackage::new("SLOW");
    let script = format!(
        "mkdir disk; mount -t tmpfs -o size=1m none disk; {RUN} --duration 100 & \
         until test -e disk/results/series/b.parts/part-00000.parquet; do sleep 0.05; done; \
         cat /dev/zero > disk/filler || true; code=0; wait $! || code=$?; \
         rm disk/filler; cp -a disk/results results; exit $code"
    );
    let output = with_mounts(&package, &script);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert_says(
        &said,
        &["Error: at ", "disk/results/series/", "No space left on device", "results until"],
    );
    let report = package.program(&["report", "results"]).output().unwrap();
    assert!(report.status.success(), "{}", super::said(&report));
    super::assert_complete(&package.results(), "failed");
    let manifest = super::manifest(&package.results());
    let reached = manifest["simulated_s"].as_float().unwrap();
    let last = *times(&package.results()).last().unwrap();
    assert!(last > 0.9 && reached - last < 0.02 + 1e-9, "reached {reached} s, recorded {last} s");
}

#[test]
fn a_full_disk_at_the_start_is_named() {
    let package = HostilePackage::new("WELL");
    let script = format!(
        "mkdir disk; mount -t tmpfs -o size=16k none disk; cat /dev/zero > disk/filler || true; \
         code=0; {RUN} || code=$?; ls -A disk; exit $code"
    );
    let output = with_mounts(&package, &script);
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    assert_says(&said(&output), &["Error: ", "disk/results", "No space left on device"]);
    assert_eq!(String::from_utf8_lossy(&output.stdout).trim(), "filler", "no folder is left");
}

#[test]
fn a_folder_that_cannot_be_written_is_named() {
    let package = HostilePackage::new("WELL");
    let script =
        format!("mkdir disk; mount -t tmpfs none disk; mount -o remount,ro,bind disk; {RUN}");
    let output = with_mounts(&package, &script);
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    assert_says(&said(&output), &["Error: ", "disk/results", "Read-only file system"]);
    assert!(package.left().is_empty());
}

#[test]
fn a_temporary_folder_that_cannot_be_written_is_named() {
    let package = HostilePackage::new("WELL");
    let mut command = package.command(&[]);
    let output = command.env("TMPDIR", "/proc/nowhere").output().unwrap();
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    assert_says(&said(&output), &["no temporary folder can be made in /proc/nowhere"]);
    assert!(!package.results().exists());
}

/// With any small number of open files the run works or says what it could not open.
#[test]
fn too_few_open_files_are_named() {
    let package = HostilePackage::new("WELL");
    let mut failed = 0;
    for files in (4..=24).step_by(2) {
        let script = format!("ulimit -n {files}; exec \"$0\" \"$@\"");
        let hotfoot = package.command(&["--overwrite"]);
        let mut command = Command::new("sh");
        command.args(["-c", &script]).arg(hotfoot.get_program()).args(hotfoot.get_args());
        command.current_dir(package.folder.path()).env("TMPDIR", package.temporary());
        let output = command.output().unwrap();
        let said = said(&output);
        if output.status.success() {
            assert_eq!(times(&package.results()).len(), 11, "{files} files");
        } else {
            assert_says(&said, &["open files"]);
            failed += 1;
        }
        assert!(package.left().is_empty(), "{files} files: {:?}", package.left());
    }
    assert!(failed > 0, "four open files are too few");
}

#[test]
fn a_file_that_may_not_grow_is_named() {
    let package = HostilePackage::new("WELL");
    let hotfoot = package.command(&[]);
    let mut command = Command::new("sh");
    let script = "ulimit -f 8; exec \"$0\" \"$@\"";
    command.args(["-c", script]).arg(hotfoot.get_program()).args(hotfoot.get_args());
    command.current_dir(package.folder.path()).env("TMPDIR", package.temporary());
    let output = command.output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert_says(&said(&output), &["File too large"]);
    assert!(package.left().is_empty());
}

#[test]
fn a_folder_that_is_removed_ends_the_run_with_its_name() {
    let package = HostilePackage::new("SLOW");
    let run = start(&package, &["--duration", "100"]);
    fs::rename(package.results(), package.folder.path().join("elsewhere")).unwrap();
    let output = run.wait_with_output().unwrap();
    let said = said(&output);
    assert_eq!(output.status.code(), Some(1), "{said}");
    let results = package.results().display().to_string();
    assert_says(&said, &["Error: at ", &results, "No such file or directory"]);
    assert!(package.left().is_empty() && !package.results().exists());
    // What was recorded before is whole where it is now.
    let elsewhere = package.folder.path().join("elsewhere");
    let report = package.program(&["report", "elsewhere"]).output().unwrap();
    assert!(report.status.success(), "{}", super::said(&report));
    assert!(times(&elsewhere).len() >= 100);
}

/// Commands whose answer is long, short, of the master and of the tools.
const ANSWERS: [&[&str]; 9] = [
    &["--help"],
    &["interface", "hostile.fmu"],
    &["interface", "hostile.fmu", "--xml"],
    &["schema"],
    &["check", "--rules"],
    &["check", "hostile.fmu"],
    &["wiring", "hostile.ssp"],
    &["report", "results"],
    &["run", "hostile.ssp", "--quiet"],
];

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let package = HostilePackage::new("WELL");
    assert!(package.run(&[]).status.success());
    for arguments in ANSWERS {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = package.program(arguments).stdout(Stdio::from(writer)).output().unwrap();
        assert_eq!((output.status.code(), &*said(&output)), (Some(0), ""), "{arguments:?}");
    }
}

#[test]
fn a_full_device_is_told_in_a_sentence() {
    let package = HostilePackage::new("WELL");
    assert!(package.run(&[]).status.success());
    for arguments in ANSWERS {
        let full = fs::File::options().write(true).open("/dev/full").unwrap();
        let output = package.program(arguments).stdout(Stdio::from(full)).output().unwrap();
        let said = said(&output);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {said}");
        assert_says(&said, &["Error: ", "cannot be written: No space left on device"]);
        assert_eq!(said.matches("Error").count(), 1, "{said}");
    }
}
