//! What the driver does, and the file that says it.
//!
//! A driver file has one of these, and any number of `[[profile]]` and `[[remote]]`:
//!
//! | section | the driver | file |
//! |---|---|---|
//! | `[[command]]` | follows a schedule by time or place | `schedule.rs` |
//! | `[cruise]` | keeps a speed profile by feed-forward and PID | `cruise.rs` |
//! | `[fuzzy]` | keeps a speed profile by fuzzy rules | `fuzzy.rs` |
//! | `[replay]` | repeats what a locomotive's logger has recorded | `replay.rs` |
//!
//! `[[profile]]` moves one lever by a table over time or place, whatever the driver does
//! (`profile.rs`); `[[remote]]` gives a group of locomotives a delay or commands of its own
//! (`remote.rs`). `levers.rs` turns a force into levers for the two that control.

mod cruise;
mod file;
mod fuzzy;
mod levers;
mod profile;
mod remote;
mod replay;
mod schedule;

use serde::{Deserialize, Serialize};

use crate::drive::traction::HIGHEST_NOTCH;
use crate::train::dynamics::{TrainDynamics, TrainState};

pub use levers::LeverState;
pub use remote::RadioState;
pub use schedule::Schedule;

/// What the driver asks for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Command {
    /// Notch, 0 (idle) to 8; between two notches the drive is between them.
    pub notch: f64,
    /// Dynamic brake as a share of full effort; takes traction away.
    pub dynamic_brake: f64,
    /// Train brake: 1 is full service, 1.2 emergency.
    pub train_brake: f64,
    /// Brake of the locomotives alone, 1 is full.
    pub locomotive_brake: f64,
}

impl Command {
    /// The place that the levers of the locomotives go to (see [`crate::drive::lever`]).
    pub fn lever(&self) -> f64 {
        match self.dynamic_brake > 0.0 {
            true => -self.dynamic_brake,
            false => self.notch / HIGHEST_NOTCH,
        }
    }
}

/// What the driver sees.
#[derive(Clone, Copy, Debug)]
pub struct View<'a> {
    /// Time, s.
    pub time: f64,
    /// Chainage of the leading vehicle's middle, m.
    pub chainage: f64,
    /// Velocity of the leading vehicle, m/s.
    pub velocity: f64,
    /// The train and its state; none before the run begins.
    pub train: Option<(&'a TrainDynamics, &'a TrainState)>,
}

/// A driver with its remote locomotives.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Driver {
    /// Whether the drives and brakes have come to the first command before the run begins.
    pub initially_applied: bool,
    kind: Kind,
    profiles: Vec<profile::Profile>,
    remotes: Vec<remote::Remote>,
}

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Schedule(Schedule),
    Cruise(cruise::Cruise),
    Fuzzy(fuzzy::Fuzzy),
    Replay(replay::Replay),
}

impl Default for Kind {
    fn default() -> Self {
        Self::Schedule(Schedule::default())
    }
}

/// What changes in a driver.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DriverState {
    /// Number of commands of the schedule whose time or place has come.
    pub reached: usize,
    /// Hands of a driver who controls the speed.
    pub levers: LeverState,
    /// Speed that the driver keeps to, m/s; zero without one.
    pub target_speed: f64,
    /// Speed that the logger has measured, m/s; zero without one.
    pub measured_speed: f64,
    /// Integral of the squared difference from the measured speed, m²/s, and its time, s.
    squares: (f64, f64),
    /// What the remote groups have received.
    pub radio: RadioState,
}

impl DriverState {
    /// Root mean square of the difference between simulated and measured speed so far, m/s.
    pub fn speed_rms(&self) -> f64 {
        match self.squares.1 > 0.0 {
            true => (self.squares.0 / self.squares.1).sqrt(),
            false => 0.0,
        }
    }
}

impl Driver {
    /// A driver who follows a schedule.
    pub fn with_schedule(schedule: Schedule) -> Self {
        Self { initially_applied: true, kind: Kind::Schedule(schedule), ..Self::default() }
    }

    /// Number of the last group of locomotives with a delay or commands of its own; 0 for none.
    pub fn last_group(&self) -> usize {
        self.remotes.iter().map(|remote| remote.group).max().unwrap_or_default()
    }

    /// The state at the beginning of a run.
    pub fn start(&self) -> DriverState {
        DriverState { radio: RadioState::new(&self.remotes), ..DriverState::default() }
    }

    /// The command of the leading locomotives over the next `step`, s.
    pub fn command(&self, state: &mut DriverState, view: &View, step: f64) -> Command {
        let mut command = match &self.kind {
            Kind::Schedule(schedule) => {
                schedule.command(&mut state.reached, view.time, view.chainage)
            }
            Kind::Cruise(cruise) => cruise.command(state, view),
            Kind::Fuzzy(fuzzy) => fuzzy.command(state, view),
            Kind::Replay(replay) => {
                state.measured_speed = replay.speed(view.time);
                let difference = view.velocity - state.measured_speed;
                state.squares.0 += difference * difference * step;
                state.squares.1 += step;
                replay.command(view.time)
            }
        };
        for profile in &self.profiles {
            profile.apply(&mut command, view);
        }
        command
    }

    /// The commands of all groups, that of the leading one first and given, over the next step.
    pub fn pass_on(&self, state: &mut DriverState, view: &View, commands: &mut [Command]) {
        let leading = commands[0];
        commands[1..].fill(leading);
        state.radio.send(view.time, leading);
        for (i, remote) in self.remotes.iter().enumerate() {
            commands[remote.group] = remote.command(&mut state.radio, i, view);
        }
    }
}
