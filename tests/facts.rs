//! What the manifest and the report state is what the units have.

use hotfoot_tests::SmallScenario;

/// The table `run` of the manifest of a scenario that was run, and the text of its report.
fn facts(scenario: &SmallScenario) -> (toml::Table, String) {
    scenario.run_well(&[]);
    let read = |name: &str| std::fs::read_to_string(scenario.results().join(name)).unwrap();
    let manifest: toml::Table = read("manifest.toml").parse().unwrap();
    (manifest["run"].as_table().unwrap().clone(), read("report.html"))
}

/// A parameter under its own name overrides the scenario's key: 1 mK in the place of 15 mK, and 300 m
/// in the place of 60 m.
#[test]
fn the_rails_facts_are_those_of_its_unit() {
    let parameters = "\"detection.threshold\" = 0.001\n\"track.length\" = 300.0";
    let (run, report) = facts(&SmallScenario::heating_a_short_rail(0.2, "", parameters));
    let rails = run["rails"].as_table().unwrap();
    assert_eq!(rails["detection_threshold_k"].as_float(), Some(0.001));
    assert_eq!(rails["length_m"].as_float(), Some(300.0));
    assert!(!report.contains("15 mK") && !report.contains("15.0 mK"), "{report}");
}

#[test]
fn a_locomotive_that_coasts_is_a_locomotive() {
    let mut scenario = SmallScenario::new(0.1);
    scenario.leave_out_heat();
    scenario.driver = "[[command]]\nfrom_s = 0.0\nnotch = 0.0\n".to_owned();
    let (run, _) = facts(&scenario);
    let locomotives = run["locomotives"].as_array().unwrap();
    assert_eq!(locomotives.iter().filter_map(toml::Value::as_integer).collect::<Vec<_>>(), [1]);
}
