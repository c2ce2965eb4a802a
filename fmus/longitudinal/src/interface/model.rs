//! The train as an FMU: its variables set the physics, whose results they show.

use std::borrow::Cow;
use std::path::Path;

use fmu::{Declaration, Identity, Interval, Log, Model, ModelError, Values, Variables};
use serde::{Deserialize, Serialize};
use stock::{Consist, Library};
use track::Track;

use crate::command::Command;
use crate::driver::Driver;
use crate::driver::state::DriverState;
use crate::driver::view::View;
use crate::interface::signals::{
    self, DriverSpeeds, EnergyOutputs, InForce, Initial, Overrides, Signals, TrainOutputs,
    TrainSignals, TrainSize, VehicleOutputs, WindInputs,
};
use crate::train::dynamics::{TrainDynamics, TrainState};
use crate::train::start::{Couplers, Start};

/// The longitudinal train as an FMU.
#[derive(Debug)]
pub struct Train {
    dynamics: TrainDynamics,
    driver: Driver,
    state: State,
}

/// What an FMU state of the train saves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// The train.
    pub train: TrainState,
    /// The driver.
    pub driver: DriverState,
    /// Commands in force of each group of locomotives, the leading one first.
    pub commands: Vec<Command>,
}

impl Model for Train {
    const IDENTITY: Identity = Identity {
        name: "Longitudinal train",
        identifier: "longitudinal",
        description: "Longitudinal dynamics of a train with draft gears, drives and brakes",
        default_step: 1e-3,
    };

    type Signals = Signals;
    type State = State;

    fn declare(resources: &Path, declaration: &mut Declaration) -> Result<Signals, ModelError> {
        signals::declare(resources, declaration)
    }

    fn initialize(
        signals: &Signals,
        values: &mut Values,
        resources: &Path,
        start_time: f64,
        _log: &mut Log,
    ) -> Result<Self, ModelError> {
        let TrainSignals { files, initial, driver: inputs, wind, .. } =
            TrainSignals::read(&signals.train, values);
        let consist_file = files.consist.path(resources);
        let consist = Consist::from_file(&consist_file).map_err(ModelError::from_error)?;
        if consist.types.len() != signals.vehicles.len() {
            return Err(ModelError::new(format!(
                "{}: has {} vehicles, but this FMU was packed for {}; pack one for this consist",
                consist_file.display(),
                consist.types.len(),
                signals.vehicles.len()
            )));
        }
        let library = Library::open(resources.join("stock")).map_err(ModelError::from_error)?;
        let track =
            Track::from_file(&files.track.path(resources)).map_err(ModelError::from_error)?;
        let driver =
            Driver::from_file(&files.driver.path(resources)).map_err(ModelError::from_error)?;
        let mut dynamics = TrainDynamics::from_consist(&consist, &library, track)
            .map_err(ModelError::from_error)?;
        dynamics.check_step().map_err(ModelError::from_error)?;
        dynamics.wind = wind.into();

        let Initial { position, velocity, couplers } = initial;
        let view = View { time: start_time, chainage: position, velocity, train: None };
        let mut own = driver.start();
        let mut command = driver.command(&mut own, &view, 0.0);
        inputs.overrides.apply(&mut command)?;
        let groups = dynamics.groups().max(driver.last_group() + 1);
        let train = dynamics.start(&Start {
            position,
            velocity,
            couplers: match couplers {
                0 => Couplers::Unstressed,
                _ => Couplers::InBalance,
            },
            applied: match driver.initially_applied {
                true => command,
                false => Command::default(),
            },
        });
        let state = State { train, driver: own, commands: vec![command; groups] };
        TrainSize { mass: dynamics.mass(), length: dynamics.length() }
            .write(&signals.train.size, values);
        let train = Self { dynamics, driver, state };
        train.show(signals, values);
        Ok(train)
    }

    fn step(
        &mut self,
        signals: &Signals,
        values: &mut Values,
        interval: Interval,
        _log: &mut Log,
    ) -> Result<(), ModelError> {
        let State { train, driver, commands } = &mut self.state;
        let (time, leader) = (interval.start, &train.vehicles[0]);
        let view = View {
            time,
            chainage: leader.position,
            velocity: leader.velocity,
            train: Some((&self.dynamics, train)),
        };
        commands[0] = self.driver.command(driver, &view, interval.length);
        let inputs = &signals.train;
        Overrides::read(&inputs.driver.overrides, values).apply(&mut commands[0])?;
        self.driver.pass_on(driver, &view, commands);
        self.dynamics.wind = WindInputs::read(&inputs.wind, values).into();
        self.dynamics.advance_groups(train, commands, interval.length);
        self.show(signals, values);
        Ok(())
    }

    fn state(&self) -> Cow<'_, State> {
        Cow::Borrowed(&self.state)
    }

    fn restore(&mut self, state: State) {
        self.state = state;
    }
}

impl Train {
    /// Writes the outputs.
    fn show(&self, signals: &Signals, values: &mut Values) {
        let State { train, driver, commands } = &self.state;
        let dynamics = &self.dynamics;
        InForce::from(commands[0]).write(&signals.train.driver.in_force, values);
        DriverSpeeds {
            target: driver.target_speed,
            measured: driver.measured_speed,
            rms_difference: driver.speed_rms(),
        }
        .write(&signals.train.driver.speed, values);

        let totals = dynamics.totals(train);
        TrainOutputs {
            velocity: totals.velocity,
            traction: totals.traction,
            brake: totals.brake,
            resistance: totals.resistance,
            curve_resistance: totals.curve_resistance,
            gravity: totals.gravity,
            greatest_tension: totals.greatest_tension,
            greatest_buff: totals.greatest_buff,
        }
        .write(&signals.train.totals, values);

        let vehicles = &signals.vehicles;
        let energy = dynamics.energy_and_heat(train, |k, front, rear| {
            values[vehicles[k].gears[1].heat] = front;
            values[vehicles[k + 1].gears[0].heat] = rear;
        });
        EnergyOutputs {
            traction: train.work.traction,
            dynamic_brake: train.work.dynamic_brake,
            brake: train.work.brake,
            resistance: train.work.resistance,
            curve_resistance: train.work.curve_resistance,
            draft_gears: dynamics.gear_dissipation(train, &energy),
            kinetic: energy.kinetic,
            potential: energy.potential,
            stored: energy.stored,
            residual: dynamics.energy_residual(train, &energy),
        }
        .write(&signals.train.energy, values);

        let vehicles = dynamics.vehicles().iter().zip(&train.vehicles);
        for ((vehicle, state), handles) in vehicles.zip(&signals.vehicles) {
            let forces = &state.forces;
            let share = forces.friction_share(state.velocity);
            VehicleOutputs {
                position: state.position,
                velocity: state.velocity,
                acceleration: vehicle.acceleration_by(forces, share),
                coupler_front: forces.coupler_front,
                coupler_rear: forces.coupler_rear,
                resistance: share * forces.resistance + forces.wind,
                curve_resistance: share * forces.curve_resistance,
                traction: forces.traction,
                brake: forces.brake,
                wheel_brake_power: vehicle.wheel_brake_power(state),
            }
            .write(&handles.motion_and_forces, values);
        }
    }
}
