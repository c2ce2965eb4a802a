//! FMUs that end the process or never return, and ends that are no FMU's fault.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::time::Instant;

use hotfoot_tests::hostile::{Claims, hostile_vehicle};
use hotfoot_tests::package::{HostilePackage, times};

use super::{assert_complete, assert_says, child_of, said, send, start};

/// The places where an FMU may end a run, and the function that is being called there.
const PLACES: [(&str, &str); 5] = [
    ("AT_LOAD", "hostile.fmu: loading the binary"),
    ("AT_INSTANTIATE", "(results/package/resources/hostile.fmu): fmi2Instantiate"),
    ("AT_INIT", "hostile.fmu): fmi2EnterInitializationMode"),
    ("AT_STEP", "hostile.fmu): fmi2DoStep"),
    ("AT_TERMINATE", "hostile.fmu): fmi2Terminate"),
];

/// The instants before 0.05 s, to the bit.
fn until_trouble() -> Vec<f64> {
    (0..=5).map(|record| f64::from(record * 10) * 1e-3).collect()
}

/// An FMU that ends the process is named with what it did where, the records are complete, and nothing is
/// left; before the first record the folder is not even there.
fn assert_named(how: &str, further: &[&str], what: &str) {
    for (place, called) in PLACES {
        let package = HostilePackage::new(&format!("ENDS({how},{place})"));
        let output = package.run(further);
        let said = said(&output);
        assert_eq!(output.status.code(), Some(1), "{place}: {said}");
        let (_, function) = called.rsplit_once(": ").unwrap();
        assert_says(&said, &["hostile.fmu", function, what]);
        assert_eq!(package.left(), Vec::<PathBuf>::new(), "{place}");
        match place {
            "AT_STEP" => {
                assert_says(&said, &["at 0.05 s", "the results until then are in"]);
                assert_eq!(times(&package.results()), until_trouble());
                assert_complete(&package.results(), "failed");
            }
            "AT_TERMINATE" => {
                assert_eq!(times(&package.results()).len(), 11);
                assert_complete(&package.results(), "failed");
            }
            _ => {
                assert_says(&said, &["nothing was recorded"]);
                assert!(!package.results().exists(), "{place}");
            }
        }
    }
}

#[test]
fn an_fmu_that_calls_exit_is_named_and_that_is_no_success() {
    assert_named("BY_EXIT", &[], "has ended the program by exit(0)");
}

#[test]
fn an_fmu_that_ends_the_process_at_once_is_named() {
    assert_named("BY_EXIT_AT_ONCE", &[], "has ended the program by _exit(3)");
}

#[test]
fn an_fmu_that_crashes_is_named_wherever_it_does() {
    assert_named("BY_CRASH", &[], "crashed with a memory error (SIGSEGV)");
}

#[test]
fn a_call_that_does_not_return_is_named_and_ended() {
    let limits = ["--start-limit", "0.3", "--step-limit", "0.3", "--end-limit", "0.3"];
    let begin = Instant::now();
    assert_named("BY_LOOP", &limits, "did not return within 0.3 s");
    assert!(begin.elapsed().as_secs() < 60);
}

#[test]
fn a_thread_of_an_fmu_that_crashes_is_named_by_its_library() {
    let package = HostilePackage::new("ENDS(BY_CRASH_OF_THREAD,AT_STEP)");
    let said = said(&package.run(&[]));
    assert_says(&said, &["at 0.05 s: hostile.so in a thread of its own crashed with", "SIGSEGV"]);
    assert_eq!(times(&package.results()), until_trouble());
}

/// All results are there when the FMUs are freed and unloaded: what happens then is told, and the run is a
/// success.
#[test]
fn an_fmu_that_fails_after_all_is_done_is_a_warning() {
    for (how, place, what) in [
        ("BY_EXIT", "AT_FREE", "fmi2FreeInstance has ended the program by exit(0)"),
        ("BY_CRASH", "AT_FREE", "fmi2FreeInstance crashed"),
        ("BY_DOUBLE_FREE", "AT_FREE", "fmi2FreeInstance crashed with abort (SIGABRT)"),
        ("BY_LOOP", "AT_FREE", "fmi2FreeInstance did not return within 0.3 s (--end-limit)"),
        ("BY_CRASH", "AT_UNLOAD", "crashed with a memory error (SIGSEGV)"),
        ("BY_LOOP", "AT_UNLOAD", "did not return within 0.3 s (--end-limit)"),
    ] {
        let package = HostilePackage::new(&format!("ENDS({how},{place})"));
        let output = package.run(&["--end-limit", "0.3"]);
        let said = said(&output);
        assert_says(&said, &["warning: all is complete, but afterwards", "hostile", what]);
        assert_eq!(output.status.code(), Some(0), "{said}");
        assert!(
            String::from_utf8_lossy(&output.stdout).contains("report: "),
            "the figures are told"
        );
        assert_complete(&package.results(), "complete");
        assert_eq!(times(&package.results()).len(), 11);
        assert!(package.left().is_empty());
    }
}

/// The other commands that load FMUs are protected in the same way.
#[test]
fn all_commands_name_an_fmu_that_ends_them() {
    for (how, what) in [
        ("BY_EXIT", "loading the binary has ended the program by exit(0)"),
        ("BY_CRASH", "loading the binary crashed with a memory error (SIGSEGV)"),
        ("BY_LOOP", "loading the binary did not return within 0.3 s (--start-limit)"),
    ] {
        let package = HostilePackage::new(&format!("ENDS({how},AT_LOAD)"));
        let limit = ["--start-limit", "0.3"];
        for command in
            [&["check", "hostile.fmu"][..], &["pack", "hostile.so", "--output", "packed.fmu"]]
        {
            let output = package.program(&[command, &limit].concat()).output().unwrap();
            let said = said(&output);
            assert_eq!(output.status.code(), Some(1), "{said}");
            assert_says(&said, &["Error:", "hostile.", what]);
            assert!(package.left().is_empty());
        }
    }
}

/// A scenario's train is initialised for its package.
#[test]
fn an_fmu_that_ends_an_export_is_named() {
    let mut scenario = hotfoot_tests::SmallScenario::new(0.1);
    scenario.leave_out_heat();
    hostile_vehicle(scenario.folder.path(), "ENDS(BY_EXIT,AT_LOAD)", &Claims::default());
    scenario.text += "\n[fmus]\nvehicle_at = [{ place = 2, file = \"hostile.fmu\" }]\n";
    for command in [&["export-ssp", "scenario.toml"][..], &["wiring", "scenario.toml"]] {
        let output = scenario.hotfoot(command);
        assert_eq!(output.status.code(), Some(1));
        assert_says(
            &said(&output),
            &["hostile.fmu: loading the binary has ended the program by exit(0)"],
        );
    }
    assert!(!scenario.folder.path().join("scenario.ssp").exists());
}

/// The standard input is closed to FMUs: one that reads it finds its end, and the run goes on.
#[test]
fn an_fmu_that_reads_the_standard_input_finds_it_empty() {
    let package = HostilePackage::new("READS_STDIN");
    let mut command = package.command(&["--step-limit", "5"]);
    let mut run = command.stdin(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap();
    let input = run.stdin.take();
    assert!(run.wait().unwrap().success());
    drop(input);
    assert_eq!(times(&package.results()).len(), 11);
}

#[test]
fn a_signal_from_outside_is_no_fmus_fault() {
    for signal in ["KILL", "SEGV", "USR1"] {
        let package = HostilePackage::new("SLOW");
        let run = start(&package, &["--duration", "1000"]);
        send(signal, &[child_of(run.id()).unwrap()]);
        let output = run.wait_with_output().unwrap();
        let said = said(&output);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert_says(&said, &["ended from outside", &format!("SIG{signal}"), "no FMU is to blame"]);
        assert_complete(&package.results(), "failed");
        assert!(package.left().is_empty());
    }
}

#[test]
fn the_limit_of_processor_time_is_named() {
    let said = assert_ends_at_limit("BY_BUSY_LOOP", "ulimit -t 2");
    assert_says(&said, &["the limit of 2 s of processor time (ulimit -t)"]);
}

#[test]
fn the_limit_of_memory_is_named() {
    let said = assert_ends_at_limit("BY_TAKING_MEMORY", "ulimit -v 2000000");
    assert_says(&said, &["hostile.fmu): fmi2DoStep crashed with abort (SIGABRT)"]);
    assert_says(&said, &["memory may have run out, of which it may have 2048 MB (ulimit -v)"]);
}

/// A container's limit of memory, by which the system itself kills; needs the right to make such a group.
#[test]
fn the_limit_of_memory_of_a_container_is_named() {
    let Some(group) = MemoryGroup::of_bytes(400 << 20) else {
        println!("skipped: no control group of memory can be made here");
        return;
    };
    let enter = format!("echo $$ > {}", group.0.join("cgroup.procs").display());
    let said = assert_ends_at_limit("BY_TAKING_MEMORY", &enter);
    assert_says(&said, &["the system has killed the program (SIGKILL) because memory ran out"]);
}

/// A control group of Linux whose processes share so much memory, cgroups(7); removed at its end.
struct MemoryGroup(PathBuf);

impl MemoryGroup {
    /// A group in the first hierarchy, of version 1 or 2, in which one can be made.
    fn of_bytes(limit: usize) -> Option<Self> {
        let name = format!("hotfoot-test-{}", std::process::id());
        let hierarchies = [
            ("/sys/fs/cgroup/memory", "memory.limit_in_bytes", ("memory.swappiness", "0")),
            ("/sys/fs/cgroup", "memory.max", ("memory.swap.max", "0")),
        ];
        hierarchies.into_iter().find_map(|(root, key, (swap, none))| {
            let group = Path::new(root).join(&name);
            fs::create_dir(&group).ok()?;
            let group = Self(group);
            fs::write(group.0.join(key), limit.to_string()).ok()?;
            // Where nothing is swapped there may be no such file.
            let _ = fs::write(group.0.join(swap), none);
            Some(group)
        })
    }
}

impl Drop for MemoryGroup {
    fn drop(&mut self) {
        let _ = fs::remove_dir(&self.0);
    }
}

/// A run whose FMU goes on at 0.05 s until a limit of the shell ends it; gives what is said.
fn assert_ends_at_limit(how: &str, limit: &str) -> String {
    let package = HostilePackage::new(&format!("ENDS({how},AT_STEP)"));
    let hotfoot = package.command(&[]);
    let mut limited = std::process::Command::new("sh");
    let script = format!("{limit}; exec \"$0\" \"$@\"");
    limited.args(["-c", &script]).arg(hotfoot.get_program());
    limited.args(hotfoot.get_args()).current_dir(package.folder.path());
    let output = limited.env("TMPDIR", package.temporary()).output().unwrap();
    let said = said(&output);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert_eq!(times(&package.results()), until_trouble());
    assert!(package.left().is_empty());
    said
}
