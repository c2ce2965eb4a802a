//! FMUs that misbehave in a train: the run ends with a message that names the instance, the file,
//! the function and the reason, and all that was recorded is there; or it goes on, where the
//! standard says so.
//!
//! The cases are those of which every other master gets one or more wrong
//! (docs/validation/README.md).

use std::path::Path;
use std::process::Output;

use hotfoot::recording::{KeyValue, SeriesReader};
use hotfoot_tests::SmallScenario;
use hotfoot_tests::hostile::{Claims, archive, hostile_vehicle};
use zip::write::SimpleFileOptions;

/// A train whose second vehicle is the hostile one, for 0.1 s, recorded every 0.01 s.
pub fn scenario(behaviour: &str, claims: &Claims) -> SmallScenario {
    let mut scenario = SmallScenario::new(0.1);
    scenario.leave_out_heat();
    // Three vehicles, and one type: each type takes half a second of processor time at the start.
    scenario.text = scenario.text.replace("wagon-coco-134t-unpowered", "locomotive-coco-134t");
    scenario.text = scenario.text.replace("count = 4", "count = 2");
    hostile_vehicle(scenario.folder.path(), behaviour, claims);
    scenario.text += "\n[record]\ninterval_s = 0.01\n\
                      [fmus]\nvehicle_at = [{ place = 2, file = \"hostile.fmu\" }]\n";
    scenario
}

pub fn run(behaviour: &str) -> (SmallScenario, Output) {
    let scenario = scenario(behaviour, &Claims::default());
    let output = scenario.run(&[]);
    (scenario, output)
}

pub fn text(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes).into_owned();
    text.replace(['│', '×'], " ").split_whitespace().collect::<Vec<_>>().join(" ")
}

/// What a run that must end early says, on one line.
pub fn refusal(output: &Output) -> String {
    assert!(!output.status.success(), "the run succeeded");
    text(&output.stderr)
}

pub fn assert_says(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "'{part}' is missing in: {message}");
    }
}

/// The times at which the vehicles were recorded.
pub fn recorded(scenario: &SmallScenario) -> Vec<f64> {
    let series = scenario.results().join("series");
    let reader = SeriesReader::open(&series, "vehicles").unwrap();
    reader.read("time", &[("vehicle", KeyValue::Integer(3))]).unwrap()
}

/// The instants before the vehicle misbehaves at 0.05 s, to the bit.
pub fn until_trouble() -> Vec<f64> {
    (0..=5).map(|record| f64::from(record * 10) * 1e-3).collect()
}

#[test]
fn an_error_ends_the_run_with_the_reason_and_keeps_what_was_recorded() {
    let (scenario, output) = run("STEP_ERROR");
    let parts = [
        "at 0.05 s",
        "vehicle[2]",
        "hostile.fmu",
        "fmi2DoStep from 0.05 s by 0.001 s",
        "fmi2Error",
        "the axle box is too hot at 0.05 s",
        "the results until then are in",
    ];
    assert_says(&refusal(&output), &parts);
    assert_eq!(recorded(&scenario), until_trouble());
}

#[test]
fn an_error_in_setting_names_the_variable() {
    let (_, output) = run("SET_ERROR");
    let parts = ["vehicle[2]", "fmi2SetReal of coupler.front.force", "no more forces"];
    assert_says(&refusal(&output), &parts);
}

#[test]
fn a_discarded_step_without_progress_ends_the_run() {
    let (scenario, output) = run("DISCARD");
    let parts = ["fmi2Discard", "done until 0.05 s", "no progress at 0.05 s", "vehicle[2]"];
    assert_says(&refusal(&output), &parts);
    assert_eq!(recorded(&scenario), until_trouble());
}

#[test]
fn a_discarded_step_is_tried_again_in_parts_if_that_is_asked_for() {
    let mut scenario = scenario("DISCARD_LONG", &Claims::default());
    assert_says(&refusal(&scenario.run(&[])), &["fmi2Discard"]);
    scenario.text += "retry_discarded_steps = true\n";
    scenario.run_well(&[]);
    let last = *recorded(&scenario).last().unwrap();
    assert_eq!(last, 100.0 * 1e-3);
}

/// However often a step is tried again, that has an end.
#[test]
fn trying_a_discarded_step_again_is_bounded() {
    let mut scenario = scenario("DISCARD", &Claims::default());
    scenario.text += "retry_discarded_steps = true\n";
    assert_says(&refusal(&scenario.run(&[])), &["also in 16 parts", "fmi2Discard"]);
}

#[test]
fn an_fmu_that_crashes_is_named_and_all_that_was_recorded_is_there() {
    for (behaviour, signal) in [("ABORT", "SIGABRT"), ("SEGFAULT", "SIGSEGV")] {
        let (scenario, output) = run(behaviour);
        let parts = [
            "vehicle[2]",
            "hostile.fmu",
            "fmi2DoStep crashed",
            signal,
            "the results until then are in",
        ];
        assert_says(&refusal(&output), &parts);
        assert_eq!(recorded(&scenario), until_trouble(), "{behaviour}");
        assert!(scenario.results().join("series/vehicles.parquet").exists());
    }
}

/// The run of a package is a child process as that of a scenario is.
#[test]
fn an_fmu_that_crashes_the_run_of_a_package_is_named_and_what_was_recorded_is_there() {
    let scenario = scenario("ABORT", &Claims::default());
    let exported = scenario.hotfoot(&["export-ssp", "scenario.toml", "-o", "train.ssp"]);
    assert!(exported.status.success(), "{}", text(&exported.stderr));
    let run = ["run", "train.ssp", "--quiet", "--interval", "0.01", "--results", "results"];
    let message = refusal(&scenario.hotfoot(&run));
    let parts = ["vehicle_2", "hostile.fmu", "fmi2DoStep crashed", "SIGABRT", "the results until"];
    assert_says(&message, &parts);
    let reader = SeriesReader::open(&scenario.results().join("series"), "vehicle_1").unwrap();
    assert_eq!(reader.read("time", &[]).unwrap(), until_trouble());
}

#[test]
fn a_wrong_guid_is_refused_with_what_the_fmu_says() {
    let claims = Claims { guid: "{another}", ..Claims::default() };
    let message = refusal(&scenario("WELL", &claims).run(&[]));
    let parts = ["vehicle[2]", "fmi2Instantiate", "the GUID {another} is not mine"];
    assert_says(&message, &parts);
}

/// The message comes with a null category, a percent sign and an argument to format.
#[test]
fn a_message_with_a_null_category_is_shown() {
    let (_, output) = run("NULL_CATEGORY");
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert_says(&text(&output.stdout), &["warning: vehicle[2]: 50 % worn at 0.05 s"]);
}

#[test]
fn a_warning_without_a_message_is_shown() {
    let (scenario, output) = run("WARN_SILENTLY");
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert_says(&text(&output.stdout), &["vehicle[2]: fmi2DoStep from 0.05 s", "fmi2Warning"]);
    assert_eq!(recorded(&scenario).len(), 11);
}

#[test]
fn after_fmi2_fatal_the_fmu_is_left_alone() {
    let (scenario, output) = run("FATAL");
    assert_says(&refusal(&output), &["vehicle[2]", "fmi2Fatal", "all is lost at 0.05 s"]);
    assert_eq!(recorded(&scenario), until_trouble());
}

#[test]
fn a_step_that_runs_in_the_background_is_waited_for() {
    let (scenario, output) = run("PENDING");
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert_eq!(recorded(&scenario).len(), 11);
}

/// Steps of one length only, no state, and model exchange beside co-simulation: what the Reference
/// FMUs of the Modelica Association have in different mixtures.
#[test]
fn an_fmu_with_few_capabilities_runs() {
    let claims = Claims {
        flags: "canHandleVariableCommunicationStepSize=\"false\"",
        model_exchange: "<ModelExchange modelIdentifier=\"hostile\"/>\n",
        ..Claims::default()
    };
    let scenario = scenario("WELL", &claims);
    scenario.run_well(&[]);
    assert_eq!(recorded(&scenario).len(), 11);
}

#[test]
fn parameters_of_every_type_reach_the_fmu() {
    let mut scenario = scenario("TELL_PARAMETERS", &Claims::default());
    let with = "file = \"hostile.fmu\", parameters = { count = 3, worn = true, file = \"a b\" } }";
    scenario.text = scenario.text.replace("file = \"hostile.fmu\" }", with);
    let output = scenario.run(&[]);
    assert_says(&text(&output.stdout), &["warning: vehicle[2]: count 3, worn 1, file a b"]);
    scenario.text = scenario.text.replace("count = 3", "count = 0.5");
    assert_says(&refusal(&scenario.run(&[])), &["count", "0.5", "must be a whole number"]);
}

#[test]
fn an_fmu_that_cannot_save_its_state_is_not_tried_again() {
    let claims = Claims { flags: "", ..Claims::default() };
    let mut scenario = scenario("DISCARD_LONG", &claims);
    scenario.text += "retry_discarded_steps = true\n";
    let message = refusal(&scenario.run(&[]));
    assert!(message.contains("fmi2Discard") && !message.contains("parts"), "{message}");
}

/// An archive whose entry leads out of the folder it is unpacked to.
#[test]
fn an_archive_that_writes_outside_is_refused() {
    let scenario = scenario("WELL", &Claims::default());
    let folder = scenario.folder.path();
    archive(&folder.join("hostile.fmu"), &[("../../../tmp/hotfoot-was-here", b"x")]);
    let message = refusal(&scenario.run(&[]));
    assert_says(&message, &["hostile.fmu", "leads out of the archive's folder", "refused"]);
    assert!(!Path::new("/tmp/hotfoot-was-here").exists());
}

/// A link to a folder, and an entry that would be written through it.
#[test]
fn an_archive_with_a_link_is_refused() {
    let scenario = scenario("WELL", &Claims::default());
    let folder = scenario.folder.path();
    let file = std::fs::File::create(folder.join("hostile.fmu")).unwrap();
    let mut zip = zip::ZipWriter::new(file);
    let outside = tempfile::tempdir().unwrap();
    let options = SimpleFileOptions::default();
    zip.add_symlink("link", outside.path().to_str().unwrap(), options).unwrap();
    zip.start_file("link/written", options).unwrap();
    zip.finish().unwrap();
    assert_says(&refusal(&scenario.run(&[])), &["hostile.fmu", "symbolic link", "refused"]);
    assert_eq!(std::fs::read_dir(outside.path()).unwrap().count(), 0);
}
