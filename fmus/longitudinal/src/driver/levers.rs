//! The hands of a driver who controls the speed: from what is wanted to levers that move with limits.
//!
//! Traction comes first, then the dynamic brake, then the train brake for what the dynamic brake
//! cannot give (blending). Only one of traction and dynamic brake is applied at a time.

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::view::View;
use crate::command::{Command, HIGHEST_NOTCH};
use crate::train::vehicle::Vehicle;

/// Halvings of the search for a throttle: 2⁻³⁰ of it is left.
const HALVINGS: usize = 30;

/// Section `[levers]` of a driver file.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(super) struct Levers {
    /// Whether the throttle moves without steps.
    continuous: bool,
    /// Time from notch to notch, s.
    notch_interval_s: f64,
    /// Time from nothing to full dynamic brake, s.
    dynamic_brake_s: f64,
    /// Time from nothing to full service, s.
    train_brake_s: f64,
    /// Smallest application of the train brake; less is left off.
    least_train_brake: f64,
    /// Time between two looks at the speed, s.
    interval_s: f64,
}

impl Default for Levers {
    fn default() -> Self {
        Self {
            continuous: false,
            notch_interval_s: 3.0,
            dynamic_brake_s: 10.0,
            train_brake_s: 10.0,
            least_train_brake: 0.1,
            interval_s: 0.5,
        }
    }
}

/// Where the hands are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LeverState {
    /// What is asked for now.
    pub command: Command,
    /// Time of the next look, s.
    next_look: f64,
    /// Time since the notch was changed, s.
    since_notch: f64,
    /// Integral of the speed error, m.
    pub integral: f64,
    /// Lever of the fuzzy driver, from -2 (full service) over -1 (full dynamic brake) to 1.
    pub lever: f64,
}

/// What is wanted of the levers, each from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Wanted {
    pub throttle: f64,
    pub dynamic_brake: f64,
    pub train_brake: f64,
}

impl Levers {
    pub(super) fn check(&self, check: &Check) -> Result<(), Mistake> {
        check.between("notch_interval_s", self.notch_interval_s, 0.01, 60.0)?;
        check.between("dynamic_brake_s", self.dynamic_brake_s, 0.1, 600.0)?;
        check.between("train_brake_s", self.train_brake_s, 0.1, 600.0)?;
        check.between("least_train_brake", self.least_train_brake, 0.0, 1.0)?;
        check.between("interval_s", self.interval_s, 0.01, 60.0)
    }

    /// Time between two looks, s.
    pub(super) fn interval(&self) -> f64 {
        self.interval_s
    }

    /// Whether it is time to look again.
    pub(super) fn looks(&self, state: &mut LeverState, time: f64) -> bool {
        let due = time >= state.next_look;
        if due {
            state.next_look = time + self.interval_s;
        }
        due
    }

    /// What gives a force at the present speed, N, and whether the levers can give it.
    pub(super) fn wanted(&self, force: f64, view: &View) -> (Wanted, bool) {
        let Some((train, _)) = view.train else { return (Wanted::default(), true) };
        let speed = view.velocity.abs();
        let sum = |of: &dyn Fn(&Vehicle) -> f64| -> f64 {
            train.vehicles().iter().map(|vehicle| of(vehicle)).sum()
        };
        if force >= 0.0 {
            let effort = |lever: f64| sum(&|vehicle| vehicle.tractive_effort(lever, speed));
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..HALVINGS {
                let middle = (low + high) / 2.0;
                match effort(middle) < force {
                    true => low = middle,
                    false => high = middle,
                }
            }
            let reached = effort(1.0) >= force;
            return (Wanted { throttle: high, ..Wanted::default() }, reached);
        }
        let brake = -force;
        let dynamic = sum(&|vehicle| vehicle.dynamic_brake_effort(speed));
        let dynamic_brake = if dynamic > 0.0 { (brake / dynamic).min(1.0) } else { 0.0 };
        let full = sum(&|vehicle| vehicle.full_service(speed));
        let rest = (brake - dynamic_brake * dynamic).max(0.0);
        let train_brake = if full > 0.0 { rest / full } else { 0.0 };
        (Wanted { throttle: 0.0, dynamic_brake, train_brake: train_brake.min(1.0) }, rest <= full)
    }

    /// Moves the levers towards what is wanted, as far as they go from one look to the next.
    pub(super) fn follow(&self, state: &mut LeverState, wanted: &Wanted) -> Command {
        let step = self.interval_s;
        let moved =
            |from: f64, to: f64, time: f64| from + (to - from).clamp(-step / time, step / time);
        let command = &mut state.command;
        state.since_notch += step;

        let notch = wanted.throttle * HIGHEST_NOTCH;
        let target = match self.continuous {
            true => notch,
            false => notch.round(),
        };
        let braked = command.dynamic_brake > 0.0;
        if self.continuous && !braked {
            let most = step / self.notch_interval_s;
            command.notch += (target - command.notch).clamp(-most, most);
        } else if !braked && target != command.notch && state.since_notch >= self.notch_interval_s {
            command.notch += (target - command.notch).signum();
            state.since_notch = 0.0;
        }
        let dynamic_brake = if command.notch > 0.0 { 0.0 } else { wanted.dynamic_brake };
        command.dynamic_brake = moved(command.dynamic_brake, dynamic_brake, self.dynamic_brake_s);
        let train_brake = match wanted.train_brake < self.least_train_brake {
            true => 0.0,
            false => wanted.train_brake,
        };
        command.train_brake = moved(command.train_brake, train_brake, self.train_brake_s);
        *command
    }
}
