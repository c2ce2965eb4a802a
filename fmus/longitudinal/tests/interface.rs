//! The train through its FMI interface.

use std::path::Path;

use fmu::{Error, Instance};
use longitudinal::Train;

/// Folder of the shipped rolling stock.
const STOCK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../stock");

const CONSIST: &str = "vehicle = [{ type = 'locomotive-coco-134t', count = 2 },
                                  { type = 'wagon-coco-134t-unpowered', count = 3 }]";
const DRIVER: &str = "command = [{ from_s = 0, notch = 8 }, { from_s = 0.5, train_brake = 0.5 }]";
const STEP: f64 = 1e-3;

/// A resources folder as the packer writes it.
fn resources(consist: &str, driver: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("consist.toml", consist);
    write("driver.toml", driver);
    write("track.toml", "alignment = [{ length_m = 10 }, { length_m = 600, radius_m = 800 }]");
    for part in ["vehicles", "draft_gears"] {
        let to = folder.path().join("stock").join(part);
        std::fs::create_dir_all(&to).unwrap();
        for file in std::fs::read_dir(Path::new(STOCK).join(part)).unwrap() {
            let file = file.unwrap();
            std::fs::copy(file.path(), to.join(file.file_name())).unwrap();
        }
    }
    folder
}

/// An instance as a simulation tool has it.
struct Fmu(Instance<Train>);

impl Fmu {
    /// Starts at 15 m/s with the given Real start values besides.
    fn start(resources: &Path, values: &[(&str, f64)]) -> Result<Self, Error> {
        let mut fmu = Self(Instance::new(resources, "train", Box::new(|_, _| ()))?);
        fmu.set("initial.velocity", 15.0)?;
        for (name, value) in values {
            fmu.set(name, *value)?;
        }
        fmu.0.setup_experiment(0.0, None)?;
        fmu.0.enter_initialization_mode()?;
        fmu.0.exit_initialization_mode()?;
        Ok(fmu)
    }

    fn reference(&self, name: &str) -> u32 {
        let mut variables = self.0.declaration().variables().iter();
        let found = variables.find(|variable| variable.name == name);
        found.unwrap_or_else(|| panic!("there is no variable {name}")).reference
    }

    fn set(&mut self, name: &str, value: f64) -> Result<(), Error> {
        let reference = self.reference(name);
        self.0.set_real(&[reference], [value])
    }

    fn get(&mut self, name: &str) -> f64 {
        let reference = self.reference(name);
        self.0.get_real(&[reference]).unwrap().next().unwrap()
    }

    fn run(&mut self, steps: std::ops::Range<u32>) -> Result<(), Error> {
        steps.into_iter().try_for_each(|k| self.0.do_step(f64::from(k) * STEP, STEP))
    }
}

#[test]
fn property_adjoining_couplers_have_equal_forces() {
    let folder = resources(CONSIST, DRIVER);
    let mut fmu = Fmu::start(folder.path(), &[]).unwrap();
    fmu.run(0..2000).unwrap();
    for i in 1..5 {
        let rear = fmu.get(&format!("vehicle[{i}].coupler.rear.force"));
        let front = fmu.get(&format!("vehicle[{}].coupler.front.force", i + 1));
        assert_eq!(rear, front);
        assert_ne!(rear, 0.0);
    }
    assert_eq!(fmu.get("vehicle[1].coupler.front.force"), 0.0);
    assert_eq!(fmu.get("vehicle[5].coupler.rear.force"), 0.0);
}

/// The forces of a vehicle add up to its mass times its acceleration.
#[test]
fn analytic_outputs_obey_newton() {
    let folder = resources(CONSIST, DRIVER);
    let mut fmu = Fmu::start(folder.path(), &[]).unwrap();
    fmu.run(0..1500).unwrap();
    for i in 1..=5 {
        let mut get = |name: &str| fmu.get(&format!("vehicle[{i}].{name}"));
        let resistance = get("resistance.force") + get("curve_resistance.force");
        let couplers = get("coupler.front.force") - get("coupler.rear.force");
        let force = couplers + get("traction.force") + resistance - get("brake.force");
        // 1e-6 N: rounding of forces of 1e5 N.
        assert!((force - 134e3 * get("acceleration")).abs() < 1e-6);
        assert!(resistance < 0.0 && get("brake.force") > 0.0);
    }
}

#[test]
fn analytic_first_vehicle_starts_at_the_initial_position() {
    let folder = resources(CONSIST, DRIVER);
    let mut fmu = Fmu::start(folder.path(), &[("initial.position", 500.0)]).unwrap();
    assert_eq!(fmu.get("vehicle[1].position"), 500.0);
    // Behind it by a length of 20 m and what the couplers are stretched.
    let gap = 500.0 - fmu.get("vehicle[2].position") - 20.0;
    assert!((0.0099..0.2).contains(&gap), "{gap}");
    assert_eq!(fmu.get("train.mass"), 5.0 * 134e3);
    assert_eq!(fmu.get("train.length"), 100.0);
}

#[test]
fn the_driver_file_is_followed_until_an_input_overrides_it() {
    let folder = resources(CONSIST, DRIVER);
    let mut fmu = Fmu::start(folder.path(), &[]).unwrap();
    fmu.run(0..400).unwrap();
    assert_eq!(fmu.get("driver.in_force.notch"), 8.0);
    fmu.set("driver.notch", 0.0).unwrap();
    fmu.set("driver.dynamic_brake", 1.0).unwrap();
    fmu.run(400..600).unwrap();
    assert_eq!(fmu.get("driver.in_force.notch"), 0.0);
    assert_eq!(fmu.get("driver.in_force.dynamic_brake"), 1.0);
    assert_eq!(fmu.get("driver.in_force.train_brake"), 0.5);
    fmu.set("driver.dynamic_brake", -1.0).unwrap();
    fmu.run(600..601).unwrap();
    assert_eq!(fmu.get("driver.in_force.dynamic_brake"), 0.0);
}

#[test]
fn a_driver_input_between_schedule_and_zero_is_refused() {
    let folder = resources(CONSIST, DRIVER);
    let mut fmu = Fmu::start(folder.path(), &[]).unwrap();
    fmu.set("driver.notch", -0.5).unwrap();
    let message = fmu.run(0..1).unwrap_err().to_string();
    assert!(message.contains("driver.notch = -0.5: must lie between 0 and 8"), "{message}");
}

/// A restored state continues with the same bits as the run that it was taken from.
#[test]
fn property_restored_state_goes_on_bit_identically() {
    let folder = resources(CONSIST, DRIVER);
    let mut fmu = Fmu::start(folder.path(), &[]).unwrap();
    fmu.run(0..450).unwrap();
    let bytes = fmu.0.save().unwrap().to_bytes();
    let outputs = |fmu: &mut Fmu| -> Vec<u64> {
        let reals = fmu.0.declaration().variables().iter();
        let reals = reals.filter(|variable| matches!(variable.kind, fmu::Kind::Real { .. }));
        let references: Vec<u32> = reals.map(|variable| variable.reference).collect();
        fmu.0.get_real(&references).unwrap().map(f64::to_bits).collect()
    };
    fmu.run(450..2000).unwrap();
    let expected = outputs(&mut fmu);

    let mut other = Fmu::start(folder.path(), &[("initial.position", 3.0)]).unwrap();
    let saved = other.0.deserialize_state(&bytes).unwrap();
    other.0.restore(&saved).unwrap();
    other.run(450..2000).unwrap();
    assert_eq!(outputs(&mut other), expected);
}

#[test]
fn unknown_vehicle_type_is_refused_by_file() {
    let folder = resources("vehicle = [{ type = 'locomotiv' }]", DRIVER);
    let error = Fmu::start(folder.path(), &[]).err().unwrap();
    assert!(error.to_string().contains("locomotiv.toml"), "{error}");
}

#[test]
fn a_consist_of_another_size_is_refused() {
    let folder = resources(CONSIST, DRIVER);
    let other = resources("vehicle = [{ type = 'locomotive-coco-134t' }]", DRIVER);
    let mut fmu = Fmu(Instance::new(folder.path(), "train", Box::new(|_, _| ())).unwrap());
    let reference = fmu.reference("consist_file");
    let file = other.path().join("consist.toml").display().to_string();
    fmu.0.set_string(&[reference], [file.as_str()]).unwrap();
    fmu.0.setup_experiment(0.0, None).unwrap();
    fmu.0.enter_initialization_mode().unwrap();
    let error = fmu.0.exit_initialization_mode().unwrap_err().to_string();
    assert!(error.contains("has 1 vehicles, but this FMU was packed for 5"), "{error}");
}

#[test]
fn a_consist_file_that_is_missing_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let error = Instance::<Train>::new(folder.path(), "train", Box::new(|_, _| ())).err().unwrap();
    assert!(error.to_string().contains("consist.toml"), "{error}");
}

/// Heat of the wheels, heat of the gears and the wind come through the interface.
#[test]
fn analytic_heat_and_wind_pass_through_the_interface() {
    let folder = resources(CONSIST, DRIVER);
    let mut fmu = Fmu::start(folder.path(), &[]).unwrap();
    fmu.run(0..1500).unwrap();
    for i in 1..=5 {
        let power = fmu.get(&format!("vehicle[{i}].brake.force"))
            * fmu.get(&format!("vehicle[{i}].velocity"));
        let wheel = fmu.get(&format!("vehicle[{i}].wheel.brake_power"));
        // Twelve wheels; rounding of 1e5 W.
        assert!(wheel > 0.0 && (12.0 * wheel - power).abs() < 1e-6);
    }
    let gears: f64 = (1..=5)
        .flat_map(|i| ["front", "rear"].map(|end| format!("vehicle[{i}].draft_gear.{end}.energy")))
        .map(|name| fmu.get(&name))
        .sum();
    assert!((gears - fmu.get("energy.draft_gears")).abs() < 1e-6 * gears.abs() + 1e-6);
    let still = fmu.get("train.resistance.force");
    fmu.set("wind.speed", 20.0).unwrap();
    fmu.run(1500..1501).unwrap();
    let windy = fmu.get("train.resistance.force");
    assert!(windy < 1.2 * still, "a head wind of 20 m/s: {still} N, {windy} N");
}

#[test]
fn a_gear_blended_too_fast_for_the_step_is_refused() {
    let folder = resources(CONSIST, DRIVER);
    let file = folder.path().join("stock/draft_gears/friction-gear-m901e.toml");
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, format!("transition_speed_mm_s = 1.0\n{text}")).unwrap();
    let message = Fmu::start(folder.path(), &[]).err().unwrap().to_string();
    assert!(message.contains("longer than the longest stable one"), "{message}");
}
