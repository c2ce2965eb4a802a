//! What the program answers to wrong input: a clear message, an exit code, no backtrace.

use std::process::Output;

use hotfoot_tests::{SmallScenario, fmu, hotfoot};

/// The message of a command that must fail, on one line.
fn refusal(output: &Output) -> String {
    assert!(!output.status.success(), "the command succeeded");
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!text.contains("panicked") && !text.contains("RUST_BACKTRACE"), "{text}");
    // Long messages have several lines.
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn assert_says(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "'{part}' is missing in: {message}");
    }
}

#[test]
fn a_typo_is_answered_with_line_and_keys() {
    let mut scenario = SmallScenario::new(1.0);
    scenario.text = scenario.text.replace("duration_s", "durationn_s");
    let message = refusal(&scenario.run(&[]));
    assert_says(
        &message,
        &["there is no key `durationn_s`", "did you mean `duration_s`?", "scenario.toml:2"],
    );
}

#[test]
fn a_folder_without_scenario_is_answered_with_those_below_it() {
    let scenario = SmallScenario::new(1.0);
    let below = scenario.folder.path().join("below");
    std::fs::create_dir_all(below.join("one")).unwrap();
    let answer = || refusal(&scenario.hotfoot(&["run", "below"]));
    let neither = "below: this folder has neither a scenario.toml nor a SystemStructure.ssd";
    assert_says(&answer(), &[neither]);
    std::fs::write(below.join("one/scenario.toml"), "").unwrap();
    assert_says(&answer(), &[neither, "; there are scenarios in", "below/one"]);
}

#[test]
fn a_step_of_zero_is_answered_with_its_bound() {
    let mut scenario = SmallScenario::new(1.0);
    scenario.text = scenario.text.replace("step_s = 0.001", "step_s = 0.0");
    assert_says(&refusal(&scenario.run(&[])), &["step_s = 0.0: must be at least 0.000001"]);
}

/// The times of the command line go before those of the file: 0.1 s in steps of 2 ms, recorded every 50 ms.
#[test]
fn times_of_the_command_line_are_those_of_the_run() {
    let mut scenario = SmallScenario::new(1.0);
    scenario.leave_out_heat();
    scenario.run_well(&["--duration", "0.1", "--step", "0.002", "--interval", "0.05"]);
    let manifest = std::fs::read_to_string(scenario.results().join("manifest.toml")).unwrap();
    let manifest: toml::Table = manifest.parse().unwrap();
    assert_eq!(manifest["run"]["step_s"].as_float(), Some(0.002));
    let series = scenario.results().join("series");
    let table = hotfoot::recording::SeriesReader::open(&series, "vehicles").unwrap();
    let first = [("vehicle", hotfoot::recording::KeyValue::Integer(1))];
    let times = table.read("time", &first).unwrap();
    assert_eq!(times.len(), 3, "{times:?}");
    assert!((times[1] - 0.05).abs() < 1e-12 && (times[2] - 0.1).abs() < 1e-12, "{times:?}");
}

#[test]
fn times_of_the_command_line_that_do_not_fit_are_named() {
    let scenario = SmallScenario::new(1.0);
    let message = refusal(&scenario.run(&["--step", "0.003"]));
    let wanted =
        "with --step 0.003: record.interval_s = 0.1: must be a multiple of step_s = 0.003 s";
    assert_says(&message, &["scenario.toml", wanted]);
    let message = refusal(&scenario.run(&["--interval", "0"]));
    assert_says(&message, &["--interval", "must be greater than zero"]);
}

#[test]
fn a_missing_file_is_named_with_its_key() {
    let mut scenario = SmallScenario::new(1.0);
    scenario.text = scenario.text.replace("\"track.toml\"", "\"trck.toml\"");
    assert_says(
        &refusal(&scenario.run(&[])),
        &["track.file", "trck.toml", "there is no such file", "did you mean `track.toml`?"],
    );
}

#[test]
fn a_curve_radius_of_zero_is_answered_with_key_and_remedy() {
    let mut scenario = SmallScenario::new(1.0);
    scenario.track = scenario.track.replace("radius_m = 800.0", "radius_m = 0.0");
    let message = refusal(&scenario.run(&[]));
    assert_says(&message, &["alignment[2].radius_m = 0.0", "at least 50 m"]);
}

#[test]
fn a_negative_mass_is_answered_with_file_and_key() {
    let scenario = SmallScenario::new(1.0);
    let stock = scenario.folder.path().join("stock");
    hotfoot_tests::copy_folder(&hotfoot_tests::root().join("stock"), &stock);
    let file = stock.join("vehicles/locomotive-coco-134t.toml");
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, text.replacen("mass_kg = 134000.0", "mass_kg = -1.0", 1)).unwrap();
    let mut own_stock = scenario;
    let line = own_stock.text.lines().find(|line| line.starts_with("stock")).unwrap().to_owned();
    own_stock.text = own_stock.text.replace(&line, "stock = \"stock\"");
    let message = refusal(&own_stock.run(&[]));
    assert_says(&message, &["locomotive-coco-134t.toml", "mass_kg", "-1"]);
}

#[test]
fn a_corrupt_fmu_is_named() {
    let mut scenario = SmallScenario::new(1.0);
    std::fs::write(scenario.folder.path().join("bad.fmu"), "no archive").unwrap();
    scenario.text += "\n[fmus]\nvehicle = \"bad.fmu\"\n";
    assert_says(&refusal(&scenario.run(&[])), &["bad.fmu", "not a usable FMU"]);
}

#[test]
fn an_fmu_without_a_needed_variable_is_answered_with_its_name() {
    let mut scenario = SmallScenario::new(1.0);
    let railheat = fmu("railheat");
    scenario.text += &format!("\n[fmus]\nvehicle = \"{}\"\n", railheat.display());
    let message = refusal(&scenario.run(&[]));
    assert_says(
        &message,
        &["railheat.fmu cannot be used as vehicle", "'initial.position' is missing"],
    );
}

#[test]
fn check_tells_in_words_what_is_missing() {
    let folder = tempfile::tempdir().unwrap();
    let path = fmu("vehicle");
    let path = path.to_str().unwrap();
    assert!(hotfoot(folder.path(), &["check", path, "--as", "vehicle"]).status.success());
    let message = refusal(&hotfoot(folder.path(), &["check", path, "--as", "longitudinal"]));
    assert_says(&message, &["output 'vehicle[1].position' is missing"]);
}

#[test]
fn a_vehicle_type_that_is_not_in_stock_is_named() {
    let mut scenario = SmallScenario::new(1.0);
    scenario.text = scenario.text.replace("wagon-coco-134t-unpowered", "wagon-of-gold");
    assert_says(&refusal(&scenario.run(&[])), &["wagon-of-gold"]);
}

#[test]
fn a_corrupt_package_is_named() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("bad.ssp"), "no archive").unwrap();
    let message = refusal(&hotfoot(folder.path(), &["run", "bad.ssp", "--results", "r"]));
    assert_says(&message, &["bad.ssp"]);
}

#[test]
fn a_step_of_zero_for_a_package_is_answered() {
    let scenario = SmallScenario::new(1.0);
    let exported = scenario.hotfoot(&["export-ssp", "scenario.toml", "-o", "train.ssp"]);
    assert!(exported.status.success(), "{}", String::from_utf8_lossy(&exported.stderr));
    let output = String::from_utf8_lossy(&exported.stdout).into_owned();
    assert_says(&output, &["12 components", "350 connections"]);
    let run = ["run", "train.ssp", "--results", "r", "--step", "0"];
    assert_says(&refusal(&scenario.hotfoot(&run)), &["--step", "must be greater than zero"]);
}

/// What a scenario sets for a single vehicle travels with the package, an input too.
#[test]
fn an_input_that_keeps_a_value_is_in_the_package() {
    let mut scenario = SmallScenario::new(1.0);
    let vehicle = fmu("vehicle").display().to_string();
    scenario.text += &format!(
        "\n[fmus]\nvehicle_at = [{{ place = 3, file = \"{vehicle}\", \
         parameters = {{ \"friction.coefficient\" = 0.125 }} }}]\n"
    );
    let exported = scenario.hotfoot(&["export-ssp", "scenario.toml", "-o", "train.ssp"]);
    assert!(exported.status.success(), "{}", String::from_utf8_lossy(&exported.stderr));
    let package = std::fs::File::open(scenario.folder.path().join("train.ssp")).unwrap();
    let mut package = zip::ZipArchive::new(package).unwrap();
    let structure = package.by_name("SystemStructure.ssd").unwrap();
    let structure = std::io::read_to_string(structure).unwrap();
    let with_friction: Vec<_> = structure
        .split("<ssd:Component ")
        .filter(|component| component.contains("\"friction.coefficient\""))
        .collect();
    assert_eq!(with_friction.len(), 1, "{structure}");
    assert_says(with_friction[0], &["name=\"vehicle_3\"", "value=\"0.125\""]);
}

/// The small scenario with one more line in its table of heat.
fn with_heat(line: &str) -> SmallScenario {
    let mut scenario = SmallScenario::new(1.0);
    scenario.text = scenario.text.replace("[heat]\n", &format!("[heat]\n{line}\n"));
    scenario
}

#[test]
fn a_parameter_of_the_wrong_type_is_answered_with_the_right_one() {
    let scenario = with_heat("parameters = { \"train.shade\" = 0.5 }");
    let message = refusal(&scenario.run(&[]));
    assert_says(
        &message,
        &["scenario.toml:", "heat.parameters.\"train.shade\" = 0.5: must be true or false"],
    );
}

#[test]
fn a_parameter_that_the_rail_has_not_is_named() {
    let scenario = with_heat("parameters = { \"section.raill\" = \"60E1\" }");
    let message = refusal(&scenario.run(&[]));
    assert_says(
        &message,
        &[
            "heat.parameters.\"section.raill\" = \"60E1\"",
            "there is no such parameter; did you mean `section.rail`?",
        ],
    );
}

#[test]
fn an_output_is_no_parameter() {
    let scenario = with_heat("parameters = { \"energy.stored\" = 1.0 }");
    assert_says(&refusal(&scenario.run(&[])), &["energy.stored", "is no parameter but output"]);
}

#[test]
fn trains_that_overlap_are_refused_with_the_shortest_headway() {
    let scenario = with_heat("trains = { count = 2, headway_minutes = 0.01 }");
    let message = refusal(&scenario.run(&[]));
    assert_says(&message, &["heat.trains.headway_minutes", "0.01 min", "duration_s = 1 s"]);
}

#[test]
fn a_wrong_line_of_a_weather_file_is_answered_with_the_users_file() {
    let mut scenario = with_heat("parameters = { weather_file = \"weather.csv\" }");
    scenario.text = scenario.text.replace("model = \"paper\"", "model = \"energy\"");
    let file = scenario.folder.path().join("weather.csv");
    std::fs::write(&file, "time_s,air\n0,300\n").unwrap();
    let message = refusal(&scenario.run(&[]));
    assert_says(&message, &["weather.csv:1:1: the columns must be time_s,air_degC"]);
    assert!(!message.contains("resources"), "the copy is not named: {message}");
}

/// A setting goes before the file: the notch stays, the speed is that of the option, and the manifest has both.
#[test]
fn settings_of_the_command_line_go_before_the_file() {
    let mut scenario = SmallScenario::new(0.05);
    scenario.leave_out_heat();
    let settings = ["--set", "train.speed_m_per_s=10", "--set", "train.couplers=unstressed"];
    scenario.run_well(&settings);
    let manifest = std::fs::read_to_string(scenario.results().join("manifest.toml")).unwrap();
    let manifest: toml::Table = manifest.parse().unwrap();
    let ran: toml::Table = manifest["scenario"].as_str().unwrap().parse().unwrap();
    assert_eq!(ran["train"]["speed_m_per_s"].as_integer(), Some(10));
    assert_eq!(ran["train"]["couplers"].as_str(), Some("unstressed"));
    let series = scenario.results().join("series");
    let table = hotfoot::recording::SeriesReader::open(&series, "vehicles").unwrap();
    let first = [("vehicle", hotfoot::recording::KeyValue::Integer(1))];
    assert_eq!(table.read("velocity", &first).unwrap()[0], 10.0);
}

#[test]
fn a_setting_that_is_wrong_is_named() {
    let scenario = SmallScenario::new(1.0);
    for (setting, parts) in [
        ("train.speed_m_per_s=fast", ["train.speed_m_per_s = \"fast\": must be a number", "7:17"]),
        (
            "train.sped=20",
            ["there is no key `sped` in train", "Known here: `leading_vehicle_position_m`"],
        ),
        ("duration_s=-1", ["duration_s = -1: must be at least", "scenario.toml with --set"]),
        ("train.vehicles[7].count=2", ["cannot be set", "element of a list that is there"]),
        ("speed", ["a key and its value, as in train.speed_m_per_s=20", "--set <KEY=VALUE>"]),
    ] {
        let message = refusal(&scenario.run(&["--set", setting]));
        assert_says(&message, &parts);
    }
    let fmu = fmu("synchronisation").display().to_string();
    let message = refusal(&hotfoot(scenario.folder.path(), &["run", &fmu, "--set", "step_s=1"]));
    assert_says(&message, &["--set step_s=1", "a package or an FMU has none"]);
}

/// A new scenario runs as it is, and is not written over one that is there.
#[test]
fn a_new_scenario_runs() {
    let folder = tempfile::tempdir().unwrap();
    for (template, name) in [("first-look", "first-look"), ("wet-rail", "rain")] {
        let arguments: &[&str] = match name {
            "first-look" => &["new"],
            name => &["new", name, "--from", template],
        };
        let output = hotfoot(folder.path(), arguments);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        assert_says(&said, &[&format!("hotfoot run {name}")]);
        let mut run = vec!["run", name, "--duration", "0.05", "--quiet"];
        if template == "first-look" {
            run.extend(["--set", "heat.cool_down_minutes=0"]);
        }
        let run = hotfoot(folder.path(), &run);
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    }
    let again = refusal(&hotfoot(folder.path(), &["new"]));
    assert_says(&again, &["first-look is there already; name another folder"]);
    let nowhere = refusal(&hotfoot(folder.path(), &["new", "x", "--stock", "nowhere"]));
    assert_says(&nowhere, &["there is no library of rolling stock", "--stock"]);
    assert!(!folder.path().join("x").exists());
}

/// A shipped scenario is known by its name, and one of the user's that names no stock gets the shipped one.
#[test]
fn what_is_shipped_is_found_beside_the_folder_of_the_program() {
    let folder = tempfile::tempdir().unwrap();
    let mut own = SmallScenario::new(0.05);
    own.text =
        own.text.lines().filter(|line| !line.starts_with("stock")).collect::<Vec<_>>().join("\n");
    let shipped = hotfoot(folder.path(), &["run", "train-alone", "--duration", "0.1", "--quiet"]);
    for output in [shipped, own.run(&[])] {
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
    assert!(folder.path().join("results/train-alone/report.html").exists());
    let neither = refusal(&hotfoot(folder.path(), &["run", "train-together"]));
    assert_says(&neither, &["train-together", "there is no such file"]);
}

/// With the paper's model terminal and report say what not to read from its numbers.
#[test]
fn the_papers_model_is_named_as_such() {
    let caution = "Do not read from them whether, when or where the foot warms";
    let scenario = SmallScenario::new(0.05);
    assert!(scenario.text.contains("model = \"paper\""));
    let output = scenario.run(&[]);
    assert_says(&String::from_utf8_lossy(&output.stdout), &["the paper's model", caution]);
    let report = std::fs::read_to_string(scenario.results().join("report.html")).unwrap();
    assert_says(&report, &[caution]);
    let output = scenario.run(&["--set", "heat.model=energy"]);
    assert!(output.status.success() && !String::from_utf8_lossy(&output.stdout).contains(caution));
}
