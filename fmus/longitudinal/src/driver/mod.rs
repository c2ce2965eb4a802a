//! What the driver does, and the file that says it.
//!
//! A driver file has one of these, and any number of `[[profile]]` and `[[remote]]`:
//!
//! | section | the driver | file |
//! |---|---|---|
//! | `[[command]]` | follows a schedule by time or chainage | `schedule.rs` |
//! | `[cruise]` | keeps a speed profile by feed-forward and PID | `cruise.rs` |
//! | `[fuzzy]` | keeps a speed profile by fuzzy rules | `fuzzy.rs` |
//! | `[replay]` | repeats what a locomotive's logger has recorded | `replay.rs` |
//!
//! `[[profile]]` moves one lever by a table over time or chainage, whatever the driver does
//! (`profile.rs`); `[[remote]]` gives a group of locomotives a delay or commands of its own
//! (`remote.rs`). `levers.rs` turns a force into levers for the two that control. `view.rs` is what a
//! driver sees, `state.rs` what changes in a driver.

mod cruise;
mod file;
mod fuzzy;
mod levers;
mod profile;
mod remote;
mod replay;
pub mod schedule;
pub mod state;
pub mod view;

use crate::command::Command;

pub use file::check_groups;
pub use replay::LOGGER_COLUMNS;

use cruise::Cruise;
use fuzzy::Fuzzy;
use profile::Profile;
use remote::{RadioState, Remote};
use replay::Replay;
use schedule::Schedule;
use state::DriverState;
use view::View;

/// A driver with its remote locomotives.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Driver {
    /// Whether the drives and brakes have come to the first command before the run begins.
    pub initially_applied: bool,
    kind: Kind,
    profiles: Vec<Profile>,
    remotes: Vec<Remote>,
}

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Schedule(Schedule),
    Cruise(Cruise),
    Fuzzy(Fuzzy),
    Replay(Replay),
}

impl Default for Kind {
    fn default() -> Self {
        Self::Schedule(Schedule::default())
    }
}

impl Driver {
    /// A driver who follows a schedule.
    pub fn with_schedule(schedule: Schedule) -> Self {
        Self { initially_applied: true, kind: Kind::Schedule(schedule), ..Self::default() }
    }

    /// Whether it opens the throttle at some time, or may do so to keep a speed.
    pub fn pulls(&self) -> bool {
        let by_kind = match &self.kind {
            Kind::Schedule(schedule) => schedule.pulls(),
            Kind::Cruise(_) | Kind::Fuzzy(_) => true,
            Kind::Replay(replay) => replay.pulls(),
        };
        by_kind
            || self.profiles.iter().any(Profile::pulls)
            || self.remotes.iter().any(Remote::pulls)
    }

    /// For how long a logger has recorded what this driver repeats, s; none for other drivers.
    pub fn recorded_time(&self) -> Option<f64> {
        match &self.kind {
            Kind::Replay(replay) => Some(replay.length()),
            _ => None,
        }
    }

    /// Number of the last group of locomotives with a delay or commands of its own; 0 for none.
    pub fn last_group(&self) -> usize {
        self.remotes.iter().map(|remote| remote.group).max().unwrap_or_default()
    }

    /// The state at the beginning of a run.
    pub fn start(&self) -> DriverState {
        DriverState::new(RadioState::new(&self.remotes))
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
                state.add_difference(view.velocity - state.measured_speed, step);
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
