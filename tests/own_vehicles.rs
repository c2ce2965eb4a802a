//! Vehicles whose file lies beside the scenario.

use hotfoot::recording::{KeyValue, SeriesReader};
use hotfoot_tests::SmallScenario;

use crate::hostile::{assert_says, refusal};

/// The wagons of the short train have a file of their own.
fn with_own_wagons(file: &str) -> SmallScenario {
    let mut scenario = SmallScenario::new(0.05);
    scenario.leave_out_heat();
    let path = scenario.folder.path().join(file);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    let text = "extends = \"wagon-ore-40t\"\nname = \"a wagon of our own\"\n[brake]\nnet_braking_ratio = 0.2\n";
    std::fs::write(path, text).unwrap();
    scenario.text = scenario.text.replace("wagon-coco-134t-unpowered", file);
    scenario
}

/// The vehicle that it extends has four wheelsets, that of the small scenario six.
#[test]
fn a_vehicle_file_beside_the_scenario_is_run_and_packed() {
    let mut scenario = with_own_wagons("wagons/mine.toml");
    scenario.text += "\n[record]\nwheels_of = [2]\n";
    scenario.run_well(&[]);
    let wheels = SeriesReader::open(&scenario.results().join("series"), "wheels").unwrap();
    let wheelsets = |number| {
        let keys = [("vehicle", KeyValue::Integer(2)), ("wheelset", KeyValue::Integer(number))];
        wheels.read("friction_power", &keys).unwrap().len()
    };
    assert!(wheelsets(4) > 0 && wheelsets(5) == 0);
    assert!(scenario.results().join("fmus/mine.fmu").is_file());
    let exported = scenario.hotfoot(&["export-ssp", "scenario.toml", "-o", "train.ssp"]);
    assert!(exported.status.success(), "{}", String::from_utf8_lossy(&exported.stderr));
}

#[test]
fn a_vehicle_file_that_cannot_be_taken_is_named() {
    let scenario = with_own_wagons("wagon-ore-40t.toml");
    let taken = refusal(&scenario.run(&[]));
    assert_says(&taken, &["train.vehicles[2].type", "the stock library", "rename the file"]);

    let mut scenario = with_own_wagons("mine.toml");
    scenario.text = scenario.text.replace("\"mine.toml\"", "\"mien.toml\"");
    let missing = refusal(&scenario.run(&[]));
    assert_says(&missing, &["train.vehicles[2].type = \"mien.toml\"", "did you mean `mine.toml`"]);

    let scenario = with_own_wagons("mine.toml");
    std::fs::write(scenario.folder.path().join("mine.toml"), "extends = \"wagon-ore\"\n").unwrap();
    let wrong = refusal(&scenario.run(&[]));
    assert_says(&wrong, &["mine.toml:1", "extends", "did you mean `wagon-ore-40t`"]);
}
