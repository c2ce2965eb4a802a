//! What tables declare, and what the model description says of it.

use std::borrow::Cow;
use std::path::Path;

use fmu::{
    Causality, Declaration, Handles, Identity, Instance, Interval, Log, Model, ModelError,
    ResourceFile, Values, Variables, model_description, unit,
};

use crate::kettle::{Heating, Kettle, Kitchen, Knob, instance};

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
