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
