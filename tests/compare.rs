//! `hotfoot compare`: runs with each other and with measurements.

use std::path::Path;
use std::process::Output;

use hotfoot::recording::{KeyValue, SeriesReader};
use hotfoot_tests::{SmallScenario, hotfoot};

/// Three runs in the folders `a`, `a-again` and `b` of a train alone, the last one faster and in a sharper
/// curve.
fn runs() -> SmallScenario {
    let mut scenario = SmallScenario::new(2.0);
    scenario.leave_out_heat();
    scenario.text = scenario.text.replace("title", "train_alone = true\ntitle");
    let run = |scenario: &SmallScenario, results: &str, more: &[&str]| {
        let arguments =
            [&["run", "scenario.toml", "--quiet", "--results", results][..], more].concat();
        let output = scenario.hotfoot(&arguments);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    };
    run(&scenario, "a", &[]);
    run(&scenario, "a-again", &["--interval", "0.2"]);
    scenario.track = scenario.track.replace("radius_m = 800.0", "radius_m = 600.0");
    run(&scenario, "b", &["--set", "train.speed_m_per_s=18", "--interval", "0.15"]);
    scenario
}

fn text(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn json(output: &Output) -> serde_json::Value {
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|error| panic!("{error}: {}", String::from_utf8_lossy(&output.stderr)))
}

fn column<'j>(comparison: &'j serde_json::Value, table: &str, name: &str) -> &'j serde_json::Value {
    let columns = comparison["compared"][0]["columns"].as_array().unwrap();
    let found = columns.iter().find(|c| c["table"] == table && c["column"] == name);
    found.unwrap_or_else(|| panic!("{table}.{name}"))
}

fn velocity(folder: &Path, results: &str) -> (Vec<f64>, Vec<f64>) {
    let table = SeriesReader::open(&folder.join(results).join("series"), "vehicles").unwrap();
    let first = [("vehicle", KeyValue::Integer(1))];
    (table.read("time", &first).unwrap(), table.read("velocity", &first).unwrap())
}

#[test]
fn runs_are_compared_with_each_other_and_with_a_measurement() {
    let scenario = runs();
    let folder = scenario.folder.path();
    let compare = |arguments: &[&str]| hotfoot(folder, &[&["compare"][..], arguments].concat());

    // The same, and the same at the times of the coarser one, which the finer one has too.
    let same = compare(&["a", "a", "--tolerance", "1e-12"]);
    assert_eq!(same.status.code(), Some(0), "{}", text(&same));
    assert!(text(&same).contains("0 of "), "{}", text(&same));
    assert!(folder.join("comparison.html").exists());
    let shared = json(&compare(&["a", "a-again", "--json"]));
    let of_speed = column(&shared, "vehicles", "velocity");
    assert_eq!((&of_speed["times"], of_speed["max_abs"].as_f64()), (&"shared".into(), Some(0.0)));
    assert_eq!((of_speed["count"].as_u64(), of_speed["rows"].as_u64()), (Some(11), Some(5)));

    // Another run: what differs of its inputs, and by how much at the start, by hand.
    let differs = compare(&["a", "b", "--tolerance", "1e-6", "--output", "page.html"]);
    assert_eq!(differs.status.code(), Some(1), "{}", text(&differs));
    for wanted in [
        "scenario.toml: train.speed_m_per_s: 16.67 → 18",
        "track.toml: alignment[2].radius_m: 800.0 → 600.0",
        "vehicles.velocity",
        "page: page.html",
    ] {
        assert!(text(&differs).contains(wanted), "{wanted}: {}", text(&differs));
    }
    let page = std::fs::read_to_string(folder.join("page.html")).unwrap();
    assert!(page.contains("alignment[2].radius_m") && !page.contains("src=\"http"));
    let other = json(&compare(&["a", "b", "--json"]));
    let of_speed = column(&other, "vehicles", "velocity");
    assert_eq!(of_speed["times"], "interpolated");
    assert!(of_speed["max_abs"].as_f64().unwrap() >= 18.0 - 16.67 - 1e-6, "{of_speed}");

    // A measurement in km/h that is 3.6 km/h too fast throughout.
    let (times, speeds) = velocity(folder, "a");
    let rows = times.iter().zip(&speeds);
    let rows: String =
        rows.map(|(time, v)| format!("{},{},7\n", time + 100.0, 3.6 * (v + 1.0))).collect();
    std::fs::write(folder.join("m.csv"), format!("Zeit,GPS [km/h],Pressure\n{rows}")).unwrap();
    let measured =
        ["a", "m.csv", "--map", "GPS=vehicles[1].velocity", "--time", "Zeit", "--shift", "-100"];
    let found = json(&compare(&[&measured[..], &["--json"]].concat()));
    let of_speed = column(&found, "vehicles", "velocity");
    for measure in ["max_abs", "rms", "final"] {
        let value = of_speed[measure].as_f64().unwrap();
        assert!((value - 1.0).abs() < 1e-9, "{measure} {value}");
    }
    let homeless = found["compared"][0]["only_in_other"][0].as_str().unwrap();
    assert!(homeless.starts_with("Pressure: no signal of a has this name"), "{homeless}");

    wrong_measurements(folder);
}

/// Two speeds on one rail, and the second on a shorter one, whose elements are others.
#[test]
fn fields_of_rails_are_compared_where_their_grids_are_the_same() {
    let keys = "field_interval_s = 0.5\nprobe = [{ chainage_m = 8.0 }]";
    let scenario = SmallScenario::heating_a_short_rail(1.0, keys, "");
    let run = |results: &str, setting: &str| {
        let arguments = ["run", "scenario.toml", "--quiet", "--results", results, "--set", setting];
        let output = scenario.hotfoot(&arguments);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    };
    run("a", "train.speed_m_per_s=16");
    run("b", "train.speed_m_per_s=18");
    run("shorter", "heat.length_m=50");
    let folder = scenario.folder.path();
    let compare = |other: &str, more: &[&str]| {
        hotfoot(folder, &[&["compare", "a", other][..], more].concat())
    };
    let other = json(&compare("b", &["--json"]));
    let fields = other["compared"][0]["fields"].as_array().unwrap();
    let variables: Vec<&str> = fields.iter().map(|f| f["variable"].as_str().unwrap()).collect();
    assert_eq!(variables, ["temperature_rise", "section_rise"]);
    let [rise, section] = [&fields[0], &fields[1]];
    assert!(rise["max_abs"].as_f64().unwrap() > 1e-3, "{rise}");
    assert!(rise["rms"].as_f64().unwrap() < rise["max_abs"].as_f64().unwrap(), "{rise}");
    assert_eq!((rise["count"].as_u64(), rise["at_s"].as_f64()), (Some(3), Some(1.0)));
    assert!((section["chainage_m"].as_f64().unwrap() - 8.0).abs() < 0.5, "{section}");
    let shown = text(&compare("b", &["--output", "fields.html"]));
    assert!(shown.contains("rail.zarr temperature_rise: largest"), "{shown}");
    let page = std::fs::read_to_string(folder.join("fields.html")).unwrap();
    assert!(page.contains("Fields of the rails") && page.contains("rail.zarr section_rise"));
    let same = text(&compare("a", &[]));
    assert!(same.contains("rail.zarr section_rise: no difference, in 3 snapshots"), "{same}");
    let shorter = json(&compare("shorter", &["--json"]));
    let sentence = shorter["compared"][0]["fields_not_compared"][0].as_str().unwrap();
    assert!(sentence.starts_with("rail.zarr is not compared: the grids differ, "), "{sentence}");
    assert!(sentence.contains("heat.length_m"), "{sentence}");
}

fn wrong_measurements(folder: &Path) {
    let refused = |arguments: &[&str]| {
        let output = hotfoot(folder, &[&["compare", "a"][..], arguments].concat());
        assert_eq!(output.status.code(), Some(1), "{}", text(&output));
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    std::fs::write(folder.join("n.csv"), "time,GPS [bar]\n0,1\n0,2\n").unwrap();
    std::fs::write(folder.join("u.csv"), "time,GPS [bar]\n0,1\n1,2\n").unwrap();
    for (arguments, wanted) in [
        (
            &["m.csv"][..],
            "there is no column time, time_s or t; name the column of times by --time",
        ),
        (&["m.csv", "--time", "Zeitt"], "there is no column Zeitt; did you mean `Zeit`?"),
        (&["m.csv", "--time", "Zeit"], "no column is a signal"),
        (
            &["m.csv", "--time", "Zeit", "--map", "GPSS=vehicles[1].velocity"],
            "there is no column GPSS; did you mean `GPS`?",
        ),
        (
            &["m.csv", "--time", "Zeit", "--map", "GPS=vehicles[1].velocty"],
            "the run has no signal vehicles[1].velocty; did you mean `vehicles[1].velocity`?",
        ),
        (&["n.csv", "--map", "GPS=vehicles[1].velocity"], "n.csv:3:1: time = 0: must be later"),
        (
            &["u.csv", "--map", "GPS=vehicles[1].velocity"],
            "GPS is in bar, but its signal in m/s; its unit can be m/s, km/h, mph",
        ),
        (&["b", "--shift", "3"], "are of the columns of a measurement"),
        (&["scenario.toml"], "scenario.toml"),
        (&["nowhere"], "nowhere"),
    ] {
        let message = refused(arguments);
        assert!(message.contains(wanted), "{arguments:?}: {message}");
    }
}
