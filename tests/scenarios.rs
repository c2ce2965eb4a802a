//! Every shipped scenario runs: its first half second with the head of its train, and the minute after it, so
//! that all of them fit into the test run. The acceptance runs and the first look, which are short, run to their
//! end as they are; `cargo xtask packages` runs all of the trains.

use std::path::{Path, PathBuf};

use hotfoot_tests::{hotfoot, root};

/// Vehicles of one kind in a row that start: a hundred like ones take most of the time and show nothing more.
const LIKE_VEHICLES: i64 = 4;

#[test]
fn every_shipped_scenario_starts_and_runs() {
    let scenarios = shipped();
    assert!(scenarios.len() >= 13, "only {} scenarios were found", scenarios.len());
    // Two at a time: much of such a short run is its start, which takes one core.
    let (some, others) = scenarios.split_at(scenarios.len() / 2);
    std::thread::scope(|scope| {
        scope.spawn(|| start_and_run(some));
        start_and_run(others);
    });
}

/// The acceptance runs keep the limits in their files `expected.toml`, whose sources stand there.
#[test]
fn benchmark_acceptance_runs_keep_their_limits() {
    let is_acceptance = |file: &PathBuf| file.to_str().unwrap().contains("scenarios/acceptance-");
    let scenarios: Vec<PathBuf> = shipped().into_iter().filter(is_acceptance).collect();
    assert!(scenarios.len() >= 7, "only {} acceptance runs were found", scenarios.len());
    for scenario in &scenarios {
        run_and_judge(scenario);
    }
}

/// The first look answers as its README says, and has nothing to warn of.
#[test]
fn golden_the_first_look_gives_its_answer() {
    let said = run_and_judge(&root().join("scenarios/first-look/scenario.toml"));
    assert!(said.contains("left rail: Foot: first reaches 15 mK"), "{said}");
    assert!(!said.contains("warning") && !said.contains("note:"), "{said}");
}

/// Runs a scenario to its end and compares it with the file `expected.toml` beside it; gives what was said.
fn run_and_judge(scenario: &Path) -> String {
    let folder = tempfile::tempdir().unwrap();
    let results = folder.path().to_str().unwrap();
    let run = ["run", scenario.to_str().unwrap(), "--quiet", "--results", results];
    let output = hotfoot(root(), &run);
    let said = [output.stderr, output.stdout].concat();
    let said = String::from_utf8_lossy(&said).into_owned();
    assert!(output.status.success(), "{}: {said}", scenario.display());
    let expected = scenario.with_file_name("expected.toml");
    let output = hotfoot(root(), &["expect", results, expected.to_str().unwrap()]);
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{}: {text}", scenario.display());
    said
}

fn start_and_run(scenarios: &[PathBuf]) {
    for scenario in scenarios {
        let folder = tempfile::tempdir().unwrap();
        let results = folder.path().join("results");
        let shorter = shorter(scenario);
        let run = ["run", scenario.to_str().unwrap(), "--duration", "0.5", "--quiet"];
        let folder = ["--results", results.to_str().unwrap()];
        let settings = shorter.iter().flat_map(|setting| ["--set", setting.as_str()]);
        let arguments: Vec<&str> = run.into_iter().chain(folder).chain(settings).collect();
        let output = hotfoot(root(), &arguments);
        let text = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}: {text}", scenario.display());
        assert!(results.join("report.html").exists(), "{}", scenario.display());
    }
}

/// The settings by which a scenario has the head of its train and a minute after it.
fn shorter(scenario: &Path) -> Vec<String> {
    let table: toml::Table = std::fs::read_to_string(scenario).unwrap().parse().unwrap();
    let mut settings = vec![];
    for (group, number) in table["train"]["vehicles"].as_array().unwrap().iter().zip(1..) {
        if group.get("count").is_some_and(|count| count.as_integer().unwrap() > LIKE_VEHICLES) {
            settings.push(format!("train.vehicles[{number}].count={LIKE_VEHICLES}"));
        }
    }
    if table.get("record").is_some_and(|record| record.get("wheels_of").is_some()) {
        settings.push("record.wheels_of=[1]".to_owned());
    }
    let minutes = table.get("heat").and_then(|heat| heat.get("cool_down_minutes"));
    if minutes.is_some() {
        settings.push("heat.cool_down_minutes=1".to_owned());
    }
    settings
}

/// The files `scenario.toml` of all folders, every file with a title in `foot-study`, and one beside another.
pub fn shipped() -> Vec<PathBuf> {
    let files = |folder: PathBuf| std::fs::read_dir(folder).unwrap().flatten().map(|e| e.path());
    let folders = files(root().join("scenarios")).chain(files(root().join("scenarios/benchmarks")));
    let of_folders = folders.map(|folder| folder.join("scenario.toml"));
    let has_title = |file: &PathBuf| {
        std::fs::read_to_string(file)
            .is_ok_and(|text| text.lines().any(|l| l.starts_with("title =")))
    };
    let of_study = files(root().join("scenarios/foot-study")).filter(has_title);
    let column = root().join("scenarios/benchmarks/heat-share/column.toml");
    of_folders.filter(|file| file.exists()).chain(of_study).chain([column]).collect()
}
