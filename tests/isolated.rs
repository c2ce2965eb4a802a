//! FMUs in processes of their own: what fails there costs that FMU only, and what works gives the same bytes.

use std::path::Path;
use std::process::Output;

use hotfoot::recording::{KeyValue, SeriesReader};
use hotfoot_tests::SmallScenario;
use hotfoot_tests::hostile::Claims;
use hotfoot_tests::package::{HostilePackage, times};

use crate::ends::{child_of, is_running, send, start, wait_until};
use crate::hostile::{assert_says, recorded, refusal, scenario, text, until_trouble};

/// What the second vehicle may do at 0.05 s, what is told of it, and the function.
const FAILURES: [(&str, &str, &str); 8] = [
    ("ABORT", "it crashed with abort (SIGABRT)", "fmi2DoStep"),
    ("SEGFAULT", "it crashed with a memory error (SIGSEGV)", "fmi2DoStep"),
    ("DOUBLE_FREE", "it crashed with abort (SIGABRT)", "fmi2DoStep"),
    ("ENDS(BY_EXIT,AT_STEP)", "it has ended its process by exit(0)", "fmi2DoStep"),
    ("ENDS(BY_EXIT_AT_ONCE,AT_STEP)", "it has ended its process by _exit(3)", "fmi2DoStep"),
    ("ENDS(BY_LOOP,AT_STEP)", "it did not return within 0.5 s (--step-limit)", "fmi2DoStep"),
    ("WRITES_BEYOND", "it has written outside of the array", "fmi2GetReal"),
    ("STEP_ERROR", "the axle box is too hot at 0.05 s", "fmi2DoStep from 0.05 s by 0.001 s"),
];

/// Three vehicles, of which the second is the hostile one in a process of its own, with further keys.
fn isolated(behaviour: &str, keys: &str) -> SmallScenario {
    let mut scenario = scenario(behaviour, &Claims::default());
    let own = format!("file = \"hostile.fmu\", isolate = \"process\"{keys} }}");
    scenario.text = scenario.text.replace("file = \"hostile.fmu\" }", &own);
    scenario
}

fn success(output: &Output) -> String {
    assert!(output.status.success(), "{}", text(&output.stderr));
    text(&output.stdout)
}

/// The numbers of all processes of isolated FMUs of this scenario or package, which lie in its folder.
fn processes(run: u32) -> Vec<u32> {
    let child = child_of(run).expect("a run has a child");
    let children = std::fs::read_dir(format!("/proc/{child}/task")).unwrap().flatten();
    let of_thread = |thread: std::fs::DirEntry| {
        let list = std::fs::read_to_string(thread.path().join("children")).unwrap_or_default();
        list.split_whitespace().map(|number| number.parse().unwrap()).collect::<Vec<u32>>()
    };
    children.flat_map(of_thread).collect()
}

#[test]
fn a_failure_ends_the_run_with_its_reason_and_complete_records() {
    for (behaviour, what, function) in FAILURES {
        let scenario = isolated(behaviour, "");
        let output = scenario.run(&["--step-limit", "0.5"]);
        let message = refusal(&output);
        assert_eq!(output.status.code(), Some(1), "{behaviour}: {message}");
        assert_says(&message, &["at 0.05 s: vehicle[2]", "hostile.fmu", function, what]);
        assert_says(&message, &["the results until then are in"]);
        assert_eq!(recorded(&scenario), until_trouble(), "{behaviour}");
        assert!(scenario.results().join("report.html").exists());
    }
}

#[test]
fn a_vehicle_follows_the_train_after_a_failure_with_a_warning() {
    for (behaviour, what, function) in FAILURES {
        let scenario = isolated(behaviour, ", on_failure = \"follow\"");
        let told = success(&scenario.run(&["--step-limit", "0.5"]));
        let warning = format!("warning: vehicle[2]: {what}");
        assert_says(
            &told,
            &[&warning, "at 0.05 s in", function, "hostile.fmu", "follows the motion"],
        );
        assert_eq!(told.matches("follows the motion of the train").count(), 1, "{told}");
        assert_eq!(recorded(&scenario).len(), 11, "{behaviour}");
        for file in ["manifest.toml", "report.html"] {
            let text = std::fs::read_to_string(scenario.results().join(file)).unwrap();
            assert!(text.contains("vehicle[2]") && text.contains("follows the motion"), "{file}");
        }
        assert_follows(&scenario);
    }
}

/// From 0.05 s on the second vehicle is where the train has it, to the bit, and nothing pulls it there.
fn assert_follows(scenario: &SmallScenario) {
    let column = |table: &str, name: &str| {
        let reader = SeriesReader::open(&scenario.results().join("series"), table).unwrap();
        reader.read(name, &[("vehicle", KeyValue::Integer(2))]).unwrap()
    };
    for (own, of_train) in [("position", "train_position"), ("velocity", "train_velocity")] {
        let (own, of_train) = (column("vehicles", own), column("vehicles", of_train));
        assert_eq!(own[6..], of_train[6..]);
    }
    assert!(column("vehicles", "sync_force")[7..].iter().all(|force| *force == 0.0));
    assert!(column("vehicles", "friction_power")[6..].iter().all(|power| *power == 0.0));
}

/// A wagon with wheels on a heated rail, whose process is killed: its wheelsets keep their distances, its wheels
/// give no heat any more, and nothing else ends.
#[test]
fn a_wagon_that_was_killed_heats_the_rail_no_more() {
    let mut scenario = SmallScenario::new(0.02);
    scenario.run_well(&[]);
    let wagon = std::fs::read_dir(scenario.results().join("fmus")).unwrap().flatten();
    let wagon = wagon.map(|entry| entry.path()).find(|path| {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        !["train", "rail"].contains(&name.as_str()) && !name.contains("locomotive")
    });
    let copy = scenario.folder.path().join("wagon.fmu");
    std::fs::copy(wagon.expect("the wagon's FMU"), &copy).unwrap();
    scenario.text = SmallScenario::new(60.0).text
        + "\n[record]\nwheels_of = [3]\n[fmus]\nvehicle_at = [{ vehicle = 3, file = \"wagon.fmu\", \
           isolate = \"process\", on_failure = \"follow\" }]\n";
    let mut command = scenario.command(&[]);
    let run = command.stdout(std::process::Stdio::piped()).stderr(std::process::Stdio::piped());
    let run = run.spawn().unwrap();
    let parts = scenario.results().join("series/wheels.parts");
    wait_until("the first part", || parts.join("part-00000.parquet").exists());
    send("KILL", &processes(run.id()));
    wait_until("the third part", || parts.join("part-00002.parquet").exists());
    send("INT", &[run.id()]);
    let output = run.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
    let told = text(&output.stdout);
    let warning = "warning: vehicle[3]: its process was ended from outside, by signal 9 at";
    assert_says(&told, &[warning, "wagon.fmu", "follows the motion"]);

    let column = |table: &str, name: &str, keys: &[(&str, KeyValue<'_>)]| {
        let reader = SeriesReader::open(&scenario.results().join("series"), table).unwrap();
        reader.read(name, keys).unwrap()
    };
    let wheel = [("wheelset", KeyValue::Integer(1)), ("side", KeyValue::Text("left"))];
    let power = column("wheels", "friction_power", &wheel);
    let (first, last) = (power[1], *power.last().unwrap());
    assert!(first > 0.0 && last == 0.0, "{first} W, then {last} W");
    let distances = column("wheels", "position", &wheel).into_iter();
    let middles = column("vehicles", "train_position", &[("vehicle", KeyValue::Integer(3))]);
    let distances: Vec<f64> =
        distances.zip(middles).map(|(wheel, middle)| wheel - middle).collect();
    let (first, last) = (distances[0], *distances.last().unwrap());
    assert!(first > 1.0 && (first - last).abs() < 0.05, "{first} m, then {last} m");
}

/// A failure before the first step is one that the user can mend: it ends the run in any case.
#[test]
fn a_failure_at_the_start_ends_the_run() {
    for (place, function) in [
        ("AT_LOAD", "loading the binary"),
        ("AT_INSTANTIATE", "fmi2Instantiate"),
        ("AT_INIT", "fmi2EnterInitializationMode"),
    ] {
        for (how, what) in [
            ("BY_EXIT", "ended its process by exit(0)"),
            ("BY_CRASH", "crashed with a memory error"),
            ("BY_BUSY_LOOP", "did not return within 0.5 s (--start-limit)"),
        ] {
            let behaviour = format!("ENDS({how},{place})");
            let scenario = isolated(&behaviour, ", on_failure = \"follow\"");
            let message = refusal(&scenario.run(&["--start-limit", "0.5"]));
            assert_says(&message, &["vehicle[2]", "hostile.fmu", function, what]);
            assert!(!scenario.results().exists(), "{behaviour}");
        }
    }
}

/// What happens when all is done is a warning.
#[test]
fn a_failure_at_the_end_loses_nothing() {
    for (place, function) in
        [("AT_FREE", "fmi2FreeInstance"), ("AT_UNLOAD", "unloading the binary")]
    {
        for (how, what) in [("BY_CRASH", "crashed"), ("BY_LOOP", "did not return within 0.5 s")] {
            let scenario = isolated(&format!("ENDS({how},{place})"), "");
            let output = scenario.run(&["--end-limit", "0.5"]);
            success(&output);
            let warning = text(&output.stderr);
            assert_says(&warning, &["warning: vehicle[2]", what, function, "after all was done"]);
            assert_eq!(recorded(&scenario).len(), 11);
        }
    }
    let scenario = isolated("ENDS(BY_CRASH,AT_TERMINATE)", ", on_failure = \"follow\"");
    assert_says(&success(&scenario.run(&[])), &["warning: vehicle[2]", "crashed", "fmi2Terminate"]);
}

#[test]
fn messages_and_parameters_go_both_ways() {
    let keys = ", parameters = { count = 3, worn = true, file = \"a b\" }";
    let told = success(&isolated("TELL_PARAMETERS", keys).run(&[]));
    assert_says(&told, &["warning: vehicle[2]: count 3, worn 1, file a b"]);
    let told = success(&isolated("MANY_MESSAGES", "").run(&[]));
    assert_says(&told, &["warning: vehicle[2]: and", "more messages"]);
    // It is called by one thread, and the processor computes as ever.
    for behaviour in ["ONE_THREAD", "PENDING", "TRAPPING"] {
        success(&isolated(behaviour, "").run(&[]));
    }
}

/// Our own FMUs, all in processes of their own.
#[test]
fn isolated_vehicles_give_the_same_bytes() {
    let scenario = SmallScenario::new(0.1);
    let bytes = |further: &[&str]| {
        scenario.run_well(further);
        let all = |folder: &Path| files(folder);
        let results = scenario.results();
        (all(&results.join("series")), all(&results.join("rail.zarr")))
    };
    let expected = bytes(&["--threads", "1"]);
    assert!(expected.0.len() >= 4 && !expected.1.is_empty());
    for threads in ["1", "3"] {
        assert!(
            bytes(&["--isolate", "all", "--threads", threads]) == expected,
            "{threads} threads"
        );
    }
    assert!(bytes(&["--isolate", "vehicle[2]", "--isolate", "rail"]) == expected);
    let message = refusal(&scenario.run(&["--isolate", "vehicle[6]"]));
    assert_says(
        &message,
        &["--isolate vehicle[6]: there is no such FMU", "vehicle[5], rail, and all"],
    );
}

/// The contents of all files below a folder, by their names.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut all = vec![];
    for entry in std::fs::read_dir(folder).unwrap().flatten() {
        let path = entry.path();
        if path.is_dir() {
            all.extend(files(&path));
        } else {
            all.push((path.display().to_string(), std::fs::read(&path).unwrap()));
        }
    }
    all.sort();
    all
}

/// Each instance runs in a process of its own without being asked to.
#[test]
fn an_fmu_for_one_instance_a_process_runs_at_two_places() {
    let flags = "canBeInstantiatedOnlyOncePerProcess=\"true\"";
    let mut scenario = scenario("WELL", &Claims { flags, ..Claims::default() });
    assert!(!success(&scenario.run(&[])).contains("canBeInstantiatedOnlyOncePerProcess"));
    let two = "[{ place = 2, file = \"hostile.fmu\" }, { place = 3, file = \"hostile.fmu\" }]";
    scenario.text = scenario.text.replace("[{ place = 2, file = \"hostile.fmu\" }]", two);
    let told = success(&scenario.run(&[]));
    assert_says(&told, &["hostile.fmu allows only one instance in a process"]);
    assert_says(&told, &["its 2 instances run in processes of their own"]);
}

/// The option, and the annotation of the component.
#[test]
fn a_component_of_a_package_is_isolated() {
    for (behaviour, what, _) in FAILURES.into_iter().filter(|failure| failure.0 != "WRITES_BEYOND")
    {
        let package = HostilePackage::new(behaviour);
        let output = package.run(&["--isolate", "a", "--isolate", "b", "--step-limit", "0.5"]);
        assert_says(&refusal(&output), &["at 0.05 s: a: ", what, "hostile.fmu"]);
        assert_eq!(times(&package.results()), until_trouble(), "{behaviour}");
        assert_eq!(package.left(), Vec::<std::path::PathBuf>::new());
    }
    let scenario = isolated("ABORT", "");
    let exported = scenario.hotfoot(&["export-ssp", "scenario.toml", "-o", "train.ssp"]);
    success(&exported);
    let message =
        refusal(&scenario.hotfoot(&["run", "train.ssp", "--quiet", "--results", "results"]));
    assert_says(&message, &["vehicle_2", "hostile.fmu: fmi2DoStep", "it crashed with abort"]);
}

#[test]
fn a_wish_to_follow_without_isolation_is_refused() {
    let mut scenario = scenario("WELL", &Claims::default());
    let own = "file = \"hostile.fmu\", on_failure = \"follow\" }";
    scenario.text = scenario.text.replace("file = \"hostile.fmu\" }", own);
    let message = refusal(&scenario.run(&[]));
    assert_says(&message, &["fmus.vehicle_at[1].on_failure", "add isolate = \"process\""]);
}

/// After every end: in order, by a signal, and when program, child or both are killed.
#[test]
fn the_processes_end_with_the_run() {
    for (signal, to_parent, to_child) in
        [("INT", true, false), ("KILL", true, false), ("KILL", false, true), ("KILL", true, true)]
    {
        for behaviour in ["SLOW", "ENDS(BY_BUSY_LOOP,AT_STEP)"] {
            let package = HostilePackage::new(behaviour);
            let mut run = if behaviour == "SLOW" {
                start(&package, &["--isolate", "all", "--duration", "20"])
            } else {
                let quiet = std::process::Stdio::null;
                let mut command = package.command(&["--isolate", "all"]);
                command.stdout(quiet()).stderr(quiet()).spawn().unwrap()
            };
            wait_until("two processes", || {
                child_of(run.id()).is_some() && processes(run.id()).len() == 2
            });
            let own = processes(run.id());
            assert!(own.iter().all(|process| is_running(*process)));
            let child = child_of(run.id()).filter(|_| to_child);
            let targets: Vec<u32> = to_parent.then(|| run.id()).into_iter().chain(child).collect();
            send(signal, &targets);
            wait_until("the end of the FMUs", || !own.iter().any(|process| is_running(*process)));
            run.wait().unwrap();
        }
    }
}
