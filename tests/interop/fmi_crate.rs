//! The crate `fmi` as an independent importer: it loads, initialises and steps Hotfoot's FMUs.
//!
//! Needs libclang (`apt install libclang-dev`) and the FMUs (`cargo xtask fmus`).

use std::path::Path;

use fmi::fmi2::import::Fmi2Import;
use fmi::fmi2::instance::{CoSimulation, Common};
use fmi::traits::FmiImport;

const STEP: f64 = 1e-3;
const STEPS: u32 = 100;

/// Runs an FMU for 0.1 s with these start values and inputs, and gives an output at the end.
fn run(model: &str, start: &[(&str, f64)], inputs: &[(&str, f64)], output: &str) -> f64 {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let file = root.join(format!("target/fmus/{model}.fmu"));
    let import: Fmi2Import = fmi::import::from_path(file).expect("run `cargo xtask fmus` first");
    let reference = |name: &str| {
        let variables = &import.model_description().model_variables.variables;
        let variable = variables.iter().find(|variable| variable.name == name);
        variable.unwrap_or_else(|| panic!("no variable {name}")).value_reference
    };
    let split = |pairs: &[(&str, f64)]| -> (Vec<u32>, Vec<f64>) {
        pairs.iter().map(|&(name, value)| (reference(name), value)).unzip()
    };
    let mut instance = import.instantiate_cs(model, false, true).unwrap();
    let (references, values) = split(start);
    instance.set_real(&references, &values).unwrap();
    instance.setup_experiment(None, 0.0, None).unwrap();
    instance.enter_initialization_mode().unwrap();
    let (references, values) = split(inputs);
    instance.set_real(&references, &values).unwrap();
    instance.exit_initialization_mode().unwrap();
    for k in 0..STEPS {
        instance.do_step(f64::from(k) * STEP, STEP, true).unwrap();
    }
    let mut value = [f64::NAN];
    instance.get_real(&[reference(output)], &mut value).unwrap();
    instance.terminate().unwrap();
    value[0]
}

#[test]
fn the_vehicle_rolls() {
    let start = [("initial.position", 100.0), ("initial.velocity", 16.67)];
    let position = run("vehicle", &start, &[("coupler.front.force", 10e3)], "position");
    assert!((position - 101.667).abs() < 0.01, "{position}");
}

#[test]
fn the_train_pulls() {
    let start = [("initial.velocity", 10.0)];
    let notch = [("driver.notch", 8.0)];
    assert!(run("longitudinal", &start, &notch, "vehicle[1].traction.force") > 10e3);
}

#[test]
fn the_rail_is_heated() {
    let inputs = [
        ("vehicle[1].wheelset[1].position", 50.0),
        ("vehicle[1].wheelset[1].speed", 16.67),
        ("vehicle[1].wheelset[1].creepage.longitudinal", 0.005),
        ("vehicle[1].wheelset[1].force.normal", 109.5e3),
        ("vehicle[1].wheelset[1].contact.a", 7e-3),
        ("vehicle[1].wheelset[1].contact.b", 6e-3),
    ];
    assert!(run("railheat", &[], &inputs, "highest.surface.rise") > 0.0);
}
