//! Further outputs of vehicles in the recording, and files that a track file names.

use hotfoot::recording::{KeyValue, SeriesReader};
use hotfoot_tests::SmallScenario;

/// Two vehicles without rail heat that record these outputs of both.
fn scenario(outputs: &str) -> SmallScenario {
    let mut scenario = SmallScenario::new(0.2);
    scenario.text = scenario.text.replace("count = 4", "count = 1");
    scenario.leave_out_heat();
    scenario.text += &format!("[record]\nwheels_of = [1, 2]\noutputs = [{outputs}]\n");
    scenario
}

/// The table of further outputs.
fn outputs(scenario: &SmallScenario) -> SeriesReader {
    SeriesReader::open(&scenario.results().join("series"), "outputs").unwrap()
}

/// The vertical forces of each vehicle's wheels add up to its weight, 134 t x 9.80665 m/s2 each, in the
/// mean over 0.1 s on straight track; 1 %, as the train may pitch a little.
#[test]
fn analytic_recorded_wheel_loads_carry_the_weight() {
    let scenario = scenario("\"*.track_force.vertical\"");
    scenario.run_well(&[]);
    let table = outputs(&scenario);
    let names: Vec<String> = table.columns().map(|column| column.name().clone()).collect();
    let means: Vec<&String> = names.iter().filter(|name| name.ends_with("_mean")).collect();
    assert_eq!(means.len(), 12, "{names:?}");
    for vehicle in [1, 2] {
        let keys = [("vehicle", KeyValue::Integer(vehicle))];
        let last = |name: &&String| *table.read(name, &keys).unwrap().last().unwrap();
        let sum: f64 = means.iter().map(last).sum();
        assert!((sum / (134e3 * 9.80665) - 1.0).abs() < 1e-2, "vehicle {vehicle}: {sum} N");
    }
}

#[test]
fn an_output_that_no_vehicle_has_is_named() {
    let output = scenario("\"*.derailment\"").run(&[]);
    assert!(!output.status.success());
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(text.contains("record.outputs") && text.contains("\"*.derailment\""), "{text}");
}

/// Where both rails lie 10 mm low the body does; 0.3 mm, as the contacts give way by 0.1 mm and
/// traction pitches the body a little.
#[test]
fn analytic_measured_irregularities_reach_the_vehicle() {
    let mut scenario = scenario("\"body.vertical\"");
    scenario.track += "[irregularity]\nfile = \"measured.csv\"\n";
    let header = "chainage_m,left_lateral_mm,left_vertical_mm,right_lateral_mm,right_vertical_mm";
    let file = scenario.folder.path().join("measured.csv");
    std::fs::write(&file, format!("{header}\n-100,0,10,0,10\n0,0,10,0,10\n100,0,10,0,10\n"))
        .unwrap();
    scenario.run_well(&[]);
    let keys = [("vehicle", KeyValue::Integer(1))];
    let vertical = outputs(&scenario).read("body.vertical", &keys).unwrap()[0];
    assert!((vertical - 10e-3).abs() < 0.3e-3, "{vertical} m");

    // A wrong value is told under the name of the file that the user wrote, not of its packed copy.
    std::fs::write(&file, format!("{header}\n-100,0,0,0,ten\n0,0,0,0,10\n")).unwrap();
    let output = scenario.run(&[]);
    assert!(!output.status.success());
    let text = String::from_utf8_lossy(&output.stderr);
    let wanted = format!("{}:2:12: right_vertical_mm = ten: must be a number", file.display());
    assert!(text.contains(&wanted), "{text}");
}

/// Mean creepage of the locomotive's first wheel with more lines in the scenario and in the track file.
fn creepage(fmus: &str, track: &str) -> f64 {
    let mut scenario = scenario("\"wheelset[1].left.creepage.longitudinal\"");
    scenario.text += fmus;
    scenario.track += track;
    scenario.run_well(&[]);
    let name = "wheelset[1].left.creepage.longitudinal_mean";
    *outputs(&scenario).read(name, &[("vehicle", KeyValue::Integer(1))]).unwrap().last().unwrap()
}

/// Rails with half of the friction, and the locomotive's own FMU with half of its file's 0.36, are the same;
/// the wheel creeps more than on dry rails.
#[test]
fn property_friction_of_track_and_vehicle_reaches_the_wheels() {
    let dry = creepage("", "");
    let wet = creepage("", "[[friction]]\nchainage_m = 0.0\nfactor = 0.5\n");
    let parameters = "parameters = { \"friction.coefficient\" = 0.18 }";
    let slippery = creepage(&format!("[fmus]\nvehicle_at = [{{ place = 1, {parameters} }}]\n"), "");
    assert!(wet > 1.05 * dry, "{wet}, dry {dry}");
    assert_eq!(wet, slippery);
}

#[test]
fn names_without_an_fmu_are_refused() {
    let mut scenario = scenario("\"body.vertical\"");
    scenario.text += "[fmus]\nvehicle_at = [{ place = 1, names = { \"sync.force\" = \"u\" } }]\n";
    let output = scenario.run(&[]);
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success() && text.contains("names belong to an FMU"), "{text}");
}
