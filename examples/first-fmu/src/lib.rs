//! A first FMU: a wheel that warms under its tread brake.
//!
//! ```text
//! m c dT/dt = P − h A (T − T_air)
//! ```
//!
//! With inputs that are constant over a step this has a closed form, so any step is exact:
//! T approaches T_air + P/(h A) with the time constant m c/(h A).

use std::borrow::Cow;
use std::path::Path;

use fmu::{Declaration, Handles, Identity, Interval, Log, Model, ModelError, Values, Variables};

fmu::variables! {
    /// What the wheel is.
    #[derive(Copy)]
    pub struct Properties: parameter {
        /// Heat capacity of the wheel
        heat_capacity: "heat_capacity", JOULE_PER_KELVIN = 160e3, above(0.0);
        /// Heat that the wheel gives to the air for each kelvin above it
        cooling: "cooling", WATT_PER_KELVIN = 40.0, above(0.0);
        /// Temperature of the wheel at the start
        initial_temperature: "initial.temperature", KELVIN = 293.15, 0.0..;
    }

    /// What acts on it.
    #[derive(Copy)]
    pub struct Surroundings: input {
        /// Heat of the brake into the wheel
        brake_power: "brake_power", WATT = 0.0, 0.0..;
        /// Temperature of the air
        ambient: "ambient.temperature", KELVIN = 293.15, 0.0..;
    }

    /// The wheel, which is all that changes.
    #[derive(Copy)]
    pub struct Wheel: output {
        /// Temperature of the wheel
        temperature: "temperature", KELVIN;
    }

    /// All variables of the FMU.
    pub struct Signals {
        /// What the wheel is.
        properties: "", group(Properties);
        /// What acts on it.
        surroundings: "", group(Surroundings);
        /// The wheel.
        wheel: "", group(Wheel);
    }
}

impl Wheel {
    /// Lets a `time`, s, pass.
    fn advance(&mut self, properties: &Properties, surroundings: &Surroundings, time: f64) {
        let final_temperature =
            surroundings.ambient + surroundings.brake_power / properties.cooling;
        let decay = (-time * properties.cooling / properties.heat_capacity).exp();
        self.temperature = final_temperature + (self.temperature - final_temperature) * decay;
    }
}

/// The model: what is computed once from parameters, and what changes.
#[derive(Debug)]
pub struct BrakedWheel {
    properties: Properties,
    wheel: Wheel,
}

impl Model for BrakedWheel {
    const IDENTITY: Identity = Identity {
        name: "Braked wheel",
        identifier: "first_fmu",
        description: "A wheel that warms under its tread brake and cools in the air",
        default_step: 1.0,
    };

    type Signals = Handles<Signals>;
    type State = f64;

    fn declare(
        _resources: &Path,
        declaration: &mut Declaration,
    ) -> Result<Handles<Signals>, ModelError> {
        Ok(Signals::declare(declaration, ""))
    }

    fn initialize(
        signals: &Handles<Signals>,
        values: &mut Values,
        _resources: &Path,
        _start_time: f64,
        _log: &mut Log,
    ) -> Result<Self, ModelError> {
        let properties = Properties::read(&signals.properties, values);
        let wheel = Wheel { temperature: properties.initial_temperature };
        wheel.write(&signals.wheel, values);
        Ok(Self { properties, wheel })
    }

    fn step(
        &mut self,
        signals: &Handles<Signals>,
        values: &mut Values,
        interval: Interval,
        _log: &mut Log,
    ) -> Result<(), ModelError> {
        let surroundings = Surroundings::read(&signals.surroundings, values);
        self.wheel.advance(&self.properties, &surroundings, interval.length);
        self.wheel.write(&signals.wheel, values);
        Ok(())
    }

    fn state(&self) -> Cow<'_, f64> {
        Cow::Borrowed(&self.wheel.temperature)
    }

    fn restore(&mut self, temperature: f64) {
        self.wheel.temperature = temperature;
    }
}

fmu::export!(BrakedWheel);

#[cfg(test)]
mod tests {
    use super::*;

    fn instance() -> fmu::Instance<BrakedWheel> {
        fmu::Instance::new(Path::new(""), "wheel", Box::new(|_, _| {})).unwrap()
    }

    /// 1 kW for an hour: 25 K (1 − e^(−0.9)), whatever the step.
    #[test]
    fn analytic_a_braked_wheel_approaches_its_final_temperature() {
        for steps in [1, 7, 3600] {
            let mut instance = instance();
            instance.setup_experiment(0.0, None).unwrap();
            instance.enter_initialization_mode().unwrap();
            instance.exit_initialization_mode().unwrap();
            let power = instance.signals().surroundings.brake_power.reference();
            instance.set_real(&[power], [1000.0]).unwrap();
            let step = 3600.0 / f64::from(steps);
            for k in 0..steps {
                instance.do_step(f64::from(k) * step, step).unwrap();
            }
            let temperature = instance.values()[instance.signals().wheel.temperature];
            let expected = 293.15 + 25.0 * (1.0 - (-0.9_f64).exp());
            assert!((temperature - expected).abs() < 1e-9, "{steps} steps: {temperature} K");
        }
    }

    #[test]
    fn a_wheel_without_cooling_is_refused_with_the_bound() {
        let mut instance = instance();
        let cooling = instance.signals().properties.cooling.reference();
        let refused = instance.set_real(&[cooling], [0.0]).unwrap_err().to_string();
        assert!(refused.contains("greater than 0"), "{refused}");
    }
}
