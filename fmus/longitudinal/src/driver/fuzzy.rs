//! A driver who keeps a speed profile by fuzzy rules.
//!
//! Like a driver who knows the line, this one judges by where the train will be after the time of
//! preview t_p if the levers stay: its acceleration a changes by what the line takes less or more
//! there (theory, eq. 20), with the demand D of the line, the mass M and the profile v*:
//!
//! ```text
//! Δa = (D(x) − D(x + v t_p))/M
//! e  = v*(x + v t_p) − (v + t_p (a + Δa/2))        g = a + Δa − v dv*/dx
//! ```
//!
//! A Takagi-Sugeno controller of order zero acts on that. By e the train is *much too fast*, *too
//! fast*, *right*, *too slow* or *much too slow*, by g its speed is *falling*, *steady* or *rising*
//! against the profile, each to a degree by triangles that add up to one. Each pair has a change of
//! the lever per second; what is done is their mean weighted by the product of the degrees. The lever
//! goes from full service (−2) over full dynamic brake (−1) and coasting (0) to the highest notch (1).
//!
//! ```toml
//! [speed]                      # as for [cruise]
//! chainage_m = [0.0, 5000.0]
//! kmh = [60.0, 60.0]
//! [fuzzy]                      # these are the defaults
//! preview_s = 15.0             # 0 does not look ahead
//! error_kmh = 5.0              # much too fast or slow
//! acceleration_m_per_s2 = 0.05 # falling or rising
//! rate_per_s = 0.1             # greatest change of the lever
//! ```

use files::{Check, Mistake};
use numerics::LinearTable;
use numerics::constants::KILOMETRES_PER_HOUR;
use schemars::JsonSchema;
use serde::Deserialize;

use super::cruise::speed_and_slope;
use super::levers::{Levers, Wanted};
use super::state::DriverState;
use super::view::View;
use crate::command::Command;

/// Change of the lever, of its greatest rate: rows from much too fast to much too slow, columns
/// falling, steady, rising.
const RULES: [[f64; 3]; 5] =
    [[-0.6, -1.0, -1.0], [0.0, -0.4, -0.8], [0.3, 0.0, -0.3], [0.8, 0.4, 0.0], [1.0, 1.0, 0.6]];

/// A driver with fuzzy rules.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Fuzzy {
    pub(super) rules: FuzzyFile,
    pub(super) speed: LinearTable,
    pub(super) levers: Levers,
}

/// Section `[fuzzy]`.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(super) struct FuzzyFile {
    preview_s: f64,
    error_kmh: f64,
    acceleration_m_per_s2: f64,
    rate_per_s: f64,
}

impl Default for FuzzyFile {
    fn default() -> Self {
        Self { preview_s: 15.0, error_kmh: 5.0, acceleration_m_per_s2: 0.05, rate_per_s: 0.1 }
    }
}

impl FuzzyFile {
    pub(super) fn check(&self, check: &Check) -> Result<(), Mistake> {
        check.between("preview_s", self.preview_s, 0.0, 600.0)?;
        check.between("error_kmh", self.error_kmh, 0.1, 100.0)?;
        check.between("acceleration_m_per_s2", self.acceleration_m_per_s2, 0.001, 10.0)?;
        check.between("rate_per_s", self.rate_per_s, 0.001, 10.0)
    }
}

/// Degrees of `N` triangles with their tops evenly from −1 to 1.
fn degrees<const N: usize>(value: f64) -> [f64; N] {
    let position = (value.clamp(-1.0, 1.0) + 1.0) / 2.0 * (N - 1) as f64;
    std::array::from_fn(|i| (1.0 - (position - i as f64).abs()).max(0.0))
}

/// Change of the lever by the rules, as a share of its greatest rate.
///
/// Speed error and acceleration are shares of the greatest that the rules know.
fn lever_change(error: f64, acceleration: f64) -> f64 {
    let (errors, accelerations) = (degrees::<5>(error), degrees::<3>(acceleration));
    let mut change = 0.0;
    for (row, e) in RULES.iter().zip(errors) {
        for (rule, a) in row.iter().zip(accelerations) {
            change += rule * e * a;
        }
    }
    change
}

impl Fuzzy {
    pub(super) fn command(&self, state: &mut DriverState, view: &View) -> Command {
        state.target_speed = self.speed.value(view.chainage, &mut 0);
        let Some((train, now)) = view.train else { return state.levers.command };
        if !self.levers.looks(&mut state.levers, view.time) {
            return state.levers.command;
        }
        let (preview, speed) = (self.rules.preview_s, view.velocity);
        let ahead = speed * preview;
        let (target, slope) = speed_and_slope(&self.speed, view.chainage + ahead);
        let line = train.demand(now, 0.0, speed) - train.demand(now, ahead, speed);
        let (own, change) =
            (train.vehicles()[0].acceleration(&now.vehicles[0]), line / train.inertia());
        let error = target - (speed + preview * (own + change / 2.0));
        let growth = own + change - speed * slope;
        let rate = self.rules.rate_per_s
            * lever_change(
                error * KILOMETRES_PER_HOUR / self.rules.error_kmh,
                growth / self.rules.acceleration_m_per_s2,
            );
        let lever = (state.levers.lever + rate * self.levers.interval()).clamp(-2.0, 1.0);
        state.levers.lever = lever;
        let wanted = Wanted {
            throttle: lever.max(0.0),
            dynamic_brake: (-lever).clamp(0.0, 1.0),
            train_brake: (-lever - 1.0).max(0.0),
        };
        self.levers.follow(&mut state.levers, &wanted)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_degrees_add_up_to_one() {
        for value in [-3.0, -1.0, -0.7, 0.0, 0.2, 1.0] {
            let sum: f64 = degrees::<5>(value).into_iter().sum();
            assert!((sum - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn analytic_rules_at_their_tops_and_halfway() {
        assert_eq!(lever_change(0.0, 0.0), 0.0);
        assert_eq!(lever_change(1.0, 0.0), 1.0);
        assert!((lever_change(0.25, 0.0) - 0.2).abs() < 1e-15);
        // A train that is too slow but gains speed enough is left alone.
        assert_eq!(lever_change(0.5, 1.0), 0.0);
    }
}
