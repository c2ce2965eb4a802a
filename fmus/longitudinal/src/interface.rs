//! The train as an FMU: the way from its variables to the physics and back.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use fmu::{Declaration, Identity, Interval, Log, Model, ModelError, Text, Values};
use serde::{Deserialize, Serialize};
use stock::{Consist, Library};
use track::Track;

use crate::brake::EMERGENCY;
use crate::driver::{Command, Schedule};
use crate::signals::{self, SCHEDULE, Signals};
use crate::start::{Couplers, Start};
use crate::traction::HIGHEST_NOTCH;
use crate::train::{TrainDynamics, TrainState};

/// The longitudinal train as an FMU.
#[derive(Debug)]
pub struct Train {
    dynamics: TrainDynamics,
    schedule: Schedule,
    state: State,
}

/// What an FMU state of the train saves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// The train.
    pub train: TrainState,
    /// Number of commands of the schedule whose time or place has come.
    pub reached: usize,
    /// Command in force.
    pub command: Command,
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
        let schedule = Schedule::from_file(&file(signals.driver_file, "driver.toml"))
            .map_err(ModelError::from_error)?;
        let mut dynamics = TrainDynamics::from_consist(&consist, &library, track)
            .map_err(ModelError::from_error)?;

        let mut reached = 0;
        let position = values[signals.position];
        let command = command(signals, values, &schedule, &mut reached, start_time, position)?;
        let state = dynamics.start(&Start {
            position,
            velocity: values[signals.velocity],
            couplers: match values[signals.couplers] {
                0 => Couplers::Unstressed,
                _ => Couplers::InBalance,
            },
            applied: match schedule.initially_applied {
                true => command,
                false => Command::default(),
            },
        });
        let state = State { train: state, reached, command };
        values[signals.train.mass] = dynamics.mass();
        values[signals.train.length] = dynamics.length();
        let train = Self { dynamics, schedule, state };
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
        let state = &mut self.state;
        let leader = state.train.vehicles[0].position;
        state.command =
            command(signals, values, &self.schedule, &mut state.reached, interval.start, leader)?;
        self.dynamics.advance(&mut state.train, &state.command, interval.length);
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

/// The command of the schedule, with what the inputs override.
fn command(
    signals: &Signals,
    values: &Values,
    schedule: &Schedule,
    reached: &mut usize,
    time: f64,
    chainage: f64,
) -> Result<Command, ModelError> {
    let mut command = schedule.command(reached, time, chainage);
    let input = &signals.driver[0];
    let overrides = [
        ("notch", input.notch, HIGHEST_NOTCH, &mut command.notch),
        ("dynamic_brake", input.dynamic_brake, 1.0, &mut command.dynamic_brake),
        ("train_brake", input.train_brake, EMERGENCY, &mut command.train_brake),
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
    Ok(command)
}

impl Train {
    /// Writes the outputs.
    fn show(&self, signals: &Signals, values: &mut Values) {
        let State { train, command, .. } = &self.state;

        let in_force = &signals.driver[1];
        values[in_force.notch] = command.notch;
        values[in_force.dynamic_brake] = command.dynamic_brake;
        values[in_force.train_brake] = command.train_brake;

        let totals = self.dynamics.totals(train);
        values[signals.train.velocity] = totals.velocity;
        values[signals.train.traction] = totals.traction;
        values[signals.train.brake] = totals.brake;
        values[signals.train.resistance] = totals.resistance;
        values[signals.train.curve_resistance] = totals.curve_resistance;
        values[signals.train.gravity] = totals.gravity;
        values[signals.train.greatest_tension] = totals.greatest_tension;
        values[signals.train.greatest_buff] = totals.greatest_buff;

        let energy = self.dynamics.energy(train);
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

        for (i, signals) in signals.vehicles.iter().enumerate() {
            let state = &train.vehicles[i];
            let forces = &state.forces;
            let share = forces.friction_share(state.velocity);
            values[signals.position] = state.position;
            values[signals.velocity] = state.velocity;
            values[signals.acceleration] = self.dynamics.vehicles()[i].acceleration(state);
            values[signals.coupler_front] = forces.coupler_front;
            values[signals.coupler_rear] = forces.coupler_rear;
            values[signals.resistance] = share * forces.resistance;
            values[signals.curve_resistance] = share * forces.curve_resistance;
            values[signals.traction] = forces.traction;
            values[signals.brake] = forces.brake;
        }
    }
}
