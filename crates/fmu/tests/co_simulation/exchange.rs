//! Getting and setting values.

use std::ffi::{CStr, c_char, c_int};
use std::ptr;

use fmu::Status;

use crate::fmi2::*;
use crate::tool::Fmu;

fn get_string(fmu: &Fmu, name: &str) -> *const c_char {
    let mut value = ptr::null();
    // SAFETY: the component lives, and there is room for one value.
    let status = unsafe { fmi2GetString(fmu.component, &fmu.reference(name), 1, &mut value) };
    assert_eq!(status, Status::Ok);
    value
}

#[test]
fn values_of_all_types_come_back_as_they_were_set() {
    let fmu = Fmu::new();
    let (substeps, damped) = (fmu.reference("substeps"), fmu.reference("damped"));
    let (mut integer, mut boolean): (i32, c_int) = (0, 7);
    assert_eq!(fmu.set("mass", 2.5), Status::Ok);
    assert_eq!(fmu.set_string("trouble", "Zähes Öl, 50 %"), Status::Ok);
    // SAFETY: the component lives, and there is one value each.
    unsafe {
        assert_eq!(fmi2SetInteger(fmu.component, &substeps, 1, &9), Status::Ok);
        assert_eq!(fmi2SetBoolean(fmu.component, &damped, 1, &0), Status::Ok);
        fmu.begin();
        let status = fmi2GetInteger(fmu.component, &substeps, 1, &mut integer);
        assert_eq!(status, Status::Ok);
        let status = fmi2GetBoolean(fmu.component, &damped, 1, &mut boolean);
        assert_eq!(status, Status::Ok);
    }
    assert_eq!((integer, boolean, fmu.get("mass")), (9, 0, 2.5));
    // SAFETY: the text lives until the next call.
    let text = unsafe { CStr::from_ptr(get_string(&fmu, "trouble")) };
    assert_eq!(text.to_str(), Ok("Zähes Öl, 50 %"));
}

#[test]
fn a_text_lives_until_the_next_one_is_asked_for() {
    let fmu = Fmu::initializing();
    assert_eq!(fmu.set_string("trouble", "first"), Status::Ok);
    let text = get_string(&fmu, "trouble");
    assert_eq!(fmu.set_string("trouble", "second"), Status::Ok);
    // SAFETY: no text was asked for since.
    assert_eq!(unsafe { CStr::from_ptr(text) }, c"first");
}

#[test]
fn an_unknown_value_reference_is_named() {
    let fmu = Fmu::running();
    let (status, _) = fmu.get_reals(&[0, 4711]);
    assert_eq!(status, Status::Error);
    assert!(fmu.messages().iter().any(|message| {
        message.text == "there is no Real variable with value reference 4711; there are 8"
    }));
    let fmu = Fmu::initializing();
    // SAFETY: the component lives, and there is one value.
    let status = unsafe { fmi2SetInteger(fmu.component, &1, 1, &1) };
    assert_eq!(status, Status::Error);
    assert!(fmu.message().contains("no Integer variable with value reference 1"));
}

#[test]
fn nothing_needs_no_arrays_and_something_does() {
    let fmu = Fmu::running();
    fmu.messages();
    // SAFETY: null is allowed.
    unsafe {
        let (c, none) = (fmu.component, ptr::null());
        assert_eq!(fmi2GetReal(c, none, 0, ptr::null_mut()), Status::Ok);
        assert_eq!(fmi2SetReal(c, none, 0, ptr::null()), Status::Ok);
        assert_eq!(fmi2GetReal(c, none, 1, ptr::null_mut()), Status::Error);
    }
    assert_eq!(fmu.message(), "the argument `vr` is a null pointer");
}

#[test]
fn nothing_can_be_got_and_set_of_every_type() {
    let fmu = Fmu::running();
    let (c, none) = (fmu.component, ptr::null());
    // SAFETY: null is allowed.
    let statuses = unsafe {
        [
            fmi2GetReal(c, none, 0, ptr::null_mut()),
            fmi2GetInteger(c, none, 0, ptr::null_mut()),
            fmi2GetBoolean(c, none, 0, ptr::null_mut()),
            fmi2GetString(c, none, 0, ptr::null_mut()),
            fmi2SetReal(c, none, 0, ptr::null()),
            fmi2SetInteger(c, none, 0, ptr::null()),
            fmi2SetBoolean(c, none, 0, ptr::null()),
            fmi2SetString(c, none, 0, ptr::null()),
        ]
    };
    assert_eq!(statuses, [Status::Ok; 8]);
}

#[test]
fn an_unknown_value_reference_is_refused_of_every_type() {
    const UNKNOWN: u32 = 4711;
    let (mut real, mut integer, mut text) = (0.0, 0, ptr::null());
    for number in 0..8 {
        let fmu = Fmu::initializing();
        let c = fmu.component;
        // SAFETY: the component lives, and there is one value or room for one.
        let status = unsafe {
            match number {
                0 => fmi2GetReal(c, &UNKNOWN, 1, &mut real),
                1 => fmi2GetInteger(c, &UNKNOWN, 1, &mut integer),
                2 => fmi2GetBoolean(c, &UNKNOWN, 1, &mut integer),
                3 => fmi2GetString(c, &UNKNOWN, 1, &mut text),
                4 => fmi2SetReal(c, &UNKNOWN, 1, &1.0),
                5 => fmi2SetInteger(c, &UNKNOWN, 1, &1),
                6 => fmi2SetBoolean(c, &UNKNOWN, 1, &1),
                _ => fmi2SetString(c, &UNKNOWN, 1, &c"".as_ptr()),
            }
        };
        assert_eq!(status, Status::Error, "{number}");
        let messages = fmu.messages();
        let last = &messages.last().expect("a reason").text;
        assert!(last.contains("variable with value reference 4711"), "{last}");
    }
}

/// C knows more than one way to say true; the standard wants 0 or 1 back.
#[test]
fn a_boolean_is_zero_or_one() {
    let fmu = Fmu::initializing();
    let damped = fmu.reference("damped");
    for (given, expected) in [(0, 0), (1, 1), (2, 1), (-1, 1)] {
        let mut value: c_int = 7;
        // SAFETY: the component lives, and there is one value, and room for one.
        let statuses = unsafe {
            [
                fmi2SetBoolean(fmu.component, &damped, 1, &given),
                fmi2GetBoolean(fmu.component, &damped, 1, &mut value),
            ]
        };
        assert_eq!((statuses, value), ([Status::Ok; 2], expected), "{given}");
    }
}

#[test]
fn values_out_of_bounds_or_not_finite_are_refused() {
    for (name, value, sentence) in [
        ("mass", 0.0, "`mass` cannot be 0 kg: it must be a finite number, at least 0.1 kg"),
        (
            "force",
            2e6,
            "`force` cannot be 2000000 N: it must be a finite number, at most 1000000 N",
        ),
        ("force", f64::NAN, "`force` cannot be NaN: it must be a finite number, at most 1000000 N"),
        (
            "stiffness",
            f64::INFINITY,
            "`stiffness` cannot be inf: it must be a finite number, from 0 to 1000000000 N",
        ),
        (
            "initial.position",
            f64::NEG_INFINITY,
            "`initial.position` cannot be -inf: it must be a finite number",
        ),
    ] {
        let fmu = Fmu::initializing();
        assert_eq!(fmu.set(name, value), Status::Error, "{name} = {value}");
        assert_eq!(fmu.message(), sentence);
    }
    let fmu = Fmu::new();
    let substeps = fmu.reference("substeps");
    // SAFETY: the component lives, and there is one value.
    let status = unsafe { fmi2SetInteger(fmu.component, &substeps, 1, &0) };
    assert_eq!(status, Status::Error);
    assert_eq!(fmu.message(), "`substeps` cannot be 0: it must be a whole number, from 1 to 100");
}

/// Notes 1, 3 and 6 of the table of §4.2.4: what may be set in the states Instantiated,
/// initialization Mode and step Complete. Beyond note 1 an input can be given its start value when
/// Instantiated, as by libcosim (see `settable` in `calls.rs`).
#[test]
fn a_variable_can_be_set_in_the_states_of_its_causality() {
    for (name, states) in [("force", "IMC"), ("mass", "IM"), ("stiffness", "IMC"), ("position", "")]
    {
        for (letter, fmu) in [('I', Fmu::new()), ('M', Fmu::initializing()), ('C', Fmu::running())]
        {
            fmu.messages();
            let accepted = fmu.set(name, 1.0) == Status::Ok;
            assert_eq!(accepted, states.contains(letter), "{name} {letter}");
            if !accepted {
                let message = fmu.message();
                assert!(message.starts_with(&format!("`{name}` may not be set")), "{message}");
            }
        }
    }
}

#[test]
fn a_fixed_text_cannot_be_set_between_steps() {
    let fmu = Fmu::running();
    fmu.messages();
    assert_eq!(fmu.set_string("trouble", "nan"), Status::Error);
    let message = fmu.message();
    assert!(
        message.ends_with("in the state \"step complete\": it is a fixed parameter"),
        "{message}"
    );
}

#[test]
fn a_text_that_is_not_utf8_is_refused() {
    let fmu = Fmu::new();
    let text = c"\xff".as_ptr();
    // SAFETY: the component lives, and there is one value.
    let status = unsafe { fmi2SetString(fmu.component, &fmu.reference("trouble"), 1, &text) };
    assert_eq!(status, Status::Error);
    assert_eq!(fmu.message(), "the argument `value` is not UTF-8");
}

#[test]
fn derivatives_are_refused_with_the_flag_that_says_so() {
    let fmu = Fmu::running();
    fmu.messages();
    // SAFETY: the component lives, and the arrays are empty.
    let status = unsafe {
        fmi2SetRealInputDerivatives(fmu.component, ptr::null(), 0, ptr::null(), ptr::null())
    };
    assert_eq!(status, Status::Error);
    let sentence = "fmi2SetRealInputDerivatives is not offered: \
                    modelDescription.xml has canInterpolateInputs=\"false\"";
    assert_eq!(fmu.message(), sentence);
}
