//! The controller as an FMU.

use std::borrow::Cow;
use std::path::Path;

use controller::Controller;
use fmu::{Declaration, Handles, Identity, Interval, Log, Model, ModelError, Values, Variables};

use crate::signals::{Force, Motion, Signals};

/// The synchronisation controller of one vehicle.
///
/// The force at the end of a step is that of the errors at its beginning: outputs do not depend
/// on inputs within a step, so a system with it has no algebraic loop.
#[derive(Debug)]
pub struct Synchronisation {
    controller: Controller,
}

impl Model for Synchronisation {
    const IDENTITY: Identity = Identity {
        name: "Hotfoot synchronisation",
        identifier: "synchronisation",
        description: "PID controller that keeps a vehicle where the train model has it",
        default_step: 1e-3,
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
        let Signals { vehicle, train, gains, .. } = Signals::read(signals, values);
        let controller = Controller::new(gains.into());
        let force = controller.force(vehicle.into(), train.into());
        finite(force)?.write(&signals.force, values);
        Ok(Self { controller })
    }

    fn step(
        &mut self,
        signals: &Handles<Signals>,
        values: &mut Values,
        interval: Interval,
        _log: &mut Log,
    ) -> Result<(), ModelError> {
        let vehicle = Motion::read(&signals.vehicle, values);
        let train = Motion::read(&signals.train, values);
        let force = self.controller.step(vehicle.into(), train.into(), interval.length);
        finite(force)?.write(&signals.force, values);
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
fn finite(force: f64) -> Result<Force, ModelError> {
    match force.is_finite() {
        true => Ok(Force { force }),
        false => Err(ModelError::new(format!(
            "sync.force = {force}: the motions of vehicle and train are too far apart"
        ))),
    }
}
