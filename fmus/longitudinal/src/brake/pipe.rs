//! The brake pipe: how a change of the train brake runs along the train.
//!
//! Every group of locomotives vents or fills the pipe where it stands, with the command of its own.
//! The change of the nearest group arrives at a vehicle after its distance at the speed of the wave,
//! which is that of the vehicle's own valve for service, release or emergency (theory, eq. 15b):
//!
//! ```text
//! t_arrival = t_group + |x − x_group|/w
//! ```

use crate::brake::air::AirBrake;
use crate::brake::state::BrakeState;
use crate::command::{Command, EMERGENCY};
use crate::history::History;

/// The group of locomotives that commands a vehicle's air brake.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Source {
    /// Number of the group.
    pub group: usize,
    /// Distance along the pipe, m.
    pub distance: f64,
}

impl Source {
    /// The nearest of the groups, each with its position, to a position in the train, m.
    pub fn nearest(groups: &[(usize, f64)], position: f64) -> Self {
        let sources =
            groups.iter().map(|&(group, at)| Self { group, distance: (at - position).abs() });
        sources.min_by(|a, b| a.distance.total_cmp(&b.distance)).unwrap_or_default()
    }
}

/// Notes what the groups command at a time, s.
pub(crate) fn note(pipe: &mut [History<f64>], commands: &[Command], time: f64) {
    for (group, history) in pipe.iter_mut().enumerate() {
        let command = commands[group.min(commands.len() - 1)].train_brake;
        history.note(time, command, command == EMERGENCY);
    }
}

/// Gives a brake the changes that have arrived at a time, s.
#[inline]
pub(crate) fn arrive(
    air: &AirBrake,
    brake: &mut BrakeState,
    source: Source,
    pipe: &[History<f64>],
    time: f64,
) {
    let Some(history) = pipe.get(source.group) else { return };
    while brake.arrivals < history.count() {
        let (noted, command) = history.change(brake.arrivals);
        if time < noted + source.distance / air.wave(brake.pressure_command, command) {
            break;
        }
        air.set_pressure_command(brake, command);
        brake.arrivals += 1;
    }
}
