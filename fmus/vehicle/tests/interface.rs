//! The vehicle as a model behind its FMU interface.

use std::path::{Path, PathBuf};

use fmu::{Declaration, Interval, Log, Model, ModelError, Values};
use vehicle::Vehicle;

const TRACK: &str = "alignment = [{ length_m = 1e5, radius_m = 800.0, cant_mm = 40.0 }]";

/// A resources folder with the locomotive and a track.
fn resources(name: &str, vehicle: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let stock = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../stock/vehicles");
    let copy = folder.join("stock/vehicles");
    std::fs::create_dir_all(&copy).unwrap();
    for file in std::fs::read_dir(stock).unwrap() {
        let file = file.unwrap();
        std::fs::copy(file.path(), copy.join(file.file_name())).unwrap();
    }
    std::fs::write(folder.join("vehicle.toml"), vehicle).unwrap();
    std::fs::write(folder.join("track.toml"), TRACK).unwrap();
    folder
}

const LOCOMOTIVE: &str = "extends = \"locomotive-coco-134t\"";

struct Bench {
    declaration: Declaration,
    signals: <Vehicle as Model>::Signals,
    values: Values,
    resources: PathBuf,
}

impl Bench {
    fn new(resources: PathBuf) -> Result<Self, ModelError> {
        let mut declaration = Declaration::default();
        let signals = Vehicle::declare(&resources, &mut declaration)?;
        let values = declaration.start_values().clone();
        Ok(Self { declaration, signals, values, resources })
    }

    fn start(&mut self) -> Result<Vehicle, ModelError> {
        let log = &mut Log::default();
        Vehicle::initialize(&self.signals, &mut self.values, &self.resources, 0.0, log)
    }

    fn step(&mut self, vehicle: &mut Vehicle, length: f64) -> Result<(), ModelError> {
        let interval = Interval { start: 0.0, length };
        vehicle.step(&self.signals, &mut self.values, interval, &mut Log::default())
    }

    /// Values of all Real variables.
    fn reals(&self) -> Vec<u64> {
        let json = serde_json::to_value(&self.values).unwrap();
        let reals = json["reals"].as_array().unwrap();
        reals.iter().map(|value| value.as_f64().unwrap().to_bits()).collect()
    }
}

#[test]
fn the_interface_has_the_names_of_the_design() {
    let bench = Bench::new(resources("names", LOCOMOTIVE)).unwrap();
    let variables = bench.declaration.variables();
    let names: Vec<&str> = variables.iter().map(|v| v.name.as_str()).collect();
    for name in [
        "vehicle_file",
        "track_file",
        "initial.position",
        "initial.velocity",
        "coupler.front.force",
        "coupler.rear.force",
        "resistance.force",
        "traction.force",
        "brake.force",
        "sync.force",
        "friction.coefficient",
        "position",
        "velocity",
        "acceleration",
        "wheelset[6].position",
        "wheelset[1].left.creepage.longitudinal",
        "wheelset[1].left.creepage.lateral",
        "wheelset[1].right.creepage.spin",
        "wheelset[6].right.force.longitudinal",
        "wheelset[6].right.force.lateral",
        "wheelset[6].right.force.normal",
        "wheelset[6].right.friction_power",
        "wheelset[6].right.contact.a",
        "wheelset[6].right.contact.b",
        "wheelset[6].right.contact.flash_factor",
        "wheelset[6].right.contact.lateral_position",
        "wheelset[1].right.derailment_quotient",
        "wheelset[6].track_force.lateral_sum",
        "body.acceleration.lateral",
        "bogie[2].yaw",
    ] {
        assert!(names.contains(&name), "{name} is missing");
    }
    assert!(!names.contains(&"wheelset[7].position"));
}

/// One step of 2 ms does the same as two of 1 ms, and a restored state gives the same bits.
#[test]
fn property_steps_and_restored_states_give_the_same_bits() {
    let mut bench = Bench::new(resources("bits", LOCOMOTIVE)).unwrap();
    let mut vehicle = bench.start().unwrap();
    let begin = vehicle.state().into_owned();
    bench.step(&mut vehicle, 1e-3).unwrap();
    bench.step(&mut vehicle, 1e-3).unwrap();
    let twice = bench.reals();
    vehicle.restore(begin);
    bench.step(&mut vehicle, 2e-3).unwrap();
    assert_eq!(bench.reals(), twice);
}

/// A body that is held in height only, and weighs what the car body of [`lighter`] lacks.
const TOOL_BOX: &str = r#"
    [[multibody.body]]
    name = "tool box"
    mass_kg = 100.0
    inertia_kg_m2 = [1.0, 1.0, 1.0]
    x_m = 0.0
    height_m = 1.0
    [[multibody.spring]]
    name = "tool box"
    between = ["car body", "tool box"]
    points_m = [[0.0, 0.0, 1.0]]
    stiffness_n_m = [0.0, 0.0, 1e6]
    damping_n_s_m = [0.0, 0.0, 0.0]
"#;

fn lighter(locomotive: &str) -> String {
    let lighter = locomotive.replace("mass_kg = 88400.0", "mass_kg = 88300.0");
    assert_ne!(lighter, locomotive, "the car body has another mass now");
    lighter
}

#[test]
fn wrong_files_and_values_are_named() {
    let message = |result: Result<Vehicle, ModelError>| match result {
        Ok(_) => panic!("accepted"),
        Err(error) => error.to_string(),
    };
    let without = "extends = \"locomotive-coco-134t\"\nwithout = [\"multibody\"]";
    let error = Bench::new(resources("no-multibody", without)).err().unwrap();
    assert!(error.to_string().contains("has no section [multibody]"));

    let profile = "extends = \"locomotive-coco-134t\"\nmultibody.contact.wheel = \"S1003\"";
    let mut bench = Bench::new(resources("profile", profile)).unwrap();
    assert!(message(bench.start()).contains("there is no wheel profile \"S1003\""));

    let stock = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../stock/vehicles");
    let text = std::fs::read_to_string(stock.join("locomotive-coco-134t.toml")).unwrap();
    let mut bench = Bench::new(resources("loose", &(lighter(&text) + TOOL_BOX))).unwrap();
    let sentence = message(bench.start());
    for part in ["vehicle.toml", "[multibody]", "no spring holds body \"tool box\" in "] {
        assert!(sentence.contains(part), "{sentence}");
    }

    let folder = resources("no-track", LOCOMOTIVE);
    std::fs::remove_file(folder.join("track.toml")).unwrap();
    let mut bench = Bench::new(folder).unwrap();
    assert!(message(bench.start()).contains("track.toml"));
}
