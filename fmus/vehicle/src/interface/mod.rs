//! The model as an FMU.
//!
//! | file | part |
//! |---|---|
//! | `signals/` | its variables |

mod signals;

use std::borrow::Cow;
use std::path::Path;

use fmu::{Declaration, Identity, Interval, Log, Model, ModelError, Values, Variables};
use nalgebra::Vector3;
use stock::Library;

pub use self::signals::Signals;
use self::signals::{Start, VEHICLE_FILE};
use crate::compile::multibody;
use crate::contact::{Standing, WheelOutput};
use crate::dynamics::{Dynamics, LONGEST_STEP, State};
use crate::structure::Structure;
use crate::track::Line;

/// A railway vehicle in three dimensions.
pub struct Vehicle {
    dynamics: Dynamics,
    /// How each wheel stood when it was last reported.
    reported: Vec<[Standing; 2]>,
}

impl Model for Vehicle {
    const IDENTITY: Identity = Identity {
        name: "Hotfoot vehicle",
        identifier: "vehicle",
        description: "One railway vehicle in three dimensions: bodies on springs and dampers, and \
                      the contact of every wheel with its rail",
        default_step: LONGEST_STEP,
    };

    type Signals = Signals;
    type State = State;

    fn declare(resources: &Path, declaration: &mut Declaration) -> Result<Signals, ModelError> {
        let vehicle = read_vehicle(&resources.join(VEHICLE_FILE))?;
        let multibody = multibody(&vehicle).map_err(ModelError::from_error)?;
        Ok(Signals::declare(declaration, multibody))
    }

    fn initialize(
        signals: &Signals,
        values: &mut Values,
        resources: &Path,
        _start_time: f64,
        log: &mut Log,
    ) -> Result<Self, ModelError> {
        let start = Start::read(&signals.start, values);
        let Start { position, velocity, .. } = start;
        let vehicle_file = start.vehicle_file.path(resources);
        let vehicle = read_vehicle(&vehicle_file)?;
        let structure = Structure::shared(&vehicle)
            .map_err(|error| ModelError::new(format!("{}: {error}", vehicle_file.display())))?;
        check_shape(&structure, signals, &vehicle.name)?;
        let line =
            Line::shared(&start.track_file.path(resources)).map_err(ModelError::from_error)?;
        let inputs = signals.read(values);

        let mut dynamics = Dynamics::new(structure, line);
        let equilibrium = dynamics.start(position, velocity, &inputs);
        if !equilibrium.reached {
            log.warning(format!(
                "the vehicle does not start in equilibrium at {position} m and {velocity} m/s: \
                 an acceleration of {:.2e} m/s2 is left",
                equilibrium.residual
            ));
        }
        let mut vehicle =
            Self { reported: vec![[Standing::OnRail; 2]; dynamics.wheels.len()], dynamics };
        vehicle.check_numbers()?;
        vehicle.report_wheels(log);
        let along = Vector3::x() * vehicle.dynamics.acceleration;
        signals.write(&vehicle.dynamics, less_gravity(&vehicle.dynamics, along), values);
        Ok(vehicle)
    }

    fn step(
        &mut self,
        signals: &Signals,
        values: &mut Values,
        interval: Interval,
        log: &mut Log,
    ) -> Result<(), ModelError> {
        let inputs = signals.read(values);
        let steps = steps(interval.length, self.dynamics.longest_step());
        let length = interval.length / f64::from(steps);
        let mut rate = Vector3::zeros();
        for _ in 0..steps {
            let before = self.dynamics.state.bodies[0].velocity;
            self.dynamics.step(length, &inputs);
            rate = (self.dynamics.state.bodies[0].velocity - before) / length;
        }
        self.check_numbers()?;
        self.report_wheels(log);
        signals.write(&self.dynamics, less_gravity(&self.dynamics, rate), values);
        Ok(())
    }

    fn state(&self) -> Cow<'_, State> {
        Cow::Borrowed(&self.dynamics.state)
    }

    fn restore(&mut self, state: State) {
        self.dynamics.restore(state);
    }
}

impl Vehicle {
    /// Ends the run when a position, force or power is no finite number.
    fn check_numbers(&self) -> Result<(), ModelError> {
        let dynamics = &self.dynamics;
        let broken = |wheels: &[WheelOutput; 2]| {
            wheels
                .iter()
                .any(|wheel| !(wheel.total.force.normal + wheel.total.friction_power).is_finite())
        };
        let position = dynamics.position();
        match dynamics.wheels.iter().position(broken) {
            None if position.is_finite() => Ok(()),
            found => Err(ModelError::new(format!(
                "the motion has no finite numbers any more (wheelset[{}], chainage {position:.2} m, \
                 {:.2} m/s): look for forces that are far too large, or an unstable element",
                found.map_or(1, |i| i + 1),
                dynamics.velocity()
            ))),
        }
    }

    /// Warns when a wheel loses its contact, leaves the profiles or is back.
    fn report_wheels(&mut self, log: &mut Log) {
        let dynamics = &self.dynamics;
        for (i, (wheels, before)) in dynamics.wheels.iter().zip(&mut self.reported).enumerate() {
            for ((wheel, before), side) in wheels.iter().zip(before).zip(["left", "right"]) {
                if wheel.standing == *before {
                    continue;
                }
                *before = wheel.standing;
                let what = match wheel.standing {
                    Standing::OnRail => "is back on its rail",
                    Standing::Lifted => "has lost contact with its rail",
                    Standing::Derailed => "has left the rail: it climbed over it or fell off it",
                };
                log.warning(format!(
                    "wheelset[{}].{side} {what} at chainage {:.2} m and {:.2} m/s",
                    i + 1,
                    dynamics.position(),
                    dynamics.velocity()
                ));
            }
        }
    }
}

/// Acceleration less gravity of the first body, m/s² (eq. 41); `rate` is that of its velocity in its
/// frame.
fn less_gravity(dynamics: &Dynamics, rate: Vector3<f64>) -> Vector3<f64> {
    let (body, state) = (&dynamics.structure.bodies[0], &dynamics.state.bodies[0]);
    rate - state.frame_forces(body, &dynamics.scratch.frames[0]).force / body.mass
}

/// Number of equal steps in an interval, each at most `longest` long.
fn steps(length: f64, longest: f64) -> u32 {
    // An interval of 1 ms computed from two times may be longer by rounding.
    (length / longest - 1e-6).ceil().max(1.0) as u32
}

fn read_vehicle(file: &Path) -> Result<stock::Vehicle, ModelError> {
    let library = Library::of(file).map_err(ModelError::from_error)?;
    library.vehicle_from_file(file).map_err(ModelError::from_error)
}

/// Another vehicle file must not change the interface.
fn check_shape(structure: &Structure, signals: &Signals, name: &str) -> Result<(), ModelError> {
    let wheelsets = structure.wheelsets.len();
    let bodies = structure.bodies.len() - wheelsets;
    match signals.shape() {
        shape if shape == [wheelsets, bodies] => Ok(()),
        [declared, shown] => Err(ModelError::new(format!(
            "vehicle_file: vehicle \"{name}\" has {wheelsets} wheelsets and {bodies} bodies, but \
             this FMU was made for {declared} and {shown}; pack an FMU for that vehicle"
        ))),
    }
}
