//! The folder of a run: claimed in one step, never shared, never left by a start that fails.

use std::fs;
use std::process::{Command, Stdio};

use hotfoot_tests::package::{HostilePackage, times};

use super::{assert_complete, assert_says, child_of, is_running, said, send, start, wait_until};

#[test]
fn runs_that_start_together_get_a_folder_each() {
    let package = HostilePackage::new("WELL");
    let run = ["run", "hostile.ssp", "--quiet", "--interval", "0.01", "--duration", "0.1"];
    let start = |_| {
        let mut command: Command = package.program(&run);
        command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
    };
    let runs: Vec<_> = (0..4).map(start).collect();
    for run in runs {
        let output = run.wait_with_output().unwrap();
        assert!(output.status.success(), "{}", said(&output));
    }
    for name in ["hostile", "hostile-2", "hostile-3", "hostile-4"] {
        let results = package.folder.path().join("results").join(name);
        assert_eq!(times(&results).len(), 11);
        assert_complete(&results, "complete");
    }
    assert_eq!(fs::read_dir(package.folder.path().join("results")).unwrap().count(), 4);
    assert!(package.left().is_empty());
}

#[test]
fn a_folder_in_use_is_refused_even_to_be_overwritten() {
    let package = HostilePackage::new("SLOW");
    let first = start(&package, &["--duration", "3"]);
    for further in [&[][..], &["--overwrite"]] {
        let second = package.run(further);
        assert_eq!(second.status.code(), Some(1));
        assert_says(&said(&second), &["results: another run is writing its results there"]);
    }
    let output = first.wait_with_output().unwrap();
    assert!(output.status.success(), "{}", said(&output));
    assert_eq!(times(&package.results()).len(), 301);
}

#[test]
fn results_are_replaced_only_if_that_is_asked_for() {
    let package = HostilePackage::new("WELL");
    assert!(package.run(&[]).status.success());
    fs::write(package.results().join("notes.txt"), "mine").unwrap();
    let refused = package.run(&["--duration", "0.2"]);
    assert_eq!(refused.status.code(), Some(1));
    assert_says(&said(&refused), &["has the results of a run already", "--overwrite"]);
    assert_eq!(times(&package.results()).len(), 11);
    let replaced = package.run(&["--duration", "0.2", "--overwrite"]);
    assert!(replaced.status.success(), "{}", said(&replaced));
    assert_eq!(times(&package.results()).len(), 21);
    assert_eq!(fs::read_to_string(package.results().join("notes.txt")).unwrap(), "mine");
}

#[test]
fn a_start_that_fails_leaves_no_folder_and_no_file_that_was_not_there() {
    let package = HostilePackage::new("WELL");
    let run = package.program(&["run", "no-such.ssp"]).output().unwrap();
    assert_eq!(run.status.code(), Some(1));
    assert!(!package.results().exists(), "not even the folder of all results");
    fs::create_dir(package.results()).unwrap();
    fs::write(package.results().join("notes.txt"), "mine").unwrap();
    fs::write(package.folder.path().join("hostile.ssp"), "no archive").unwrap();
    assert_eq!(package.run(&[]).status.code(), Some(1));
    let left = fs::read_dir(package.results()).unwrap().map(|entry| entry.unwrap().file_name());
    assert_eq!(left.collect::<Vec<_>>(), ["notes.txt"]);
    assert!(package.left().is_empty());
}

/// Both processes are killed before the first record: the next start removes what they left in the temporary
/// folder, and leaves alone what is of a run that goes on.
#[test]
fn what_a_dead_run_has_left_goes_at_the_next_start() {
    let package = HostilePackage::new("ENDS(BY_LOOP,AT_INIT)");
    let mut run = package.command(&[]).stderr(Stdio::null()).spawn().unwrap();
    wait_until("the manifest", || package.results().join("manifest.toml").exists());
    let both = [run.id(), child_of(run.id()).unwrap()];
    assert_eq!(package.left().len(), 1);
    let next = package.program(&["check", "hostile.fmu", "--start-limit", "5"]).output().unwrap();
    assert!(next.status.success(), "{}", said(&next));
    assert_eq!(package.left().len(), 1, "the run goes on");
    send("KILL", &both);
    run.wait().unwrap();
    wait_until("the end of both", || !both.iter().any(|&process| is_running(process)));
    assert_eq!(package.left().len(), 1);
    package.program(&["check", "hostile.fmu", "--start-limit", "5"]).output().unwrap();
    assert!(package.left().is_empty());
}
