//! The train as an FMU: its variables set the physics, whose results they show.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use fmu::{Declaration, Identity, Interval, Log, Model, ModelError, Text, Values};
use serde::{Deserialize, Serialize};
use stock::{Consist, Library};
use track::Track;

use crate::command::{Command, EMERGENCY, HIGHEST_NOTCH};
use crate::driver::Driver;
use crate::driver::state::DriverState;
use crate::driver::view::View;
use crate::interface::signals::{self, SCHEDULE, Signals};
use crate::line::wind::Wind;
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

/// The file that a parameter names; without a name, the one in the resources.
fn chosen(name: &str, resources: &Path, default: &str) -> PathBuf {
    match name {
        "" => resources.join(default),
        name => PathBuf::from(name),
    }
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
        let file = |text: Text, default: &str| chosen(&values[text], resources, default);
        let consist_file = file(signals.consist_file, "consist.toml");
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
        let track = Track::from_file(&file(signals.track_file, "track.toml"))
            .map_err(ModelError::from_error)?;
        let driver = Driver::from_file(&file(signals.driver_file, "driver.toml"))
            .map_err(ModelError::from_error)?;
        let mut dynamics = TrainDynamics::from_consist(&consist, &library, track)
            .map_err(ModelError::from_error)?;
        dynamics.check_step().map_err(ModelError::from_error)?;
        dynamics.wind = wind(signals, values);

        let position = values[signals.position];
        let velocity = values[signals.velocity];
        let view = View { time: start_time, chainage: position, velocity, train: None };
        let mut own = driver.start();
        let mut command = driver.command(&mut own, &view, 0.0);
        override_by_inputs(signals, values, &mut command)?;
        let groups = dynamics.groups().max(driver.last_group() + 1);
        let train = dynamics.start(&Start {
            position,
            velocity,
            couplers: match values[signals.couplers] {
                0 => Couplers::Unstressed,
                _ => Couplers::InBalance,
            },
            applied: match driver.initially_applied {
                true => command,
                false => Command::default(),
            },
        });
        let state = State { train, driver: own, commands: vec![command; groups] };
        values[signals.train.mass] = dynamics.mass();
        values[signals.train.length] = dynamics.length();
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
        override_by_inputs(signals, values, &mut commands[0])?;
        self.driver.pass_on(driver, &view, commands);
        self.dynamics.wind = wind(signals, values);
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

/// The wind of the inputs.
fn wind(signals: &Signals, values: &Values) -> Wind {
    Wind { speed: values[signals.wind_speed], direction: values[signals.wind_direction] }
}

/// Replaces what the driver asks for by the inputs that are set.
fn override_by_inputs(
    signals: &Signals,
    values: &Values,
    command: &mut Command,
) -> Result<(), ModelError> {
    let input = &signals.driver[0];
    let overrides = [
        ("notch", input.notch, HIGHEST_NOTCH, &mut command.notch),
        ("dynamic_brake", input.dynamic_brake, 1.0, &mut command.dynamic_brake),
        ("train_brake", input.train_brake, EMERGENCY, &mut command.train_brake),
        ("locomotive_brake", input.locomotive_brake, 1.0, &mut command.locomotive_brake),
    ];
    for (name, handle, greatest, asked) in overrides {
        let value = values[handle];
        if (0.0..=greatest).contains(&value) {
            *asked = value;
        } else if value != SCHEDULE {
            return Err(ModelError::new(format!(
                "driver.{name} = {value}: must lie between 0 and {greatest}, \
                 or be {SCHEDULE} to follow the driver file"
            )));
        }
    }
    Ok(())
}

impl Train {
    /// Writes the outputs.
    fn show(&self, signals: &Signals, values: &mut Values) {
        let State { train, driver, commands } = &self.state;
        let command = &commands[0];

        let in_force = &signals.driver[1];
        values[in_force.notch] = command.notch;
        values[in_force.dynamic_brake] = command.dynamic_brake;
        values[in_force.train_brake] = command.train_brake;
        values[in_force.locomotive_brake] = command.locomotive_brake;
        values[signals.control.target_speed] = driver.target_speed;
        values[signals.control.measured_speed] = driver.measured_speed;
        values[signals.control.speed_rms] = driver.speed_rms();

        let totals = self.dynamics.totals(train);
        values[signals.train.velocity] = totals.velocity;
        values[signals.train.traction] = totals.traction;
        values[signals.train.brake] = totals.brake;
        values[signals.train.resistance] = totals.resistance;
        values[signals.train.curve_resistance] = totals.curve_resistance;
        values[signals.train.gravity] = totals.gravity;
        values[signals.train.greatest_tension] = totals.greatest_tension;
        values[signals.train.greatest_buff] = totals.greatest_buff;

        let vehicles = &signals.vehicles;
        let energy = self.dynamics.energy_and_heat(train, |k, front, rear| {
            values[vehicles[k].gear_heat[1]] = front;
            values[vehicles[k + 1].gear_heat[0]] = rear;
        });
        values[signals.energy.traction] = train.work.traction;
        values[signals.energy.dynamic_brake] = train.work.dynamic_brake;
        values[signals.energy.brake] = train.work.brake;
        values[signals.energy.resistance] = train.work.resistance;
        values[signals.energy.curve_resistance] = train.work.curve_resistance;
        values[signals.energy.gears] = self.dynamics.gear_dissipation(train, &energy);
        values[signals.energy.kinetic] = energy.kinetic;
        values[signals.energy.potential] = energy.potential;
        values[signals.energy.stored] = energy.stored;
        values[signals.energy.residual] = self.dynamics.energy_residual(train, &energy);

        let vehicles = self.dynamics.vehicles().iter().zip(&train.vehicles);
        for ((vehicle, state), signals) in vehicles.zip(&signals.vehicles) {
            let forces = &state.forces;
            let share = forces.friction_share(state.velocity);
            values[signals.position] = state.position;
            values[signals.velocity] = state.velocity;
            values[signals.acceleration] = vehicle.acceleration_by(forces, share);
            values[signals.coupler_front] = forces.coupler_front;
            values[signals.coupler_rear] = forces.coupler_rear;
            values[signals.resistance] = share * forces.resistance + forces.wind;
            values[signals.curve_resistance] = share * forces.curve_resistance;
            values[signals.traction] = forces.traction;
            values[signals.brake] = forces.brake;
            values[signals.wheel_brake_power] = vehicle.wheel_brake_power(state);
        }
    }
}
