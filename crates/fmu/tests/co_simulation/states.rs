//! Saving, restoring and serializing states.

use std::ffi::c_void;
use std::ptr;

use fmu::Status;
use proptest::prelude::*;

use crate::fmi2::*;
use crate::tool::{Fmu, Order, native_in};

const STEP: f64 = 0.01;

/// Steps on `count` times from step number `first`, with a force that varies, and gives the bits
/// of what is seen.
fn run(fmu: &Fmu, first: u32, count: u32) -> Vec<(u64, u64)> {
    let step = |index: u32| {
        let force = 10.0 * f64::from(index).sin();
        assert_eq!(fmu.set("force", force), Status::Ok);
        let status = fmu.do_step(f64::from(index) * STEP, STEP);
        assert_eq!(status, Status::Ok, "{:?}", fmu.messages());
        (fmu.get("position").to_bits(), fmu.get("velocity").to_bits())
    };
    (first..first + count).map(step).collect()
}

#[test]
fn stepping_on_from_a_restored_state_gives_the_same_bits() {
    let fmu = Fmu::running();
    run(&fmu, 0, 10);
    let mut state = fmu.save();
    let expected = run(&fmu, 10, 20);
    assert_eq!(fmu.restore(state), Status::Ok);
    assert_eq!(run(&fmu, 10, 20), expected);
    assert_eq!(fmu.free_state(&mut state), Status::Ok);
}

/// The state of a run that was initialised with another mass and another preload goes into an
/// instance that was just made, which must be built anew for it, and into one that runs.
#[test]
fn a_serialized_state_goes_into_any_instance_in_any_phase() {
    let origin = Fmu::initializing();
    assert_eq!(origin.set("mass", 7.0), Status::Ok);
    assert_eq!(origin.set("force", 3.0), Status::Ok);
    assert_eq!(origin.exit_initialization_mode(), Status::Ok);
    run(&origin, 0, 10);
    assert_eq!(origin.set("stiffness", 50.0), Status::Ok);
    let mut state = origin.save();
    let bytes = origin.serialize(state);
    let expected = run(&origin, 10, 20);
    assert_eq!(origin.free_state(&mut state), Status::Ok);

    for other in [Fmu::new(), Fmu::initializing(), Fmu::running(), Fmu::troubled("")] {
        let (status, mut copy) = other.deserialize(&bytes);
        assert_eq!(status, Status::Ok);
        assert_eq!(other.restore(copy), Status::Ok);
        assert_eq!((other.get("mass"), other.get("stiffness")), (7.0, 50.0));
        assert_eq!(run(&other, 10, 20), expected);
        assert_eq!(other.free_state(&mut copy), Status::Ok);
    }
}

#[test]
fn a_state_knows_its_phase() {
    let fmu = Fmu::new();
    let mut state = fmu.save();
    fmu.begin();
    assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
    assert_eq!(fmu.restore(state), Status::Ok);
    fmu.begin();
    assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
    assert_eq!(fmu.free_state(&mut state), Status::Ok);
}

#[test]
fn a_state_that_is_there_is_overwritten() {
    let fmu = Fmu::running();
    let mut state = fmu.save();
    let before = state;
    run(&fmu, 0, 5);
    assert_eq!(fmu.save_into(&mut state), Status::Ok);
    assert_eq!(state, before);
    let expected = run(&fmu, 5, 5);
    assert_eq!(fmu.restore(state), Status::Ok);
    assert_eq!(run(&fmu, 5, 5), expected);
    assert_eq!(fmu.free_state(&mut state), Status::Ok);
}

#[test]
fn freeing_a_state_sets_the_pointer_to_null_and_nothing_is_ignored() {
    let fmu = Fmu::running();
    let mut state = fmu.save();
    assert_eq!(fmu.free_state(&mut state), Status::Ok);
    assert!(state.is_null());
    assert_eq!(fmu.free_state(&mut state), Status::Ok);
    // SAFETY: null is allowed.
    let status = unsafe { fmi2FreeFMUstate(fmu.component, ptr::null_mut()) };
    assert_eq!(status, Status::Ok);
}

#[test]
fn no_state_cannot_be_restored() {
    let fmu = Fmu::running();
    fmu.messages();
    assert_eq!(fmu.restore(ptr::null_mut()), Status::Error);
    assert_eq!(fmu.message(), "the argument `FMUstate` is a null pointer");
}

#[test]
fn a_small_buffer_is_refused_with_the_size_needed() {
    let fmu = Fmu::running();
    let mut state = fmu.save();
    let size = fmu.serialize(state).len();
    let mut bytes = vec![0; size - 1];
    fmu.messages();
    // SAFETY: the component and the state live, and there is room for the bytes.
    let status =
        unsafe { fmi2SerializeFMUstate(fmu.component, state, bytes.as_mut_ptr(), bytes.len()) };
    assert_eq!(status, Status::Error);
    assert!(fmu.message().contains(&format!("needs {size} bytes")));
    assert_eq!(fmu.free_state(&mut state), Status::Ok);
}

#[test]
fn a_state_of_another_interface_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("points.txt"), "3").expect("a file");
    let other = Fmu::order(Order {
        guid: Some(native_in(folder.path()).guid().to_string()),
        location: Some(format!("file://{}", folder.path().display())),
        ..Order::default()
    });
    let other = other.unwrap_or_else(|messages| panic!("{messages:?}"));
    let fmu = Fmu::running();
    let mut state = other.save();
    let bytes = other.serialize(state);
    fmu.messages();
    let (status, copy) = fmu.deserialize(&bytes);
    assert_eq!((status, copy), (Status::Error, ptr::null_mut()));
    assert!(fmu.message().contains("another interface or version (spring "));
    assert_eq!(fmu.restore(state), Status::Error);
    assert!(fmu.message().contains("another interface"));
    assert_eq!(other.free_state(&mut state), Status::Ok);
}

/// Another program unpacks the FMU into another folder: texts that name files in it follow, others stay.
#[test]
fn a_serialized_state_names_the_resources_where_they_are_now() {
    let folders = [(); 2].map(|()| tempfile::tempdir().expect("a folder"));
    let [before, after] = folders.each_ref().map(|folder| folder.path().display().to_string());
    let [mut here, mut there] = folders.each_ref().map(|folder| native_in(folder.path()));
    here.setup_experiment(0.0, None).expect("times");
    here.enter_initialization_mode().expect("it may begin");
    for (named, expected) in [
        (format!("{before}/rows.csv"), format!("{after}/rows.csv")),
        (format!("{before}-more/rows.csv"), format!("{before}-more/rows.csv")),
        ("rows.csv".to_owned(), "rows.csv".to_owned()),
    ] {
        here.set_string(&[0], [named.as_str()]).expect("the spring has one String");
        let bytes = here.save().expect("a state").to_bytes();
        let state = there.deserialize_state(&bytes).expect("a state");
        there.restore(&state).expect("a state");
        assert_eq!(there.get_string(&[0]).expect("a String").next(), Some(expected));
    }
}

#[test]
fn bytes_that_are_no_state_are_refused() {
    let fmu = Fmu::running();
    let mut state = fmu.save();
    let bytes = fmu.serialize(state);
    assert_eq!(fmu.free_state(&mut state), Status::Ok);
    fmu.messages();
    for damaged in [&bytes[..bytes.len() - 1], &bytes[..5], &[][..], b"no state at all"] {
        let (status, copy) = fmu.deserialize(damaged);
        assert_eq!((status, copy), (Status::Error, ptr::null_mut()));
        assert!(!fmu.message().is_empty());
    }
}

/// What a master may do between steps.
#[derive(Clone, Debug)]
enum Action {
    Step,
    Save(usize),
    Restore(usize),
    Serialize(usize),
}

fn action() -> impl Strategy<Value = Action> {
    prop_oneof![
        3 => Just(Action::Step),
        1 => (0..3_usize).prop_map(Action::Save),
        1 => (0..3_usize).prop_map(Action::Restore),
        1 => (0..3_usize).prop_map(Action::Serialize),
    ]
}

proptest! {
    /// Whatever the order of steps, saves, restores and serializations, the values at a step are
    /// those of a run without any of them.
    #[test]
    fn property_any_order_of_saves_and_restores_gives_the_same_bits(
        actions in prop::collection::vec(action(), 1..60),
    ) {
        let expected = run(&Fmu::running(), 0, 60);
        let fmu = Fmu::running();
        let mut states: [*mut c_void; 3] = [ptr::null_mut(); 3];
        let mut saved_at = [0; 3];
        let mut index = 0;
        for action in actions {
            match action {
                Action::Step => {
                    prop_assert_eq!(run(&fmu, index, 1)[0], expected[index as usize]);
                    index += 1;
                }
                Action::Save(slot) => {
                    prop_assert_eq!(fmu.save_into(&mut states[slot]), Status::Ok);
                    saved_at[slot] = index;
                }
                Action::Restore(slot) if !states[slot].is_null() => {
                    prop_assert_eq!(fmu.restore(states[slot]), Status::Ok);
                    index = saved_at[slot];
                }
                Action::Serialize(slot) if !states[slot].is_null() => {
                    let bytes = fmu.serialize(states[slot]);
                    prop_assert_eq!(fmu.free_state(&mut states[slot]), Status::Ok);
                    let (status, state) = fmu.deserialize(&bytes);
                    prop_assert_eq!(status, Status::Ok);
                    states[slot] = state;
                }
                Action::Restore(_) | Action::Serialize(_) => {}
            }
        }
        for state in &mut states {
            prop_assert_eq!(fmu.free_state(state), Status::Ok);
        }
    }
}
