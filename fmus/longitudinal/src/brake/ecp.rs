//! Electronically controlled pneumatic (ECP) brake.
//!
//! All vehicles get the command at once, by cable. After a dead time the cylinder fraction c
//! follows the command u, within the rates of filling and emptying (theory, eq. 15):
//!
//! ```text
//! dc/dt = clamp((u − c)/τ, −1/t_release, 1/t_build)
//! ```
//!
//! Graduated release, as ECP has it. Retained air and leakage are not modelled.

use serde::{Deserialize, Serialize};

/// Difference from the command at which the pressure counts as reached.
const REACHED: f64 = 1e-6;

/// ECP brake of one vehicle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EcpBrake {
    dead_time: f64,
    lag: f64,
    build_up_rate: f64,
    release_rate: f64,
}

/// What changes in the valve.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct EcpState {
    /// Command that the valve follows.
    followed: f64,
    /// Time since the command has become another one, s.
    waited: f64,
}

impl EcpState {
    /// A valve that has followed `command` for long.
    pub(crate) fn settled(command: f64) -> Self {
        Self { followed: command, waited: 0.0 }
    }
}

impl EcpBrake {
    /// The brake of a vehicle file.
    pub fn new(file: &stock::Brake) -> Self {
        Self {
            dead_time: file.dead_time_s,
            lag: file.lag_s,
            build_up_rate: 1.0 / file.build_up_s,
            release_rate: 1.0 / file.release_s,
        }
    }

    /// Takes valve and cylinder over a time `step`, s.
    #[inline]
    pub fn advance(&self, state: &mut EcpState, cylinder: &mut f64, command: f64, step: f64) {
        if command == state.followed {
            state.waited = 0.0;
        } else {
            state.waited += step;
            if state.waited >= self.dead_time {
                state.followed = command;
                state.waited = 0.0;
            }
        }
        let missing = state.followed - *cylinder;
        if missing.abs() < REACHED {
            *cylinder = state.followed;
            return;
        }
        let rate = (missing / self.lag).max(-self.release_rate).min(self.build_up_rate);
        *cylinder += rate * step;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BRAKE: EcpBrake =
        EcpBrake { dead_time: 0.5, lag: 2.0, build_up_rate: 0.1, release_rate: 0.05 };

    /// The cylinder after a command has held for a time, s, in steps of 1 ms.
    fn cylinder(from: f64, command: f64, time: f64) -> f64 {
        let (mut state, mut cylinder) = (EcpState::settled(from), from);
        for _ in 0..(time * 1e3).round() as u32 {
            BRAKE.advance(&mut state, &mut cylinder, command, 1e-3);
        }
        cylinder
    }

    /// Full service: nothing for 0.5 s, then 0.1/s until the lag of 2 s asks for less, which is at 0.8,
    /// and the rest as e^(−t/2 s). Tolerance: a step at 0.1/s, and half a step of 2 s in the exponential.
    #[test]
    fn analytic_the_cylinder_fills_at_its_rate_and_then_with_its_lag() {
        assert_eq!(cylinder(0.0, 1.0, 0.498), 0.0);
        assert!((cylinder(0.0, 1.0, 4.5) - 0.4).abs() < 2e-4);
        let expected = 1.0 - 0.2 * (-1.0_f64).exp();
        assert!((cylinder(0.0, 1.0, 0.5 + 8.0 + 2.0) - expected).abs() < 3e-4);
    }

    /// Released at 0.05/s; a command in between is followed by degrees.
    #[test]
    fn analytic_the_cylinder_empties_by_degrees() {
        assert!((cylinder(1.0, 0.0, 10.5) - 0.5).abs() < 2e-4);
        assert!((cylinder(1.0, 0.6, 60.0) - 0.6).abs() < 1e-9);
    }
}
