//! A model called directly gives the same bits as its FMU.

use fmu::{Instance, Model};
use hotfoot::{FmuInstance, Import, Unit};
use hotfoot_tests::{PAGE, fmu, resources};
use validation::Finding;

const STEP: f64 = 1e-3;
const STEPS: u32 = 200;

/// Runs a model both ways, with these inputs, and compares all Real outputs after each step; `name` is
/// that of the validation page.
fn compare<M: Model>(name: &str, model: &str, inputs: &[(&str, f64)]) {
    let import = Import::open(&fmu(model)).unwrap();
    let interface = import.interface();
    let reference = |name: &str| interface.variable(name).unwrap().reference;
    let outputs: Vec<u32> = interface.real_outputs("none").iter().map(|v| v.reference).collect();
    let references: Vec<u32> = inputs.iter().map(|(name, _)| reference(name)).collect();
    let values: Vec<f64> = inputs.iter().map(|(_, value)| *value).collect();
    let speed = interface.variable("initial.velocity").map(|variable| variable.reference);

    let mut through_fmi: Box<dyn Unit> = Box::new(FmuInstance::new(&import, model).unwrap());
    let folder = resources(model);
    let mut native = Instance::<M>::new(folder.path(), model, Box::new(|_, _| {})).unwrap();
    if let Some(speed) = speed {
        through_fmi.set_reals(&[speed], &[16.67]).unwrap();
        native.set_real(&[speed], [16.67]).unwrap();
    }
    through_fmi.enter_initialization(0.0, 1.0).unwrap();
    through_fmi.set_reals(&references, &values).unwrap();
    through_fmi.exit_initialization().unwrap();
    native.setup_experiment(0.0, Some(1.0)).unwrap();
    native.enter_initialization_mode().unwrap();
    native.set_real(&references, values.clone()).unwrap();
    native.exit_initialization_mode().unwrap();

    let mut from_fmi = vec![0.0; outputs.len()];
    for k in 0..STEPS {
        let time = f64::from(k) * STEP;
        through_fmi.step(time, STEP).unwrap();
        native.do_step(time, STEP).unwrap();
        through_fmi.get_reals(&outputs, &mut from_fmi).unwrap();
        let directly: Vec<f64> = native.get_real(&outputs).unwrap().collect();
        let bits = |values: &[f64]| values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&from_fmi), bits(&directly), "{model} at step {k}");
    }
    let case = format!("{name} called directly, all outputs");
    Finding { case: &case, expected: "the same bits", source: "its FMU" }.stands_in(&PAGE);
}

#[test]
fn property_the_vehicle_is_the_same_as_its_fmu() {
    compare::<vehicle::Vehicle>(
        "vehicle",
        "vehicle",
        &[("coupler.front.force", 100e3), ("coupler.rear.force", 150e3), ("traction.force", 50e3)],
    );
}

#[test]
fn property_the_train_is_the_same_as_its_fmu() {
    compare::<longitudinal::Train>("train", "longitudinal", &[("driver.notch", 6.0)]);
}

#[test]
fn property_the_rail_is_the_same_as_its_fmu() {
    compare::<railheat::RailHeat>(
        "rail",
        "railheat",
        &[
            ("vehicle[1].wheelset[1].position", 50.0),
            ("vehicle[1].wheelset[1].speed", 16.67),
            ("vehicle[1].wheelset[1].creepage.longitudinal", 0.005),
            ("vehicle[1].wheelset[1].force.normal", 109.5e3),
            ("vehicle[1].wheelset[1].contact.a", 7e-3),
            ("vehicle[1].wheelset[1].contact.b", 6e-3),
        ],
    );
}
