//! The controller behind its FMU interface.

use std::path::Path;

use fmu::Instance;
use synchronisation::Synchronisation;

const STEP: f64 = 1e-3;

/// An instance before its initialisation.
fn instance() -> Instance<Synchronisation> {
    Instance::new(Path::new(""), "controller", Box::new(|_, _| {})).unwrap()
}

/// Initialises with the given errors of position and velocity.
fn initialize(instance: &mut Instance<Synchronisation>, errors: (f64, f64)) {
    instance.setup_experiment(0.0, None).unwrap();
    instance.enter_initialization_mode().unwrap();
    set_errors(instance, errors);
    instance.exit_initialization_mode().unwrap();
}

fn set_errors(instance: &mut Instance<Synchronisation>, (position, velocity): (f64, f64)) {
    let vehicle = instance.signals().vehicle;
    let references = [vehicle.position.reference(), vehicle.velocity.reference()];
    instance.set_real(&references, [position, velocity]).unwrap();
}

fn force(instance: &Instance<Synchronisation>) -> f64 {
    instance.values()[instance.signals().force.force]
}

/// Bosomworth et al. 2018, eq. 7 with the paper's 2 kN/m and 10 kN/(m/s), the defaults; the
/// force of a step is that of the errors at its beginning.
#[test]
fn benchmark_the_force_follows_the_errors_one_step_later() {
    let mut controller = instance();
    initialize(&mut controller, (0.5, 0.0));
    assert_eq!(force(&controller), -1000.0, "already when initialised");
    set_errors(&mut controller, (0.0, 0.1));
    assert_eq!(force(&controller), -1000.0, "as long as no step was done");
    controller.do_step(0.0, STEP).unwrap();
    assert_eq!(force(&controller), -1000.0, "10 kN/(m/s) times 0.1 m/s");
    set_errors(&mut controller, (-1.0, 0.0));
    controller.do_step(STEP, STEP).unwrap();
    assert_eq!(force(&controller), 2000.0);
}

#[test]
fn property_a_restored_controller_goes_on_with_the_same_bits() {
    let mut controller = instance();
    let integral = controller.signals().gains.integral.reference();
    controller.set_real(&[integral], [700.0]).unwrap();
    initialize(&mut controller, (0.3, 0.0));
    controller.do_step(0.0, STEP).unwrap();
    let saved = controller.save().unwrap();
    controller.do_step(STEP, STEP).unwrap();
    let expected = force(&controller);
    controller.restore(&saved).unwrap();
    controller.do_step(STEP, STEP).unwrap();
    assert_eq!(force(&controller).to_bits(), expected.to_bits());
}

#[test]
fn errors_beyond_all_numbers_are_refused_with_a_sentence() {
    let mut controller = instance();
    let limit = controller.signals().gains.limit.reference();
    controller.set_real(&[limit], [f64::MAX]).unwrap();
    initialize(&mut controller, (0.0, 0.0));
    set_errors(&mut controller, (1e308, -1e308));
    let error = controller.do_step(0.0, STEP).unwrap_err().to_string();
    assert!(error.contains("too far apart"), "{error}");
}
