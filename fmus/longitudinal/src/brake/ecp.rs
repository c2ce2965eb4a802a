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
        EcpBrake { dead_time: 0.5, lag: 0.2, build_up_rate: 0.1, release_rate: 0.05 };

    /// The fraction after a time under a command, from a fraction that has long been reached.
    fn after(from: f64, command: f64, time: f64) -> f64 {
        let (mut state, mut cylinder, step) = (EcpState::settled(from), from, 1e-3);
        for _ in 0..(time / step).round() as usize {
            BRAKE.advance(&mut state, &mut cylinder, command, step);
        }
        cylinder
    }

    /// After the dead time of 0.5 s a cylinder fills by 0.1/s and empties by 0.05/s.
    /// Tolerance: two steps of 1 ms.
    #[test]
    fn analytic_dead_time_and_rates() {
        assert_eq!(after(0.2, 1.0, 0.498), 0.2);
        assert!((after(0.2, 1.0, 3.5) - 0.5).abs() < 2e-4);
        assert!((after(0.8, 0.0, 4.5) - 0.6).abs() < 1e-4);
    }

    /// Close to its command the fraction is a first-order lag: what is missing falls by
    /// exp(−t/τ). From 0.5 to 0.51 no rate limits; tolerance the step of 1 ms of 0.2 s.
    #[test]
    fn analytic_a_small_change_is_a_first_order_lag() {
        let missing = 0.51 - after(0.5, 0.51, 0.5 + 0.3);
        assert!((missing / (0.01 * f64::exp(-0.3 / 0.2)) - 1.0).abs() < 0.01, "{missing}");
    }
}
