//! Tables of variables: what a model declares with them, and what an instance then admits.
//!
//! `kitchen.rs` has the tables and their model.

mod kitchen;

use std::borrow::Cow;
use std::path::Path;

use fmu::{
    Causality, Declaration, Handles, Identity, Instance, Interval, Kind, Log, Model, ModelError,
    ResourceFile, Values, Variables, model_description, unit,
};
use kitchen::*;
use proptest::prelude::*;

#[test]
fn a_table_declares_its_rows_in_their_order() {
    let instance = instance();
    let variables = instance.declaration().variables();
    let names: Vec<_> = variables.iter().map(|variable| variable.name.as_str()).collect();
    let of_sides = [
        "side[1].spot[1].temperature",
        "side[1].spot[1].bubbles",
        "side[1].spot[1].boils",
        "side[1].spot[2].temperature",
        "side[1].spot[2].bubbles",
        "side[1].spot[2].boils",
        "side[1].temperature",
        "side[1].bubbles",
        "side[1].boils",
        "side[1].area",
    ];
    let before = [
        "kettle.volume",
        "kettle.filling",
        "height",
        "cups",
        "lid",
        "label",
        "heating",
        "recipe_file",
        "knob.power",
        "air.temperature",
    ];
    assert_eq!(names[..20], [before, of_sides].concat());
    assert_eq!(names.len(), 30);
    assert_eq!(variables[20].name, "side[2].spot[1].temperature");
}

/// The first paragraph of a doc comment, on one line and without its full stop.
#[test]
fn the_doc_comment_is_the_description() {
    let instance = instance();
    let description = |name: &str| {
        let mut variables = instance.declaration().variables().iter();
        variables.find(|variable| variable.name == name).unwrap().description.as_str()
    };
    assert_eq!(description("kettle.volume"), "Volume of the kettle");
    assert_eq!(description("heating"), "Heating: \"gas\" or \"electric\"");
    assert_eq!(description("side[2].spot[1].boils"), "Whether it boils at spot 1 of side 2");
    assert_eq!(description("side[2].boils"), "Whether it boils at all spots of side 2");
}

#[test]
fn a_table_says_what_its_variables_are_for() {
    let instance = instance();
    for variable in instance.declaration().variables() {
        let expected = match variable.name.as_str() {
            name if name.starts_with("side") => Causality::Output,
            "air.temperature" => Causality::Input,
            _ => Causality::Parameter,
        };
        assert_eq!(variable.causality, expected, "{}", variable.name);
    }
}

#[test]
fn start_values_are_those_of_the_table() {
    let instance = instance();
    let kettle = Kettle::read(&instance.signals().kettle, instance.values());
    let expected = Kettle {
        volume: 2.0,
        filling: 0.5,
        height: -1.5,
        cups: 4,
        lid: true,
        label: "blue".to_owned(),
        heating: Heating::Electric,
        recipe: ResourceFile { named: String::new(), default: "recipe.toml" },
    };
    assert_eq!(kettle, expected);
    assert_eq!(Knob::read(&instance.signals().knob, instance.values()), Knob { power: 1e3 });
}

#[test]
fn what_is_written_is_read_back() {
    let mut declaration = Declaration::default();
    let handles = Kettle::declare(&mut declaration, "");
    let mut values = declaration.start_values().clone();
    let kettle = Kettle {
        volume: 1.0,
        filling: 0.25,
        height: 7.0,
        cups: 3,
        lid: false,
        label: "red".to_owned(),
        heating: Heating::Gas,
        recipe: ResourceFile { named: "/soup.toml".to_owned(), default: "recipe.toml" },
    };
    kettle.write(&handles, &mut values);
    assert_eq!(Kettle::read(&handles, &values), kettle);
    assert_eq!(values[handles.heating], "gas");
    assert_eq!(values[handles.recipe.parameter], "/soup.toml");
}

#[test]
fn a_table_of_reals_alone_is_written_to_its_handles_and_nowhere_else() {
    let mut declaration = Declaration::default();
    let before = declaration.real("before", unit::ONE, "Before").output();
    let handles = Flow::declare(&mut declaration, "flow");
    let after = declaration.real("after", unit::ONE, "After").output();
    let mut values = declaration.start_values().clone();
    let flow = Flow { mass: 1.0, speed: 2.0, power: 3.0 };
    flow.write(&handles, &mut values);
    let written = [before, handles.mass, handles.speed, handles.power, after];
    assert_eq!(written.map(|handle| values[handle]), [0.0, 1.0, 2.0, 3.0, 0.0]);
    values[handles.speed] = -7.0;
    assert_eq!(Flow::read(&handles, &values), Flow { speed: -7.0, ..flow });
}

#[test]
fn groups_are_written_where_they_stand() {
    let mut kettle = running();
    let air = kettle.signals().air.temperature.reference();
    kettle.set_real(&[air], [400.0]).unwrap();
    kettle.do_step(1.0, 1.0).unwrap();
    let side = Side::read(&kettle.signals().sides[1], kettle.values());
    let spot = Spot { temperature: 400.0, bubbles: 1, boils: true };
    assert_eq!(side, Side { spots: [spot; 2], mean: spot, area: 0.25 });
}

/// FMI 2.0 cannot say that a bound itself is not allowed (§2.2.3), so the description says it.
#[test]
fn an_excluded_minimum_stands_in_the_description_and_its_number_in_the_xml() {
    let text = model_description::<Kitchen>(Path::new("")).unwrap();
    let expected = "description=\"Volume of the kettle; greater than 0, at most 3\"";
    assert_eq!(text.matches(expected).count(), 1, "{text}");
    assert!(text.contains(r#"<Real unit="m" min="0" max="3" start="2"/>"#), "{text}");
}

/// Outputs of every type are computed, so none has a start value (§2.2.7).
#[test]
fn no_output_of_any_type_has_a_start_value() {
    let text = model_description::<Kitchen>(Path::new("")).unwrap();
    for element in ["<Integer/>", "<Boolean/>", r#"<Real unit="m2"/>"#] {
        assert!(text.contains(element), "{element}\n{text}");
    }
}

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

#[test]
fn a_start_value_out_of_bounds_is_refused_when_the_interface_is_formed() {
    fmu::variables! {
        /// A start value that its own bounds exclude.
        struct Wrong: parameter {
            /// Length
            length: "length", METRE = 0.0, above(0.0);
        }
    }
    struct Broken;
    impl Model for Broken {
        const IDENTITY: Identity = Kitchen::IDENTITY;
        type Signals = Handles<Wrong>;
        type State = ();

        fn declare(_: &Path, d: &mut Declaration) -> Result<Handles<Wrong>, ModelError> {
            Ok(Wrong::declare(d, ""))
        }

        fn initialize(
            _: &Handles<Wrong>,
            _: &mut Values,
            _: &Path,
            _: f64,
            _: &mut Log,
        ) -> Result<Self, ModelError> {
            Ok(Self)
        }

        fn step(
            &mut self,
            _: &Handles<Wrong>,
            _: &mut Values,
            _: Interval,
            _: &mut Log,
        ) -> Result<(), ModelError> {
            Ok(())
        }

        fn state(&self) -> Cow<'_, ()> {
            Cow::Owned(())
        }

        fn restore(&mut self, (): ()) {}
    }
    let error = Instance::<Broken>::new(Path::new(""), "one", Box::new(|_, _| {})).err().unwrap();
    let sentence = "the interface cannot be formed: the start value of `length` must be \
                    a finite number, greater than 0 m";
    assert_eq!(error.to_string(), sentence);
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

/// What stands in no table is declared one by one, with the same kinds.
#[test]
fn a_builder_makes_what_a_table_makes() {
    let mut by_table = Declaration::default();
    Kettle::declare(&mut by_table, "");
    let mut by_hand = Declaration::default();
    let volume = by_hand.real("kettle.volume", unit::METRE, "Volume of the kettle");
    let _ = volume.within(fmu::above(0.0).at_most(3.0)).parameter(2.0);
    assert_eq!(by_table.variables()[0], by_hand.variables()[0]);
}
