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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_the_nearest_group_commands() {
        let groups = [(0, 10.0), (1, 700.0)];
        let source = |position| Source::nearest(&groups, position);
        assert_eq!(source(10.0), Source { group: 0, distance: 0.0 });
        assert_eq!(source(300.0), Source { group: 0, distance: 290.0 });
        assert_eq!(source(400.0), Source { group: 1, distance: 300.0 });
    }

    /// The air brake of 300, 200 and 150 m/s for service, release and emergency.
    fn air() -> AirBrake {
        let curve =
            |end: f64| stock::FractionByTime { time_s: vec![0.0, end], fraction: vec![0.0, 1.0] };
        AirBrake::new(&stock::AirBrake {
            service_wave_m_per_s: 300.0,
            release_wave_m_per_s: 200.0,
            emergency_wave_m_per_s: 150.0,
            build_up: curve(5.0),
            emergency_build_up: curve(4.0),
            release: curve(20.0),
            graduated_release: false,
            reservoir: None,
        })
    }

    /// A change at 10 s arrives at a vehicle 600 m away after 600 m over the speed of its wave.
    #[test]
    fn analytic_a_change_arrives_after_its_distance_at_the_speed_of_the_wave() {
        for (from, to, arrival) in [(0.0, 0.5, 12.0), (0.5, 0.2, 13.0), (0.5, EMERGENCY, 14.0)] {
            let mut pipe = [History::new(10.0, from)];
            let command = Command { train_brake: to, ..Command::default() };
            note(&mut pipe, &[command], 10.0);
            let mut brake = BrakeState::settled(from, 0.0);
            brake.arrivals = 1;
            let source = Source { group: 0, distance: 600.0 };
            arrive(&air(), &mut brake, source, &pipe, arrival - 1e-9);
            assert_eq!(brake.pressure_command, from, "{from} to {to}");
            arrive(&air(), &mut brake, source, &pipe, arrival + 1e-9);
            assert_eq!((brake.pressure_command, brake.arrivals), (to, 2), "{from} to {to}");
        }
    }
}
