//! One lever by a table over time or chainage.
//!
//! ```toml
//! [[profile]]
//! lever = "throttle"           # throttle, dynamic_brake, train_brake or locomotive_brake
//! chainage_m = [0.0, 804.7, 1109.5]   # of the leading vehicle's middle; or time_s
//! value = [0.5, 0.5, 0.75]     # linear between the points, constant outside
//! ```

use files::{Check, Mistake};
use numerics::LinearTable;
use schemars::JsonSchema;
use serde::Deserialize;

use super::view::View;
use crate::command::{Command, EMERGENCY, HIGHEST_NOTCH};

/// Table of one lever.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Profile {
    lever: Lever,
    by_time: bool,
    table: LinearTable,
}

#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Lever {
    Throttle,
    DynamicBrake,
    TrainBrake,
    LocomotiveBrake,
}

/// One `[[profile]]` of a driver file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ProfileFile {
    /// Lever.
    lever: Lever,
    /// Times, s; instead of `chainage_m`.
    time_s: Option<Vec<f64>>,
    /// Chainages of the leading vehicle, m; instead of `time_s`.
    chainage_m: Option<Vec<f64>>,
    /// Values of the lever there.
    value: Vec<f64>,
}

impl ProfileFile {
    pub(super) fn compile(&self, check: &Check) -> Result<Profile, Mistake> {
        let (key, x) = match (&self.time_s, &self.chainage_m) {
            (Some(times), None) => ("time_s", times),
            (None, Some(chainages)) => ("chainage_m", chainages),
            (None, None) => {
                let what_for = "a profile needs either time_s or chainage_m";
                return Err(check.missing("chainage_m", what_for));
            }
            (Some(_), Some(_)) => {
                return Err(check.refuse("time_s", "leave either time_s or chainage_m out"));
            }
        };
        let greatest = if self.lever == Lever::TrainBrake { EMERGENCY } else { 1.0 };
        for (i, &value) in self.value.iter().enumerate() {
            check.share(&format!("value[{}]", i + 1), value, greatest)?;
        }
        check.rising(key, x)?;
        let table = LinearTable::new(x.clone(), self.value.clone())
            .map_err(|error| check.error(key, format!("{} values", x.len()), error.to_string()))?;
        Ok(Profile { lever: self.lever, by_time: key == "time_s", table })
    }
}

impl Profile {
    /// Whether it opens the throttle at some time.
    pub(super) fn pulls(&self) -> bool {
        self.lever == Lever::Throttle && self.table.y().iter().any(|value| *value > 0.0)
    }

    /// Moves the lever to where the table has it.
    pub(super) fn apply(&self, command: &mut Command, view: &View) {
        let at = if self.by_time { view.time } else { view.chainage };
        let value = self.table.value(at, &mut 0);
        match self.lever {
            Lever::Throttle => command.notch = value * HIGHEST_NOTCH,
            Lever::DynamicBrake => command.dynamic_brake = value,
            Lever::TrainBrake => command.train_brake = value,
            Lever::LocomotiveBrake => command.locomotive_brake = value,
        }
    }
}
