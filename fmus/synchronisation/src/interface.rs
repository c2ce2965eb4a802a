//! The controller as an FMU.

use std::borrow::Cow;
use std::path::Path;

use controller::{Controller, Gains, Motion};
use fmu::{Declaration, Identity, Interval, Log, Model, ModelError, Real, Values, unit};

/// The synchronisation controller of one vehicle.
///
/// The force at the end of a step is that of the errors at its beginning: outputs do not depend
/// on inputs within a step, so a system with it has no algebraic loop.
#[derive(Debug)]
pub struct Synchronisation {
    controller: Controller,
}

/// The variables of the FMU.
#[derive(Debug)]
pub struct Signals {
    /// Motion of the vehicle model.
    pub vehicle: MotionSignals,
    /// Motion of the vehicle's place in the train.
    pub train: MotionSignals,
    /// Kp, N/m.
    pub proportional: Real,
    /// Ki, N/(m s).
    pub integral: Real,
    /// Kd, N s/m.
    pub derivative: Real,
    /// Largest magnitude of the force, N.
    pub limit: Real,
    /// The force, N.
    pub force: Real,
}

/// Position and velocity.
#[derive(Debug, Clone, Copy)]
pub struct MotionSignals {
    /// Chainage, m.
    pub position: Real,
    /// Speed, m/s.
    pub velocity: Real,
}

impl MotionSignals {
    fn declare(declaration: &mut Declaration, prefix: &str, whose: &str) -> Self {
        let mut input = |name: &str, unit, what: &str| {
            declaration.real(format!("{prefix}.{name}"), unit, format!("{what} {whose}")).input(0.0)
        };
        Self {
            position: input("position", unit::METRE, "Chainage of"),
            velocity: input("velocity", unit::METRE_PER_SECOND, "Velocity of"),
        }
    }

    fn read(&self, values: &Values) -> Motion {
        Motion { position: values[self.position], velocity: values[self.velocity] }
    }
}

impl Model for Synchronisation {
    const IDENTITY: Identity = Identity {
        name: "Hotfoot synchronisation",
        identifier: "synchronisation",
        description: "PID controller that keeps a vehicle model at its place in the train model",
        default_step: 1e-3,
    };

    type Signals = Signals;
    type State = f64;

    fn declare(_: &Path, declaration: &mut Declaration) -> Result<Signals, ModelError> {
        let vehicle = MotionSignals::declare(declaration, "vehicle", "the vehicle model");
        let train = MotionSignals::declare(declaration, "train", "its place in the train model");
        let mut gain = |name: &str, unit, what: &str, start| {
            declaration.real(name, unit, what).min(0.0).parameter(start)
        };
        // Gains of Bosomworth et al. 2018, section 2.2.3; the limit as in Hotfoot's scenarios.
        Ok(Signals {
            vehicle,
            train,
            proportional: gain("gain.proportional", unit::NEWTON_PER_METRE, "Kp", 2e3),
            integral: gain("gain.integral", unit::NEWTON_PER_METRE_SECOND, "Ki", 0.0),
            derivative: gain("gain.derivative", unit::NEWTON_SECOND_PER_METRE, "Kd", 10e3),
            limit: gain("force.limit", unit::NEWTON, "Largest magnitude of the force", 500e3),
            force: declaration.real("sync.force", unit::NEWTON, "Force on the vehicle").output(),
        })
    }

    fn initialize(
        signals: &Signals,
        values: &mut Values,
        _resources: &Path,
        _start_time: f64,
        _log: &mut Log,
    ) -> Result<Self, ModelError> {
        let controller = Controller::new(Gains {
            proportional: values[signals.proportional],
            integral: values[signals.integral],
            derivative: values[signals.derivative],
            limit: values[signals.limit],
        });
        let (vehicle, train) = (signals.vehicle.read(values), signals.train.read(values));
        values[signals.force] = finite(controller.force(vehicle, train))?;
        Ok(Self { controller })
    }

    fn step(
        &mut self,
        signals: &Signals,
        values: &mut Values,
        interval: Interval,
        _log: &mut Log,
    ) -> Result<(), ModelError> {
        let (vehicle, train) = (signals.vehicle.read(values), signals.train.read(values));
        values[signals.force] = finite(self.controller.step(vehicle, train, interval.length))?;
        Ok(())
    }

    fn state(&self) -> Cow<'_, f64> {
        Cow::Owned(self.controller.integral())
    }

    fn restore(&mut self, integral: f64) {
        self.controller.restore(integral);
    }
}

/// Huge errors may meet in infinities of both signs.
fn finite(force: f64) -> Result<f64, ModelError> {
    match force.is_finite() {
        true => Ok(force),
        false => Err(ModelError::new(format!(
            "sync.force = {force}: the motions of vehicle and train are too far apart"
        ))),
    }
}
