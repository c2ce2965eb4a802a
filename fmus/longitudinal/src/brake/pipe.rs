//! The brake pipe: how a change of the train brake runs along the train.
//!
//! Every group of locomotives vents or fills the pipe where it stands, with the command of its own.
//! A vehicle hears the change of the group that is nearest after the way between them at the speed
//! of the wave, which is that of its own valve for service, release or emergency (theory, eq. 15b):
//!
//! ```text
//! t_heard = t_group + |x − x_group|/w
//! ```

use std::sync::Arc;

use crate::brake::friction_brake::EMERGENCY;
use crate::driver::Command;
use crate::history::History;
use crate::train::member::Member;
use crate::train::vehicle::Vehicle;
use crate::train::vehicle_state::VehicleState;

/// What a vehicle's brake listens to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Source {
    /// Number of the group.
    pub group: usize,
    /// Way along the pipe, m.
    pub distance: f64,
}

/// The nearest source of each vehicle; groups are those of the vehicles with traction, and the head
/// of the train where there are none.
pub(crate) fn sources(vehicles: &[Arc<Vehicle>], members: &[Member]) -> Vec<Source> {
    let mut middle = 0.0;
    let middles: Vec<f64> = vehicles
        .iter()
        .map(|vehicle| {
            middle += vehicle.length;
            middle - vehicle.length / 2.0
        })
        .collect();
    let controls: Vec<(usize, f64)> = vehicles
        .iter()
        .zip(members)
        .zip(&middles)
        .filter(|((vehicle, _), _)| vehicle.has_traction())
        .map(|((_, member), middle)| (member.group, *middle))
        .collect();
    let head = [(0, middles.first().copied().unwrap_or_default())];
    let controls = if controls.is_empty() { &head[..] } else { &controls };
    let nearest = |middle: f64| {
        let sources =
            controls.iter().map(|&(group, at)| Source { group, distance: (at - middle).abs() });
        sources.min_by(|a, b| a.distance.total_cmp(&b.distance)).unwrap_or_default()
    };
    middles.into_iter().map(nearest).collect()
}

/// Histories of the groups' train brakes, long enough for the farthest vehicle; none when no vehicle
/// listens to the pipe.
pub(crate) fn histories(
    vehicles: &[Arc<Vehicle>],
    members: &[Member],
    commands: &[Command],
) -> Vec<History<f64>> {
    let delays = vehicles.iter().zip(members).filter_map(|(vehicle, member)| {
        vehicle.brake.air().map(|air| member.source.distance / air.slowest_wave())
    });
    match delays.reduce(f64::max) {
        None => vec![],
        Some(longest) => {
            let groups = members.iter().map(|member| member.group).max().unwrap_or_default() + 1;
            let of = |group: usize| commands[group.min(commands.len() - 1)].train_brake;
            (0..groups).map(|group| History::new(longest, of(group))).collect()
        }
    }
}

/// Notes what the groups command at a time, s.
pub(crate) fn note(pipe: &mut [History<f64>], commands: &[Command], time: f64) {
    for (group, history) in pipe.iter_mut().enumerate() {
        let command = commands[group.min(commands.len() - 1)].train_brake;
        history.note(time, command, command == EMERGENCY);
    }
}

/// Lets a vehicle hear what has come to it at a time, s.
#[inline]
pub(crate) fn listen(
    vehicle: &Vehicle,
    member: &Member,
    state: &mut VehicleState,
    pipe: &[History<f64>],
    time: f64,
) {
    let Some(air) = vehicle.brake.air() else { return };
    let (brake, Source { group, distance }) = (&mut state.brake, member.source);
    let Some(history) = pipe.get(group) else { return };
    while brake.heard_count < history.count() {
        let (noted, command) = history.change(brake.heard_count);
        if time < noted + distance / air.wave(brake.heard, command) {
            break;
        }
        air.hear(brake, command);
        brake.heard_count += 1;
    }
}
