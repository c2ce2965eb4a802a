//! Wheel and rail profiles that a vehicle file names as files of points: they go into the FMUs with the
//! rolling-stock library, and what is wrong with them is told by vehicle file and key.

use hotfoot_tests::{PAGE, SmallScenario, copy_folder, root};
use validation::Finding;

/// Vehicle file of the wagon of the small scenario with a worn wheel.
const WORN: &str = "extends = \"wagon-coco-134t-unpowered\"\n\
                    multibody.contact.wheel = \"profiles/worn.prw\"\n";

/// The small scenario with a library of its own, in which the wagons are `wagon-worn`.
fn worn_wagons(duration: f64, vehicle: &str) -> SmallScenario {
    let mut scenario = SmallScenario::new(duration);
    let stock = scenario.folder.path().join("stock");
    copy_folder(&root().join("stock"), &stock);
    copy_folder(&root().join("tests/profiles"), &stock.join("profiles"));
    std::fs::write(stock.join("vehicles/wagon-worn.toml"), vehicle).unwrap();
    let shipped = root().join("stock").display().to_string();
    scenario.text = scenario
        .text
        .replace(&format!("stock = \"{shipped}\""), "stock = \"stock\"")
        .replace("wagon-coco-134t-unpowered", "wagon-worn");
    scenario
}

/// What a run that must fail says.
fn refusal(scenario: &SmallScenario) -> String {
    let output = scenario.run(&[]);
    assert!(!output.status.success(), "the run succeeded");
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!text.contains("panicked"), "{text}");
    text
}

/// The packed FMU holds the file and runs where the library is gone.
#[test]
fn a_profile_file_goes_into_the_fmu() {
    let scenario = worn_wagons(0.2, WORN);
    scenario.run_well(&[]);
    let packed = scenario.results().join("fmus/wagon-worn.fmu");
    let kept = std::fs::read(root().join("tests/profiles/worn.prw")).unwrap();
    let mut archive = zip::ZipArchive::new(std::fs::File::open(&packed).unwrap()).unwrap();
    let mut inside = vec![];
    let mut file = archive.by_name("resources/stock/profiles/worn.prw").unwrap();
    std::io::copy(&mut file, &mut inside).unwrap();
    assert_eq!(inside, kept);

    let mut elsewhere = SmallScenario::new(0.2);
    let alone = elsewhere.folder.path().join("worn.fmu");
    std::fs::copy(&packed, &alone).unwrap();
    drop(scenario);
    elsewhere.text += "\n[fmus]\nvehicle_at = [{ place = 5, file = \"worn.fmu\" }]\n";
    elsewhere.run_well(&[]);
    Finding {
        case: "vehicle whose wheel profile is a file of points",
        expected: "its FMU holds the file and runs where the library is gone",
        source: "the file",
    }
    .stands_in(&PAGE);
}

#[test]
fn a_missing_profile_file_is_told_with_vehicle_file_and_key() {
    let text = refusal(&worn_wagons(0.2, &WORN.replace("worn.prw", "gone.prw")));
    for part in [
        "stock/vehicles/wagon-worn.toml",
        "multibody.contact.wheel = \"profiles/gone.prw\"",
        "stock/profiles/gone.prw: No such file",
    ] {
        assert!(text.contains(part), "'{part}' is missing in: {text}");
    }
}

#[test]
fn a_profile_file_outside_of_the_library_is_refused() {
    let text = refusal(&worn_wagons(0.2, &WORN.replace("profiles/", "../profiles/")));
    assert!(text.contains("must be a path inside of the rolling-stock library"), "{text}");
}

#[test]
fn a_profile_file_without_points_is_told_with_vehicle_file_and_line() {
    let scenario = worn_wagons(0.2, WORN);
    let file = scenario.folder.path().join("stock/profiles/worn.prw");
    std::fs::write(&file, "0.0 0.0\n1.0 height\n").unwrap();
    let text = refusal(&scenario);
    for part in [
        "stock/vehicles/wagon-worn.toml",
        "multibody.contact.wheel",
        "stock/profiles/worn.prw: line 2: expected two numbers",
    ] {
        assert!(text.contains(part), "'{part}' is missing in: {text}");
    }
}
