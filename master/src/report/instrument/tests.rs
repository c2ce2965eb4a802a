//! The numbers of the linked view, decoded as the page does it.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::Value;

use super::Instrument;
use crate::report::facts::RunFacts;
use crate::report::invented::{SPEED, facts, write_run};
use crate::report::rail_figures;
use crate::report::results::Results;

fn instrument(facts: &RunFacts) -> Value {
    let folder = tempfile::tempdir().unwrap();
    write_run(folder.path(), facts);
    let results = Results::open(folder.path()).unwrap();
    let rails = facts.rails.as_ref();
    let rails = rails.map_or(vec![], |r| rail_figures::of_run(folder.path(), r).unwrap());
    let instrument = Instrument::of(folder.path(), &results, &rails).unwrap();
    assert!(instrument.unread.is_empty(), "{:?}", instrument.unread);
    serde_json::from_str(&instrument.json()).unwrap()
}

fn floats(packed: &Value) -> Vec<f32> {
    let bytes = STANDARD.decode(packed.as_str().expect("a text")).unwrap();
    bytes.chunks_exact(4).map(|bytes| f32::from_le_bytes(bytes.try_into().unwrap())).collect()
}

fn quantity<'v>(quantities: &'v Value, name: &str) -> &'v Value {
    let mut all = quantities.as_array().unwrap().iter();
    all.find(|quantity| quantity["name"] == name).unwrap_or_else(|| panic!("{name} is missing"))
}

/// 20 s at 0.1 s are 201 records, of which all are shown; the second vehicle follows 20 m behind.
#[test]
fn analytic_vehicles_are_where_the_run_has_them() {
    let run = instrument(&facts());
    let all = &run["train"]["all"];
    let time = floats(&all["time"]);
    assert_eq!((all["every"].as_u64(), time.len()), (Some(1), 201));
    let position = floats(&quantity(&all["quantities"], "position")["value"]);
    assert_eq!(position.len(), 201 * 10);
    assert!((f64::from(position[100 * 10 + 1]) - (10.0 * SPEED - 20.0)).abs() < 1e-4);
    let highest = floats(&run["train"]["coupler_highest"]);
    assert_eq!(highest, (0..10).map(|index| 1e4 * (9 - index) as f32).collect::<Vec<_>>());
}

#[test]
fn a_vehicle_that_the_train_has_not_is_left_out() {
    let run = instrument(&facts());
    let recorded = run["train"]["recorded"].as_array().unwrap();
    let numbers: Vec<_> = recorded.iter().map(|one| one["number"].as_u64().unwrap()).collect();
    assert_eq!(numbers, [1, 2, 3, 10]);
    let force = quantity(&recorded[0]["quantities"], "coupler_rear_force");
    assert_eq!(force["unit"], "N");
    assert_eq!(floats(&force["lowest"]), floats(&force["value"]));
}

/// Rises fall with depth from 2 K at 20 s, with a length of 10 mm: at 2 mm depth 2 K exp(−0.2).
#[test]
fn analytic_the_field_is_that_of_its_store() {
    let run = instrument(&facts());
    let field = &run["rails"][0]["field"];
    assert!(run["rails"][1]["field"].is_null(), "no field was written of the right rail");
    assert_eq!(floats(&field["time"]), [10.0, 20.0], "a time that was not reached is no other");
    let (chainage, depth) = (floats(&field["chainage"]), floats(&field["depth"]));
    assert_eq!((field["elements"].as_u64(), chainage.len(), depth.len()), (Some(1), 100, 40));
    let steps = STANDARD.decode(field["rise"]["steps"].as_str().unwrap()).unwrap();
    let row = depth.len();
    let column = chainage.iter().position(|&at| at == 100.5).unwrap();
    let at = 2 * (row * chainage.len() + column);
    let rise = f32::from(i16::from_le_bytes([steps[at], steps[at + 1]]))
        * floats(&field["rise"]["step"])[row];
    assert!((f64::from(rise) - 2.0 * (-0.2_f64).exp()).abs() < 1e-4, "{rise}");
}

/// At 20 s the cells of the first probe have 0, 1, 2 K and those of the second 3, 4, 5 K.
#[test]
fn analytic_the_sections_are_those_of_the_store() {
    let run = instrument(&facts());
    let sections = &run["rails"][0]["field"]["sections"];
    assert_eq!(floats(&sections["time"]), [10.0, 20.0]);
    assert_eq!(floats(&sections["chainage"]), [100.5, 120.5]);
    let size = sections["size"].as_array().unwrap();
    assert!(size.iter().all(|size| (size.as_f64().unwrap() - 4e-3).abs() < 1e-9), "{size:?}");
    let steps = STANDARD.decode(sections["rise"]["steps"].as_str().unwrap()).unwrap();
    let last = i16::from_le_bytes([steps[22], steps[23]]);
    let rise = f32::from(last) * floats(&sections["rise"]["step"])[3];
    assert!((rise - 5.0).abs() < 1e-3, "{rise}");
    // Where the foot is warmest the last cell has 2.5 K and then 5 K.
    let warmest = &sections["warmest"];
    assert_eq!(floats(&warmest["chainage"]), [94.0, 99.0]);
    let steps = STANDARD.decode(warmest["rise"]["steps"].as_str().unwrap()).unwrap();
    let rises = [4, 10].map(|at| f32::from(i16::from_le_bytes([steps[at], steps[at + 1]])));
    let steps = floats(&warmest["rise"]["step"]);
    assert!((rises[0] * steps[0] - 2.5).abs() < 1e-3 && (rises[1] * steps[1] - 5.0).abs() < 1e-3);
}

/// What was run without rails or vehicles in three dimensions has neither, and a page cannot be ended by a text.
#[test]
fn what_a_run_has_not_is_left_out() {
    let run = instrument(&RunFacts { rails: None, train_alone: true, ..facts() });
    assert_eq!(run["rails"].as_array().map(Vec::len), Some(0));
    assert!(run["threshold"].is_null());
    let names = |quantities: &Value| -> Vec<String> {
        let all = quantities.as_array().unwrap().iter();
        all.map(|quantity| quantity["name"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(names(&run["train"]["all"]["quantities"]), ["position", "coupler_rear_force"]);
    let folder = tempfile::tempdir().unwrap();
    write_run(folder.path(), &facts());
    let results = Results::open(folder.path()).unwrap();
    let mut instrument = Instrument::of(folder.path(), &results, &[]).unwrap();
    instrument.train_alone = true;
    assert!(!instrument.json().contains('<'));
}
