//! Steps of the locomotive in a curve of 800 m as its FMU makes them, for `cargo xtask instructions`:
//! inputs set, 1 ms, outputs read. The argument is the number of steps.

use std::path::Path;

use fmu::Instance;
use vehicle::Vehicle;

fn main() {
    let steps: u32 =
        std::env::args().nth(1).and_then(|text| text.parse().ok()).expect("a number of steps");
    let folder = resources();
    let mut instance =
        Instance::<Vehicle>::new(folder.path(), "vehicle", Box::new(|_, _| {})).expect("a vehicle");
    let variables = instance.declaration().variables();
    let reference = |name: &str| {
        let variable = variables.iter().find(|variable| variable.name == name);
        variable.expect(name).reference
    };
    let starts = ["initial.position", "initial.velocity"].map(reference);
    let inputs = ["traction.force", "coupler.rear.force"].map(reference);
    let outputs: Vec<u32> = (1..=6)
        .flat_map(|i| ["left", "right"].map(|side| format!("wheelset[{i}].{side}.friction_power")))
        .map(|name| reference(&name))
        .collect();
    instance.set_real(&starts, [1000.0, 16.67]).expect("a start");
    instance.setup_experiment(0.0, None).expect("an experiment");
    instance.enter_initialization_mode().expect("start values");
    instance.exit_initialization_mode().expect("an equilibrium");
    for step in 0..steps {
        instance.set_real(&inputs, [100e3; 2]).expect("inputs");
        instance.do_step(f64::from(step) * 1e-3, 1e-3).expect("a step");
        let power: f64 = instance.get_real(&outputs).expect("outputs").sum();
        assert!(power > 0.0, "no wheel creeps");
    }
}

/// Resources of an FMU: the locomotive, the vehicles of the stock library, the curve.
fn resources() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let place = |name: &str| folder.path().join(name);
    let write = |name: &str, text: &str| std::fs::write(place(name), text).expect("is writable");
    write("track.toml", "alignment = [{ length_m = 1e6, radius_m = 800.0 }]");
    write("vehicle.toml", "extends = \"locomotive-coco-134t\"");
    let vehicles = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../stock/vehicles");
    std::fs::create_dir_all(place("stock/vehicles")).expect("is writable");
    for entry in std::fs::read_dir(vehicles).expect("the stock library") {
        let entry = entry.expect("a vehicle");
        let copy = place("stock/vehicles").join(entry.file_name());
        std::fs::copy(entry.path(), copy).expect("is writable");
    }
    folder
}
