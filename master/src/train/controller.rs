//! The controller of a vehicle as a unit of the run, with the interface of the FMU `synchronisation`:
//! it keeps the vehicle where the train has it.

use controller::{Controller, Gains, Motion};

use super::roles::tables::{CONTROLLER_INPUT, CONTROLLER_OUTPUT};
use crate::interface::range::Range;
use crate::interface::{Interface, Variable, VariableType};
use crate::scenario::Synchronisation;
use crate::system::structure::{Parameter, Value};
use crate::system::unit::{Unit, UnitError};

/// Parameters of the FMU.
const PARAMETERS: [&str; 4] =
    ["gain.proportional", "gain.integral", "gain.derivative", "force.limit"];

impl From<&Synchronisation> for Gains {
    fn from(file: &Synchronisation) -> Self {
        Self {
            proportional: file.kp_kn_per_m * 1e3,
            integral: file.ki_kn_per_m_s * 1e3,
            derivative: file.kd_kn_s_per_m * 1e3,
            limit: file.limit_kn * 1e3,
        }
    }
}

/// Gains and limit of a controller as its parameters.
pub fn parameters(gains: &Gains) -> Vec<Parameter> {
    let values = [gains.proportional, gains.integral, gains.derivative, gains.limit];
    let parameter = |(name, value): (&str, f64)| Parameter::new(name, Value::Real(value));
    PARAMETERS.into_iter().zip(values).map(parameter).collect()
}

/// The variables of every controller, in the order of their value references.
pub fn interface() -> Interface {
    let inputs = CONTROLLER_INPUT.iter().map(|variable| (variable.name, "input"));
    let outputs = CONTROLLER_OUTPUT.iter().map(|variable| (variable.name, "output"));
    let parameters = PARAMETERS.iter().map(|name| (*name, "parameter"));
    let variables = inputs.chain(outputs).chain(parameters);
    Interface::of((0..).zip(variables).map(|(reference, (name, causality))| Variable {
        name: name.to_owned(),
        reference,
        kind: VariableType::Real,
        causality: causality.to_owned(),
        discrete: false,
        unit: None,
        si: None,
        range: Range::FINITE,
        start: None,
        description: String::new(),
    }))
}

/// The controller of one vehicle. As in its FMU the force after a step is that of the errors at the
/// beginning of the step.
pub struct ControllerUnit {
    name: String,
    source_file: String,
    interface: Interface,
    controller: Controller,
    /// Whether the initialisation has ended.
    begun: bool,
    /// Motions of vehicle and train, force, and parameters.
    values: [f64; VALUES],
}

/// Number of the variables.
const VALUES: usize = CONTROLLER_INPUT.len() + CONTROLLER_OUTPUT.len() + PARAMETERS.len();
/// Index of the force.
const FORCE: usize = CONTROLLER_INPUT.len();

impl ControllerUnit {
    /// A controller that stands for the FMU `source_file`.
    pub fn new(name: &str, source_file: &str) -> Self {
        let limit = f64::INFINITY;
        let none = Gains { proportional: 0.0, integral: 0.0, derivative: 0.0, limit };
        Self {
            name: name.to_owned(),
            source_file: source_file.to_owned(),
            interface: interface(),
            controller: Controller::new(none),
            begun: false,
            values: [0.0; VALUES],
        }
    }

    fn motions(&self) -> [Motion; 2] {
        let [vehicle_position, vehicle_velocity, train_position, train_velocity, ..] = self.values;
        [
            Motion { position: vehicle_position, velocity: vehicle_velocity },
            Motion { position: train_position, velocity: train_velocity },
        ]
    }

    /// The controller as its parameters say, with the force of the motions at the start.
    fn start(&mut self) -> Result<(), UnitError> {
        let [.., proportional, integral, derivative, limit] = self.values;
        self.controller = Controller::new(Gains { proportional, integral, derivative, limit });
        let [vehicle, train] = self.motions();
        self.give(self.controller.force(vehicle, train))
    }

    /// Gives a force; huge errors may meet in infinities of both signs.
    fn give(&mut self, force: f64) -> Result<(), UnitError> {
        self.values[FORCE] = force;
        match force.is_finite() {
            true => Ok(()),
            false => Err(UnitError {
                instance: self.name.as_str().into(),
                source_file: self.source_file.as_str().into(),
                action: format!("the step with sync.force = {force}").into(),
                status: None,
                last_message: Some("the motions of vehicle and train are too far apart".into()),
            }),
        }
    }
}

impl Unit for ControllerUnit {
    fn name(&self) -> &str {
        &self.name
    }

    fn source_file(&self) -> &str {
        &self.source_file
    }

    fn interface(&self) -> &Interface {
        &self.interface
    }

    fn is_brief(&self) -> bool {
        true
    }

    fn set_reals(&mut self, references: &[u32], values: &[f64]) -> Result<(), UnitError> {
        for (&reference, &value) in references.iter().zip(values) {
            self.values[reference as usize] = value;
        }
        Ok(())
    }

    /// In the initialisation the force follows the motions.
    fn get_reals(&mut self, references: &[u32], values: &mut [f64]) -> Result<(), UnitError> {
        if !self.begun {
            self.start()?;
        }
        for (&reference, value) in references.iter().zip(values) {
            *value = self.values[reference as usize];
        }
        Ok(())
    }

    fn enter_initialization(&mut self, _: f64, _: f64) -> Result<(), UnitError> {
        Ok(())
    }

    fn exit_initialization(&mut self) -> Result<(), UnitError> {
        self.begun = true;
        self.start()
    }

    fn step(&mut self, _: f64, length: f64) -> Result<(), UnitError> {
        let [vehicle, train] = self.motions();
        let force = self.controller.step(vehicle, train, length);
        self.give(force)
    }

    fn keeps_states(&self) -> bool {
        true
    }

    fn save(&mut self) -> Result<Vec<u8>, UnitError> {
        let state = (self.controller.integral(), self.values);
        Ok(postcard::to_allocvec(&state).expect("plain data can always be serialized"))
    }

    fn restore(&mut self, saved: &[u8]) -> Result<(), UnitError> {
        let state = postcard::from_bytes(saved).map_err(|error| self.differs(&error.to_string()));
        let (integral, values) = state?;
        self.values = values;
        self.controller.restore(integral);
        Ok(())
    }

    fn terminate(&mut self) -> Result<(), UnitError> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// F = -(Kp e + Kd de/dt) of Bosomworth et al. (2018), eq. 7, with e = 0.5 m and de/dt = -0.1 m/s.
    #[test]
    fn analytic_the_force_is_that_of_the_errors_at_the_beginning_of_the_step() {
        let mut unit: Box<dyn Unit> = Box::new(ControllerUnit::new("controller[1]", "a test"));
        let reference = |name: &str| interface().variable(name).unwrap().reference;
        let gains = Gains { proportional: 2e3, integral: 0.0, derivative: 5e3, limit: 400.0 };
        for parameter in parameters(&gains) {
            let Value::Real(value) = parameter.value else { panic!("{parameter:?}") };
            unit.set_real_parameter(&parameter.name, value).unwrap();
        }
        let force = [reference("sync.force")];
        let inputs = CONTROLLER_INPUT.iter().map(|variable| reference(variable.name));
        let inputs: Vec<u32> = inputs.collect();
        unit.enter_initialization(0.0, 1.0).unwrap();
        unit.exit_initialization().unwrap();
        let mut values = [f64::NAN];
        for (motions, expected) in
            [([10.5, 16.0, 10.0, 16.1], -400.0), ([10.1, 16.0, 10.0, 16.0], -200.0)]
        {
            unit.set_reals(&inputs, &motions).unwrap();
            unit.step(0.0, 0.1).unwrap();
            unit.get_reals(&force, &mut values).unwrap();
            assert!((values[0] - expected).abs() < 1e-9, "{values:?}, expected {expected}");
        }
    }
}
