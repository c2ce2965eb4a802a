//! Many instances in one process, and the same results without the C interface.

use std::thread;

use fmu::{Instance, Phase, Status};

use crate::spring::Spring;
use crate::tool::{Fmu, native};

const STEP: f64 = 0.01;
const STEPS: u32 = 500;

/// The force on a spring at a step, N.
fn force(spring: u32, step: u32) -> f64 {
    f64::from(spring) * f64::from(step).cos()
}

/// Steps through the C functions.
fn run_fmu(fmu: &Fmu, spring: u32) -> Vec<u64> {
    let step = |index: u32| {
        assert_eq!(fmu.set("force", force(spring, index)), Status::Ok);
        assert_eq!(fmu.do_step(f64::from(index) * STEP, STEP), Status::Ok);
        fmu.get("position").to_bits()
    };
    (0..STEPS).map(step).collect()
}

/// Steps without them.
fn run_native(mut instance: Instance<Spring>, spring: u32) -> Result<Vec<u64>, fmu::Error> {
    instance.setup_experiment(0.0, None)?;
    instance.enter_initialization_mode()?;
    instance.exit_initialization_mode()?;
    let input = instance.signals().drive.force.reference();
    let output = instance.signals().state.position.reference();
    let mut bits = Vec::new();
    for index in 0..STEPS {
        instance.set_real(&[input], [force(spring, index)])?;
        instance.do_step(f64::from(index) * STEP, STEP)?;
        bits.extend(instance.get_real(&[output])?.map(f64::to_bits));
    }
    Ok(bits)
}

#[test]
fn an_fmu_gives_the_bits_of_the_native_instance() {
    let native = run_native(native(), 3).expect("no call is wrong");
    assert_eq!(run_fmu(&Fmu::running(), 3), native);
}

#[test]
fn instances_on_many_threads_do_not_touch_each_other() {
    let alone: Vec<_> = (0..8).map(|spring| run_fmu(&Fmu::running(), spring)).collect();
    let fmus: Vec<_> = (0..8).map(|_| Fmu::running()).collect();
    let together = thread::scope(|scope| {
        let runs = (0..8).zip(fmus);
        let threads: Vec<_> =
            runs.map(|(spring, fmu)| scope.spawn(move || run_fmu(&fmu, spring))).collect();
        let join = |thread: thread::ScopedJoinHandle<_>| thread.join().expect("it ran through");
        threads.into_iter().map(join).collect::<Vec<_>>()
    });
    assert_eq!(together, alone);
}

/// FMPy issues 110 and 140: FMUs of other makers crash at about 1,020 instances.
#[test]
fn issue_more_than_a_thousand_instances_live_side_by_side() {
    let expected = run_fmu(&Fmu::running(), 0);
    let fmus: Vec<_> = (0..1100).map(|_| Fmu::running()).collect();
    for fmu in [&fmus[0], &fmus[1023], &fmus[1099]] {
        assert_eq!(run_fmu(fmu, 0), expected);
    }
}

/// Made on one thread, initialised and stepped on a second, stepped on by a third, freed on a
/// fourth; OMSimulator issue 858 is about FMUs that cannot do this.
#[test]
fn issue_an_instance_is_made_stepped_and_freed_on_different_threads() {
    let expected = run_fmu(&Fmu::running(), 2);
    let on_a_thread = |work: Box<dyn FnOnce() -> (Fmu, Vec<u64>) + Send>| {
        thread::spawn(work).join().expect("it ran through")
    };
    let (fmu, _) = on_a_thread(Box::new(|| (Fmu::new(), vec![])));
    let (fmu, _) = on_a_thread(Box::new(move || {
        fmu.begin();
        assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
        (fmu, vec![])
    }));
    let (fmu, bits) = on_a_thread(Box::new(move || {
        let bits = run_fmu(&fmu, 2);
        (fmu, bits)
    }));
    assert_eq!(bits, expected);
    thread::spawn(move || drop(fmu)).join().expect("it was freed");
}

#[test]
fn an_instance_and_its_states_may_move_to_another_thread() {
    let mut instance = native();
    let state = instance.save().expect("it is allowed");
    let moved = thread::spawn(move || {
        let restored = instance.restore(&state);
        (restored, instance.phase())
    });
    assert_eq!(moved.join().expect("it ran through"), (Ok(()), Phase::Instantiated));
}

#[test]
fn a_native_call_with_too_few_values_is_refused() {
    let mut instance = native();
    let error = instance.set_real(&[0, 1], [1.0]).unwrap_err();
    assert_eq!(error.to_string(), "2 value references came with 1 values");
}
