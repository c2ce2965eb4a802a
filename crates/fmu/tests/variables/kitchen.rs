//! A kettle in a kitchen: tables with a row of every kind, and a model that has them.

use std::borrow::Cow;
use std::path::Path;

use fmu::{
    Declaration, Handles, Identity, Instance, Interval, Log, Model, ModelError, Scope, Values,
    Variables,
};

fmu::choices! {
    /// How the kettle is heated.
    pub enum Heating {
        /// By gas.
        Gas = "gas",
        /// By electricity.
        Electric = "electric",
    }
}

fmu::variables! {
    /// One row of every kind.
    pub struct Kettle: parameter {
        /// Volume of the
        /// kettle.
        ///
        /// A second paragraph is for those who read the code.
        volume: "kettle.volume", METRE = 2.0, above(0.0).at_most(3.0);
        /// Share that is filled
        filling: "kettle.filling", ONE = 0.5, 0.0..=1.0;
        /// Height above the sea
        height: "height", METRE = -1.5;
        /// Number of cups
        cups: "cups", i32 = 4, 1..=8;
        /// Whether there is a lid
        lid: "lid", bool = true;
        /// Name for people
        label: "label", String = "blue";
        /// Heating: "gas" or "electric"
        heating: "heating", choice(Heating) = Heating::Electric;
        /// Recipe; empty: recipe.toml in the resources
        recipe: "recipe_file", file("recipe.toml");
    }

    /// What may be turned while the kettle is on.
    #[derive(Copy, Default)]
    pub struct Knob: tunable {
        /// Power
        power: "power", WATT = 1e3, 0.0..;
    }

    /// What is known of a spot.
    #[derive(Copy, Default)]
    pub struct Spot: output {
        /// Temperature at {}
        temperature: "temperature", KELVIN;
        /// Number of bubbles at {}
        bubbles: "bubbles", i32;
        /// Whether it boils at {}
        boils: "boils", bool;
    }

    /// The spots of one side.
    #[derive(Copy, Default)]
    pub struct Side: output {
        /// The spots.
        spots: ["spot[1]", "spot[2]"], group(Spot) = ["spot 1 of {}", "spot 2 of {}"];
        /// What all of them are.
        mean: "", group(Spot) = "all spots of {}";
        /// Area
        area: "area", SQUARE_METRE;
    }

    /// A table of Real variables alone, which is copied at once.
    #[derive(Copy)]
    pub struct Flow: output {
        /// Mass of steam
        mass: "mass", KILOGRAM;
        /// Speed of the steam
        speed: "speed", METRE_PER_SECOND;
        /// Power of the steam
        power: "power", WATT;
    }

    /// Air around the kettle.
    #[derive(Copy)]
    pub struct Air: input {
        /// Temperature of the air
        temperature: "air.temperature", KELVIN = 293.15, 0.0..;
    }
}

/// A kettle whose spots are as warm as the air.
pub struct Kitchen {
    sides: [Side; 2],
}

/// The variables of the kitchen.
pub struct Signals {
    pub kettle: Handles<Kettle>,
    pub knob: Handles<Knob>,
    pub air: Handles<Air>,
    pub sides: Vec<Handles<Side>>,
}

impl Model for Kitchen {
    const IDENTITY: Identity = Identity {
        name: "Kettle",
        identifier: "kettle",
        description: "A kettle",
        default_step: 1.0,
    };
    type Signals = Signals;
    type State = ();

    fn declare(_: &Path, declaration: &mut Declaration) -> Result<Signals, ModelError> {
        Ok(Signals {
            kettle: Kettle::declare(declaration, ""),
            knob: Knob::declare(declaration, "knob"),
            air: Air::declare(declaration, ""),
            sides: (1..=2)
                .map(|i| {
                    let scope = Scope::from(format!("side[{i}]")).about(&format!("side {i}"));
                    Side::declare(declaration, scope)
                })
                .collect(),
        })
    }

    fn initialize(
        signals: &Signals,
        values: &mut Values,
        _resources: &Path,
        _start_time: f64,
        _log: &mut Log,
    ) -> Result<Self, ModelError> {
        let mut kettle = Self { sides: [Side::default(); 2] };
        kettle.show(signals, values);
        Ok(kettle)
    }

    fn step(
        &mut self,
        signals: &Signals,
        values: &mut Values,
        _interval: Interval,
        _log: &mut Log,
    ) -> Result<(), ModelError> {
        self.show(signals, values);
        Ok(())
    }

    fn state(&self) -> Cow<'_, ()> {
        Cow::Owned(())
    }

    fn restore(&mut self, (): ()) {}
}

impl Kitchen {
    fn show(&mut self, signals: &Signals, values: &mut Values) {
        let temperature = Air::read(&signals.air, values).temperature;
        for (number, (side, handles)) in self.sides.iter_mut().zip(&signals.sides).enumerate() {
            let spot = Spot { temperature, bubbles: number as i32, boils: temperature > 373.15 };
            *side = Side { spots: [spot; 2], mean: spot, area: 0.25 };
            side.write(handles, values);
        }
    }
}

/// An instance before its initialisation.
pub fn instance() -> Instance<Kitchen> {
    Instance::new(Path::new(""), "kettle", Box::new(|_, _| {})).unwrap()
}

/// An instance in initialization mode.
pub fn initializing() -> Instance<Kitchen> {
    let mut instance = instance();
    instance.setup_experiment(0.0, None).unwrap();
    instance.enter_initialization_mode().unwrap();
    instance
}

/// An instance that has made a step.
pub fn running() -> Instance<Kitchen> {
    let mut instance = initializing();
    instance.exit_initialization_mode().unwrap();
    instance.do_step(0.0, 1.0).unwrap();
    instance
}
