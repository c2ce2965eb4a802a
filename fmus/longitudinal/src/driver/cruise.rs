//! A driver who keeps a speed profile by feed-forward and PID.
//!
//! The feed-forward is the force balance of the train where it will be after the time of preview:
//! propulsion and curve resistance less gravity of every vehicle, and the acceleration of the
//! profile there. On it comes a PID controller of the speed (theory, eq. 19):
//!
//! ```text
//! F = Σ (R_j + R_c,j − G_j)(x_j + v t_p) + M (v dv*/dx + k_p e + k_i ∫ e dt − k_d a)      e = v* − v
//! ```
//!
//! The integral waits while the levers cannot give what is wanted (anti-windup).
//!
//! ```toml
//! [speed]                      # of the leading vehicle's middle, linear between the points
//! chainage_m = [0.0, 5000.0]
//! kmh = [60.0, 60.0]
//! [cruise]                     # these are the defaults
//! proportional_per_s = 0.05
//! integral_per_s2 = 0.0005
//! derivative = 0.0
//! preview_s = 10.0
//! ```

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

use super::levers::Levers;
use super::state::DriverState;
use super::view::View;
use crate::command::Command;
use numerics::LinearTable;
use numerics::constants::KILOMETRES_PER_HOUR;

/// Distance over which the slope of the profile is taken, m.
const SLOPE_OVER: f64 = 1.0;

/// A driver who keeps a speed profile.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Cruise {
    pub(super) gains: Gains,
    pub(super) speed: LinearTable,
    pub(super) levers: Levers,
}

/// Section `[cruise]`.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(super) struct Gains {
    /// Lever for an error of the speed, 1/s over 1 m/s.
    proportional_per_s: f64,
    /// Lever for its integral.
    integral_per_s2: f64,
    /// Lever for its derivative.
    derivative: f64,
    /// How far the controller looks ahead, s.
    preview_s: f64,
}

impl Default for Gains {
    fn default() -> Self {
        Self { proportional_per_s: 0.05, integral_per_s2: 0.0005, derivative: 0.0, preview_s: 10.0 }
    }
}

/// Section `[speed]`: the speed to keep, by the chainage of the leading vehicle's middle.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct SpeedFile {
    /// Chainages, rising, m.
    chainage_m: Vec<f64>,
    /// Speeds there, km/h.
    kmh: Vec<f64>,
}

impl SpeedFile {
    pub(super) fn compile(&self, check: &Check) -> Result<LinearTable, Mistake> {
        for (i, &speed) in self.kmh.iter().enumerate() {
            check.between(&format!("kmh[{}]", i + 1), speed, 0.0, 500.0)?;
        }
        check.rising("chainage_m", &self.chainage_m)?;
        let speeds = self.kmh.iter().map(|v| v / KILOMETRES_PER_HOUR).collect();
        LinearTable::new(self.chainage_m.clone(), speeds).map_err(|error| {
            check.error(
                "chainage_m",
                format!("{} values", self.chainage_m.len()),
                error.to_string(),
            )
        })
    }
}

impl Gains {
    pub(super) fn check(&self, check: &Check) -> Result<(), Mistake> {
        check.between("proportional_per_s", self.proportional_per_s, 0.0, 10.0)?;
        check.between("integral_per_s2", self.integral_per_s2, 0.0, 1.0)?;
        check.between("derivative", self.derivative, 0.0, 10.0)?;
        check.between("preview_s", self.preview_s, 0.0, 600.0)
    }
}

/// The speed of a profile at a chainage, m/s, and its slope there, 1/s.
pub(super) fn speed_and_slope(profile: &LinearTable, chainage: f64) -> (f64, f64) {
    let at = |chainage: f64| profile.value(chainage, &mut 0);
    let speed = at(chainage);
    (speed, (at(chainage + SLOPE_OVER) - speed) / SLOPE_OVER)
}

impl Cruise {
    pub(super) fn command(&self, state: &mut DriverState, view: &View) -> Command {
        state.target_speed = self.speed.value(view.chainage, &mut 0);
        let Some((train, now)) = view.train else { return state.levers.command };
        if !self.levers.looks(&mut state.levers, view.time) {
            return state.levers.command;
        }
        let speed = view.velocity;
        let ahead = speed * self.gains.preview_s;
        let (_, slope) = speed_and_slope(&self.speed, view.chainage + ahead);
        let error = state.target_speed - speed;
        let leader = train.vehicles()[0].acceleration(&now.vehicles[0]);
        let integral = state.levers.integral + error * self.levers.interval();
        let correction = self.gains.proportional_per_s * error
            + self.gains.integral_per_s2 * integral
            - self.gains.derivative * leader;
        let force =
            train.demand(now, ahead, speed) + train.inertia() * (speed * slope + correction);
        let (wanted, possible) = self.levers.wanted(force, view);
        if possible {
            state.levers.integral = integral;
        }
        self.levers.follow(&mut state.levers, &wanted)
    }
}
