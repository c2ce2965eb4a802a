//! Steps, and steps that fail.

use std::ffi::c_int;
use std::ptr;

use fmu::Status;

use crate::fmi2::*;
use crate::tool::Fmu;

/// By hand: semi-implicit Euler with m = 1 kg, k = 100 N/m, d = 2 N s/m, x = 0.1 m, at rest, one
/// substep of 0.01 s: a = -10 m/s², v = -0.1 m/s, x = 0.1 - 0.001 m.
#[test]
fn analytic_one_step_of_the_spring() {
    let fmu = Fmu::new();
    let substeps = fmu.reference("substeps");
    // SAFETY: the component lives, and there is one value.
    let status = unsafe { fmi2SetInteger(fmu.component, &substeps, 1, &1) };
    assert_eq!(status, Status::Ok);
    fmu.begin();
    assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
    assert_eq!(fmu.do_step(0.0, 0.01), Status::Ok);
    // Two roundings of numbers near 0.1.
    assert!((fmu.get("position") - 0.099).abs() < 1e-16);
    assert!((fmu.get("velocity") + 0.1).abs() < 1e-16);
}

/// The time up to which the last step succeeded.
fn last_successful_time(fmu: &Fmu) -> f64 {
    let mut time = f64::NAN;
    // SAFETY: the component lives, and there is room for the answer.
    let status = unsafe { fmi2GetRealStatus(fmu.component, 2, &mut time) };
    assert_eq!(status, Status::Ok);
    time
}

#[test]
fn a_step_must_have_a_length() {
    for length in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        let fmu = Fmu::running();
        fmu.messages();
        assert_eq!(fmu.do_step(0.0, length), Status::Error, "{length}");
        assert!(fmu.message().contains("must be greater than zero and finite"));
    }
}

#[test]
fn a_step_must_begin_where_the_last_one_ended() {
    for start in [0.0, 0.2, -0.1, f64::NAN] {
        let fmu = Fmu::running();
        assert_eq!(fmu.do_step(0.0, 0.1), Status::Ok);
        fmu.messages();
        assert_eq!(fmu.do_step(start, 0.1), Status::Error, "{start}");
        let expected = format!("the step begins at {start} s, but the FMU stands at 0.1 s");
        assert_eq!(fmu.message(), expected);
    }
}

/// fmi-standard issue 222: an FMU that sums up its time refuses a step after 256,040 steps.
#[test]
fn issue_times_of_a_master_do_not_drift_apart() {
    const STEP: f64 = 1e-3;
    let fmu = Fmu::running();
    let (mut summed, mut drift) = (0.0, 0.0_f64);
    for index in 0..300_000 {
        // Two ways in which masters form the time; they differ by up to 8.6e-10 s.
        let counted = f64::from(index) * STEP;
        let start = if index % 2 == 0 { counted } else { summed };
        assert_eq!(fmu.do_step(start, STEP), Status::Ok, "{index} {:?}", fmu.messages());
        drift = drift.max((summed - counted).abs());
        summed += STEP;
        // The FMU stands where the master led it, to the bit.
        assert_eq!(last_successful_time(&fmu).to_bits(), (start + STEP).to_bits(), "{index}");
    }
    assert!(drift > 8e-10, "without a drift the test means nothing: {drift}");
}

#[test]
fn no_step_passes_the_stop_time() {
    let fmu = Fmu::new();
    assert_eq!(fmu.setup_experiment(0.0, Some(0.3)), Status::Ok);
    assert_eq!(fmu.enter_initialization_mode(), Status::Ok);
    assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
    // The third step ends at 0.1 + 0.1 + 0.1 = 0.30000000000000004.
    for start in [0.0, 0.1, 0.2] {
        assert_eq!(fmu.do_step(start, 0.1), Status::Ok);
    }
    fmu.messages();
    assert_eq!(fmu.do_step(0.3, 0.1), Status::Error);
    assert!(fmu.message().ends_with("after the stop time 0.3 s"));
}

#[test]
fn a_simulation_may_begin_at_any_time() {
    let fmu = Fmu::new();
    assert_eq!(fmu.setup_experiment(-5.0, None), Status::Ok);
    assert_eq!(fmu.enter_initialization_mode(), Status::Ok);
    assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
    assert_eq!(fmu.do_step(-5.0, 0.1), Status::Ok);
}

#[test]
fn a_step_that_fails_ends_in_an_error_that_says_why() {
    for (trouble, sentence) in [
        ("error", "the step from 0 s over 0.1 s failed: the spring is too hot"),
        ("nan", "the output `velocity` became NaN at 0.1 s"),
        ("panic", "fmi2DoStep met a programming error: the spring snapped"),
    ] {
        let fmu = Fmu::troubled(trouble);
        fmu.messages();
        assert_eq!(fmu.do_step(0.0, 0.1), Status::Error, "{trouble}");
        assert_eq!(fmu.message(), sentence);
        assert_eq!(fmu.do_step(0.0, 0.1), Status::Error, "the instance has failed");
    }
}

#[test]
fn a_step_back_leads_out_of_a_failed_step_even_after_a_panic() {
    for trouble in ["error", "nan", "panic"] {
        let fmu = Fmu::new();
        assert_eq!(fmu.set_string("trouble", trouble), Status::Ok);
        assert_eq!(fmu.set("trouble.time", 0.15), Status::Ok);
        fmu.begin();
        assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
        assert_eq!(fmu.do_step(0.0, 0.1), Status::Ok);
        let mut state = fmu.save();
        assert_eq!(fmu.do_step(0.1, 0.1), Status::Ok);
        let position = fmu.get("position");
        assert_eq!(fmu.do_step(0.2, 0.1), Status::Error);
        assert_eq!(fmu.restore(state), Status::Ok);
        assert_eq!(fmu.do_step(0.1, 0.1), Status::Ok);
        assert_eq!(fmu.get("position").to_bits(), position.to_bits());
        assert_eq!(fmu.free_state(&mut state), Status::Ok);
    }
}

#[test]
fn a_warning_is_returned_and_told() {
    let fmu = Fmu::troubled("warning");
    fmu.messages();
    assert_eq!(fmu.do_step(0.0, 0.1), Status::Warning);
    assert_eq!(fmu.message(), "the spring creaks");
    assert_eq!(fmu.do_step(0.1, 0.1), Status::Warning);
    assert_eq!(fmu.get("velocity").signum(), -1.0);
}

#[test]
fn a_step_that_is_too_long_is_discarded() {
    let fmu = Fmu::running();
    assert_eq!(fmu.do_step(0.0, 0.5), Status::Ok);
    let mut state = fmu.save();
    fmu.messages();
    assert_eq!(fmu.do_step(0.5, 2.0), Status::Discard);
    assert!(fmu.message().ends_with("at most 1 s can be done in one step"));

    let mut terminated: c_int = 7;
    // SAFETY: the component lives, and there is room for the answer.
    let status = unsafe { fmi2GetBooleanStatus(fmu.component, 3, &mut terminated) };
    assert_eq!((status, terminated), (Status::Ok, 0));
    assert_eq!(last_successful_time(&fmu), 0.5);

    assert_eq!(fmu.restore(state), Status::Ok);
    assert_eq!(fmu.do_step(0.5, 1.0), Status::Ok);
    assert_eq!(fmu.free_state(&mut state), Status::Ok);
}

#[test]
fn a_status_that_does_not_exist_is_discarded_without_harm() {
    let fmu = Fmu::running();
    let (mut integer, mut real, mut text) = (0, 0.0, ptr::null());
    let c = fmu.component;
    // SAFETY: the component lives, and there is room for the answers.
    unsafe {
        for kind in [0, 1, 9] {
            assert_eq!(fmi2GetStatus(c, kind, &mut integer), Status::Discard);
            assert_eq!(fmi2GetRealStatus(c, kind, &mut real), Status::Discard);
            assert_eq!(fmi2GetIntegerStatus(c, kind, &mut integer), Status::Discard);
            assert_eq!(fmi2GetBooleanStatus(c, kind, &mut integer), Status::Discard);
            assert_eq!(fmi2GetStringStatus(c, kind, &mut text), Status::Discard);
        }
    }
    assert_eq!(fmu.do_step(0.0, 0.1), Status::Ok);
}

#[test]
fn no_step_can_be_cancelled() {
    let fmu = Fmu::running();
    fmu.messages();
    // SAFETY: the component lives.
    assert_eq!(unsafe { fmi2CancelStep(fmu.component) }, Status::Error);
    assert!(fmu.message().contains("fmi2CancelStep is not allowed in the state \"step complete\""));
}
