//! Sections of the vehicle file that only locomotives have: traction and dynamic brake.

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

/// Number of the highest notch.
pub const NOTCHES: usize = 8;

/// Section `[traction]`: effort by notch and speed.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Traction {
    /// Power for traction in the highest notch, kW; none: the effort alone limits.
    pub power_kw: Option<f64>,
    /// Share of that power that reaches the rail.
    #[serde(default = "one")]
    pub efficiency: f64,
    /// Share of the power in each notch, idle first; needed with `power_kw`.
    #[serde(default)]
    pub notch_power: Vec<f64>,
    /// Share of the effort limit in each notch, idle first.
    #[serde(default = "eighths")]
    pub notch_effort: Vec<f64>,
    /// Time from idle to the highest notch, s.
    pub ramp_s: f64,
    /// Greatest effort of the drive by speed.
    pub effort: Option<EffortBySpeed>,
    /// Effort in each notch by speed, instead of `effort` and `notch_effort`.
    pub by_notch: Option<EffortByNotch>,
    /// Adhesion that the wheels find, by speed: effort over weight; none: no limit.
    pub adhesion: Option<ValueBySpeed>,
}

/// Efforts of the notches 1 to 8 by speed.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EffortByNotch {
    /// Speeds, rising from zero, km/h.
    pub speed_kmh: Vec<f64>,
    /// A row for each notch, of one force for each speed, kN.
    pub effort_kn: Vec<Vec<f64>>,
}

fn one() -> f64 {
    1.0
}

fn eighths() -> Vec<f64> {
    (0..=NOTCHES).map(|notch| notch as f64 / NOTCHES as f64).collect()
}

/// Section `[dynamic_brake]`: full effort by speed.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DynamicBrake {
    /// Time from nothing to full, s.
    pub ramp_s: f64,
    /// Full effort by speed.
    pub effort: EffortBySpeed,
}

/// A force by speed, constant beyond its points.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EffortBySpeed {
    /// Speeds, rising from zero, km/h. One that stands twice is a corner of a spline.
    pub speed_kmh: Vec<f64>,
    /// Forces, kN.
    pub effort_kn: Vec<f64>,
    /// What lies between the points: "linear" or "cubic", a spline.
    #[serde(default)]
    pub interpolation: Between,
}

/// What lies between two points of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Between {
    /// A straight line.
    #[default]
    Linear,
    /// A cubic spline.
    Cubic,
}

/// A ratio by speed, linear between its points and constant beyond them.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ValueBySpeed {
    /// Speeds, rising from zero, km/h.
    pub speed_kmh: Vec<f64>,
    /// Ratios.
    pub value: Vec<f64>,
}

impl Traction {
    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        check.between("efficiency", self.efficiency, 0.1, 1.0)?;
        check.between("ramp_s", self.ramp_s, 0.0, 600.0)?;
        match self.power_kw {
            Some(power) => {
                check.positive("power_kw", power)?;
                check_shares(check, "notch_power", &self.notch_power)?;
            }
            None if self.notch_power.is_empty() => {}
            None => return Err(check.missing("power_kw", "notch_power needs it")),
        }
        check_shares(check, "notch_effort", &self.notch_effort)?;
        match (&self.effort, &self.by_notch) {
            (Some(effort), None) => effort.check(&check.section("effort"))?,
            (None, Some(by_notch)) => by_notch.check(&check.section("by_notch"))?,
            (Some(_), Some(_)) => {
                let why = "leave either [traction.effort] or [traction.by_notch] out";
                return Err(check.refuse("by_notch", why));
            }
            (None, None) => {
                let what_for = "traction needs it, or [traction.by_notch]";
                return Err(check.missing("effort", what_for));
            }
        }
        match &self.adhesion {
            Some(adhesion) => adhesion.check(&check.section("adhesion")),
            None => Ok(()),
        }
    }
}

/// Shares of idle and the notches: nine, from zero, not falling, at most one.
fn check_shares(check: &Check, key: &str, shares: &[f64]) -> Result<(), Mistake> {
    if shares.len() != NOTCHES + 1 {
        let wanted = "needs nine values, for idle and the notches 1 to 8";
        return Err(check.error(key, format!("{shares:?}"), wanted));
    }
    if shares[0] != 0.0 {
        return Err(check.error(&format!("{key}[1]"), shares[0], "must be zero in idle"));
    }
    for (i, &share) in shares.iter().enumerate() {
        let least = if i == 0 { 0.0 } else { shares[i - 1] };
        check.between(&format!("{key}[{}]", i + 1), share, least, 1.0)?;
    }
    Ok(())
}

impl EffortByNotch {
    fn check(&self, check: &Check) -> Result<(), Mistake> {
        if self.effort_kn.len() != NOTCHES {
            let wanted = "needs eight rows, one for each notch from 1 to 8";
            return Err(check.error("effort_kn", format!("{} rows", self.effort_kn.len()), wanted));
        }
        for (i, row) in self.effort_kn.iter().enumerate() {
            let key = format!("effort_kn[{}]", i + 1);
            check.columns(("speed_kmh", &self.speed_kmh), (&key, row), 1)?;
        }
        Ok(())
    }
}

impl DynamicBrake {
    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        check.between("ramp_s", self.ramp_s, 0.0, 600.0)?;
        let effort = check.section("effort");
        self.effort.check(&effort)?;
        match self.effort.effort_kn[0] {
            0.0 => Ok(()),
            force => Err(effort.error("effort_kn[1]", force, "must be zero at standstill")),
        }
    }
}

impl EffortBySpeed {
    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        // A speed may stand twice, as the corner of a spline: the rest must be as in any table.
        let (mut speeds, mut efforts) = (self.speed_kmh.clone(), self.effort_kn.clone());
        let corner = |i: &usize| {
            let same = |column: &[f64]| column.len() > *i && column[*i] == column[i - 1];
            same(&self.speed_kmh) && same(&self.effort_kn)
        };
        if self.interpolation == Between::Cubic {
            for i in (1..speeds.len()).filter(corner).collect::<Vec<_>>().into_iter().rev() {
                speeds.remove(i);
                efforts.remove(i);
            }
        }
        check.columns(("speed_kmh", &speeds), ("effort_kn", &efforts), 1)
    }
}

impl ValueBySpeed {
    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        check.columns(("speed_kmh", &self.speed_kmh), ("value", &self.value), 1)?;
        for (i, &value) in self.value.iter().enumerate() {
            check.between(&format!("value[{}]", i + 1), value, 0.0, 1.0)?;
        }
        Ok(())
    }
}
