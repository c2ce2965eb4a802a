//! Answers for scripts: JSON, schemas, completions, manual pages, exit codes.

use std::process::Output;

use hotfoot_tests::{SmallScenario, fmu, hotfoot, root};
use serde_json::Value;

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| {
        let stderr = String::from_utf8_lossy(&output.stderr);
        panic!("{error}: {} {stderr}", String::from_utf8_lossy(&output.stdout))
    })
}

fn text(output: &Output) -> String {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
fn a_run_and_a_check_answer_in_json() {
    let mut scenario = SmallScenario::new(0.1);
    scenario.leave_out_heat();
    let run = json(&scenario.run(&["--json"]));
    assert_eq!((&run["end"], run["simulated_s"].as_f64()), (&"complete".into(), Some(0.1)));
    let figures = run["figures"].as_array().unwrap();
    assert!(figures.iter().all(|figure| figure["key"].is_string() && figure["unit"].is_string()));
    assert!(run["report"].as_str().unwrap().ends_with("report.html"));

    let good = scenario.hotfoot(&["check", "scenario.toml", "--json"]);
    assert_eq!((good.status.code(), json(&good)["ok"].as_bool()), (Some(0), Some(true)));
    let quiet = scenario.hotfoot(&["check", "scenario.toml", "--quiet"]);
    assert_eq!(text(&quiet), "");
    let bad = ["check", "scenario.toml", "--json", "--set", "train.speed_m_per_s=fast"];
    let bad = scenario.hotfoot(&bad);
    let (code, bad) = (bad.status.code(), json(&bad));
    let problem = &bad["problems"][0];
    assert_eq!(
        (code, bad["ok"].as_bool(), problem["line"].as_u64()),
        (Some(1), Some(false), Some(7))
    );
    assert!(problem["message"].as_str().unwrap().contains("must be a number"), "{problem}");
    scenario.track = scenario.track.replace("radius_m = 800.0", "radius_m = 0.0");
    let bad = json(&scenario.hotfoot(&["check", "scenario.toml", "--json"]));
    assert!(bad["problems"][0]["file"].as_str().unwrap().ends_with("track.toml"), "{bad}");
}

#[test]
fn the_first_line_of_a_finished_run_is_physics() {
    let mut scenario = SmallScenario::new(0.1);
    scenario.leave_out_heat();
    let said = text(&scenario.run(&[]));
    assert!(said.starts_with("Distance run"), "{said}");
    assert!(said.find("per step").unwrap() > said.find("Largest coupler").unwrap());
}

/// A setting reaches wiring and export as it reaches a run.
#[test]
fn settings_hold_for_wiring_and_export() {
    let mut scenario = SmallScenario::new(0.1);
    scenario.leave_out_heat();
    let wiring = |more: &[&str]| {
        let arguments = [&["wiring", "scenario.toml", "--json"][..], more].concat();
        json(&scenario.hotfoot(&arguments))["components"].as_array().unwrap().len()
    };
    assert_eq!(wiring(&[]) - 2, wiring(&["--set", "train.vehicles[2].count=3"]));
    let export =
        ["export-ssp", "scenario.toml", "-o", "t.ssp", "--set", "train.vehicles[2].count=1"];
    assert!(text(&scenario.hotfoot(&export)).contains(" 5 components"));
    let wagon = fmu("vehicle").display().to_string();
    let refused = scenario.hotfoot(&["check", &wagon, "--set", "step_s=1"]);
    let message = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(
        message.contains("--set step_s=1: sets a key of a scenario; an FMU has none"),
        "{message}"
    );
}

#[test]
fn an_interface_says_start_bounds_and_description() {
    let wagon = fmu("vehicle").display().to_string();
    let listed = json(&hotfoot(root(), &["interface", &wagon, "--json"]));
    let variables = listed.as_array().unwrap();
    let of = |name: &str| variables.iter().find(|variable| variable["name"] == name).unwrap();
    let friction = of("friction.coefficient");
    assert_eq!((&friction["causality"], &friction["type"]), (&"input".into(), &"Real".into()));
    assert!(friction["start"].is_string() && friction["min"].is_number(), "{friction}");
    assert!(friction["description"].as_str().unwrap().len() > 5);
    let said = text(&hotfoot(root(), &["interface", &wagon]));
    let heading: Vec<&str> = said.lines().next().unwrap().split_whitespace().collect();
    assert_eq!(heading, ["causality", "type", "name", "unit", "start", "bounds", "description"]);
}

#[test]
fn every_kind_of_file_has_a_schema() {
    for kind in [
        "scenario",
        "track",
        "driver",
        "vehicle",
        "draft-gear",
        "rail",
        "expected",
        "consist",
        "rail-heat",
        "experiment",
    ] {
        let schema = json(&hotfoot(root(), &["schema", kind]));
        assert!(schema["properties"].is_object(), "{kind}");
    }
    for kind in ["weather", "logger", "irregularity", "profile"] {
        let columns = json(&hotfoot(root(), &["schema", kind]));
        assert!(columns["fields"].as_array().unwrap().len() > 1, "{kind}");
    }
    assert_eq!(
        json(&hotfoot(root(), &["schema"])),
        json(&hotfoot(root(), &["schema", "scenario"]))
    );
}

#[test]
fn stock_is_listed_shown_and_sourced() {
    let stock = |arguments: &[&str]| hotfoot(root(), &[&["stock"][..], arguments].concat());
    let list = text(&stock(&["list"]));
    for wanted in
        ["Vehicles", "wagon-ore-40t", "160.0 t", "Draft gears", "2518 kN", "60.2 kg/m", "S1002"]
    {
        assert!(list.contains(wanted), "{wanted}: {list}");
    }
    let shown = text(&stock(&["show", "wagon-ore-40t"]));
    assert!(shown.contains("three-piece bogies") && shown.contains("net braking ratio"), "{shown}");
    assert!(text(&stock(&["source", "friction-gear-m901e"])).contains("Miner TF-880"));
    let vehicles = json(&stock(&["list", "--json"]));
    let wagon = vehicles.as_array().unwrap().iter().find(|entry| entry["name"] == "wagon-ore-40t");
    assert_eq!(wagon.unwrap()["figures"][0]["unit"], "t");
    let refused = stock(&["show", "wagon-of-gold"]);
    let message = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert_eq!(refused.status.code(), Some(1));
    assert!(message.contains("has no entry wagon-of-gold"), "{message}");
}

#[test]
fn shells_and_manuals_know_every_command() {
    let folder = tempfile::tempdir().unwrap();
    text(&hotfoot(folder.path(), &["man", "pages"]));
    let page =
        |name: &str| std::fs::read_to_string(folder.path().join("pages").join(name)).unwrap();
    assert!(page("hotfoot.1").contains("Exit codes"));
    assert!(page("hotfoot-compare.1").contains("Examples"));
    assert!(
        page("hotfoot-stock-list.1").contains("Vehicles")
            || page("hotfoot-stock-list.1").len() > 100
    );
    for shell in ["bash", "zsh", "fish"] {
        let completions = text(&hotfoot(folder.path(), &["completions", shell]));
        assert!(
            completions.contains("critical-speed") && completions.contains("tolerance"),
            "{shell}"
        );
    }
}

/// The exit codes of the help: done, wrong, wrong arguments.
#[test]
fn exit_codes_are_those_of_the_help() {
    let code = |arguments: &[&str]| hotfoot(root(), arguments).status.code();
    assert_eq!(code(&["check", "--rules"]), Some(0));
    assert_eq!(code(&["run", "nowhere"]), Some(1));
    assert_eq!(code(&["run", "--no-such-option"]), Some(2));
    let help = text(&hotfoot(root(), &["--help"]));
    for line in ["0        done", "1        failed", "2        the arguments", "128 + n"] {
        assert!(help.contains(line), "{line}: {help}");
    }
}
