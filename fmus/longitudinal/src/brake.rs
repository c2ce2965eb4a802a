//! Electronically controlled pneumatic (ECP) friction brake of a vehicle.
//!
//! All vehicles get the command at once, by cable. After a dead time the cylinder fraction c
//! follows the command u, within the rates of filling and emptying (theory, eq. 15), and the shoes
//! press with the net braking ratio β of the weight (eq. 16):
//!
//! ```text
//! dc/dt = clamp((u − c)/τ, −1/t_release, 1/t_build)      c = 1 full service, 1.2 emergency
//! F = c β m g μ(v)
//! ```
//!
//! The command 1.2 is the emergency level of AAR S-4200. Graduated release, as ECP has it. Retained
//! air and leakage are not modelled.

use numerics::{LinearTable, TableError};
use serde::{Deserialize, Serialize};

use crate::gravity::STANDARD_GRAVITY;

/// Greatest command: emergency.
pub const EMERGENCY: f64 = 1.2;

/// Difference from the command at which the pressure counts as reached.
const REACHED: f64 = 1e-6;

/// Kilometres per hour in a metre per second.
const KMH: f64 = 3.6;

/// Friction brake of one vehicle.
#[derive(Clone, Debug, PartialEq)]
pub struct Brake {
    /// Force of all shoes on the wheels at full service, N.
    shoe_force: f64,
    /// Friction coefficient of the shoes over m/s.
    friction: LinearTable,
    dead_time: f64,
    lag: f64,
    build_up_rate: f64,
    release_rate: f64,
    /// Interval of the last lookup in `friction`.
    index: usize,
}

/// What changes in a brake.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct BrakeState {
    /// Command that the valve follows.
    followed: f64,
    /// Time since the command has become another one, s.
    waited: f64,
    /// Cylinder pressure as a fraction of that at full service.
    cylinder: f64,
}

impl BrakeState {
    /// A brake that has followed `command` for long.
    pub fn settled(command: f64) -> Self {
        Self { followed: command, waited: 0.0, cylinder: command }
    }
}

impl Brake {
    /// The brake of a vehicle.
    ///
    /// # Errors
    /// When its table cannot be used.
    pub fn new(vehicle: &stock::Vehicle) -> Result<Self, TableError> {
        let file = &vehicle.brake;
        let speeds = file.shoe_friction.speed_kmh.iter().map(|v| v / KMH).collect();
        Ok(Self {
            shoe_force: file.net_braking_ratio * vehicle.mass_kg * STANDARD_GRAVITY,
            friction: LinearTable::new(speeds, file.shoe_friction.value.clone())?,
            dead_time: file.dead_time_s,
            lag: file.lag_s,
            build_up_rate: 1.0 / file.build_up_s,
            release_rate: 1.0 / file.release_s,
            index: 0,
        })
    }

    /// Takes the brake over a time `step`, s.
    pub fn advance(&self, state: &mut BrakeState, command: f64, step: f64) {
        if command == state.followed {
            state.waited = 0.0;
        } else {
            state.waited += step;
            if state.waited >= self.dead_time {
                state.followed = command;
                state.waited = 0.0;
            }
        }
        let missing = state.followed - state.cylinder;
        if missing.abs() < REACHED {
            state.cylinder = state.followed;
            return;
        }
        let rate = (missing / self.lag).max(-self.release_rate).min(self.build_up_rate);
        state.cylinder += rate * step;
    }

    /// Greatest force against the motion at a speed, m/s, in N.
    pub fn force(&mut self, state: &BrakeState, speed: f64) -> f64 {
        match state.cylinder {
            0.0 => 0.0,
            cylinder => cylinder * self.shoe_force * self.friction.value(speed, &mut self.index),
        }
    }
}
