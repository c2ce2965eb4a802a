//! What the functions that set values admit, and what they say of what they refuse.

use fmu::Kind;
use proptest::prelude::*;

use crate::kettle::{Signals, initializing, instance, running};

/// The message names the variable, the value with its unit, and what is allowed.
#[test]
fn a_value_that_is_not_allowed_is_refused_with_what_is() {
    let kettle = instance();
    let Signals { kettle: handles, .. } = kettle.signals();
    let (volume, filling) = (handles.volume.reference(), handles.filling.reference());
    for (reference, value, sentence) in [
        (
            volume,
            0.0,
            "`kettle.volume` cannot be 0 m: it must be a finite number, greater than 0, at most 3 m",
        ),
        (
            volume,
            3.5,
            "`kettle.volume` cannot be 3.5 m: it must be a finite number, greater than 0, at most 3 m",
        ),
        (filling, 2.0, "`kettle.filling` cannot be 2: it must be a finite number, from 0 to 1"),
    ] {
        let error = initializing().set_real(&[reference], [value]).unwrap_err();
        assert_eq!(error.to_string(), sentence);
    }
    let error = initializing().set_integer(&[handles.cups.reference()], [9]).unwrap_err();
    let sentence = "`cups` cannot be 9: it must be a whole number, from 1 to 8";
    assert_eq!(error.to_string(), sentence);
    let error = initializing().set_string(&[handles.heating.reference()], ["coal"]).unwrap_err();
    let sentence = "`heating` cannot be \"coal\": it must be \"gas\" or \"electric\"";
    assert_eq!(error.to_string(), sentence);
}

/// Bounds hold wherever a variable may be set: Instantiated, initialization mode, step complete.
#[test]
fn bounds_hold_in_every_phase() {
    for (phase, begin) in [
        ("instantiated", instance as fn() -> _),
        ("initializing", initializing),
        ("running", running),
    ] {
        let power = begin().signals().knob.power.reference();
        let air = begin().signals().air.temperature.reference();
        for reference in [power, air] {
            assert!(begin().set_real(&[reference], [0.0]).is_ok(), "{phase}: the bound itself");
            for wrong in [-1e-300, f64::NAN, f64::INFINITY] {
                let result = begin().set_real(&[reference], [wrong]);
                assert!(result.is_err(), "{phase}: {wrong} at {reference}");
            }
        }
    }
}

/// Nothing is stored of a value that is refused.
#[test]
fn a_refused_value_leaves_the_old_one() {
    let mut kettle = initializing();
    let handles = kettle.signals().kettle;
    kettle.set_real(&[handles.volume.reference()], [0.0]).unwrap_err();
    kettle.set_string(&[handles.heating.reference()], ["coal"]).unwrap_err();
    assert_eq!(kettle.values()[handles.volume], 2.0);
    assert_eq!(kettle.values()[handles.heating], "electric");
}

/// A model may rely on what its table says, also in an instance that was set into a saved state.
#[test]
fn a_saved_state_with_a_value_that_is_not_allowed_is_damaged() {
    let mut kettle = running();
    let bytes = kettle.save().unwrap().to_bytes();
    assert!(kettle.deserialize_state(&bytes).is_ok());
    let text = b"electric";
    let at = bytes.windows(text.len()).position(|window| window == text).unwrap();
    let mut damaged = bytes.clone();
    damaged[at] = b'E';
    let error = running().deserialize_state(&damaged).err().unwrap().to_string();
    assert!(error.ends_with("a value is not one that can be set"), "{error}");
}

proptest! {
    /// A setter admits exactly the numbers within the bounds that the declaration states.
    #[test]
    fn property_a_setter_admits_what_the_declaration_allows(
        value in prop_oneof![any::<f64>(), -4.0..4.0, Just(0.0), Just(3.0), Just(5e-324)],
    ) {
        let mut kettle = initializing();
        let handles = kettle.signals().kettle;
        let variables = kettle.declaration().variables().to_vec();
        for (handle, index) in [(handles.volume, 0), (handles.filling, 1), (handles.height, 2)] {
            let Kind::Real { bounds, .. } = variables[index].kind else {
                unreachable!("they are Real");
            };
            let above_min = bounds.min.is_none_or(|min| match bounds.above {
                true => value > min,
                false => value >= min,
            });
            let allowed = value.is_finite() && above_min && bounds.max.is_none_or(|max| value <= max);
            let mut fresh = initializing();
            let result = fresh.set_real(&[handle.reference()], [value]);
            prop_assert_eq!(result.is_ok(), allowed, "{} = {}", variables[index].name, value);
        }
        prop_assert!(kettle.set_real(&[handles.height.reference()], [1.0]).is_ok());
    }
}
