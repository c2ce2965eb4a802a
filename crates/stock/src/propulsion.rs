//! Sections of the vehicle file that only locomotives have: traction and dynamic brake.

use serde::Deserialize;

use crate::check::{Check, StockError};

/// Section `[traction]`: effort by notch and speed.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Traction {
    /// Power for traction in the highest notch, kW.
    pub power_kw: f64,
    /// Share of that power that reaches the rail.
    pub efficiency: f64,
    /// Share of the power in each notch, idle first.
    pub notch_power: Vec<f64>,
    /// Share of the effort limit in each notch, idle first.
    pub notch_effort: Vec<f64>,
    /// Time from idle to the highest notch, s.
    pub ramp_s: f64,
    /// Greatest effort of the drive by speed.
    pub effort: EffortBySpeed,
    /// Adhesion that the wheels find, by speed: effort over weight.
    pub adhesion: ValueBySpeed,
}

/// Section `[dynamic_brake]`: full effort by speed.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DynamicBrake {
    /// Time from nothing to full, s.
    pub ramp_s: f64,
    /// Full effort by speed.
    pub effort: EffortBySpeed,
}

/// A force by speed, linear between its points and constant beyond them.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EffortBySpeed {
    /// Speeds, rising from zero, km/h.
    pub speed_kmh: Vec<f64>,
    /// Forces, kN.
    pub effort_kn: Vec<f64>,
}

/// A ratio by speed, linear between its points and constant beyond them.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ValueBySpeed {
    /// Speeds, rising from zero, km/h.
    pub speed_kmh: Vec<f64>,
    /// Ratios.
    pub value: Vec<f64>,
}

impl Traction {
    pub(crate) fn check(&self, check: &Check) -> Result<(), StockError> {
        check.positive("power_kw", self.power_kw)?;
        check.between("efficiency", self.efficiency, 0.1, 1.0)?;
        check.between("ramp_s", self.ramp_s, 0.0, 600.0)?;
        let keys = [("notch_power", &self.notch_power), ("notch_effort", &self.notch_effort)];
        for (key, shares) in keys {
            if shares.len() != 9 {
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
        }
        self.effort.check(&check.section("effort"))?;
        self.adhesion.check(&check.section("adhesion"))
    }
}

impl DynamicBrake {
    pub(crate) fn check(&self, check: &Check) -> Result<(), StockError> {
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
    fn check(&self, check: &Check) -> Result<(), StockError> {
        check.columns(("speed_kmh", &self.speed_kmh), ("effort_kn", &self.effort_kn), 1)
    }
}

impl ValueBySpeed {
    pub(crate) fn check(&self, check: &Check) -> Result<(), StockError> {
        check.columns(("speed_kmh", &self.speed_kmh), ("value", &self.value), 1)?;
        for (i, &value) in self.value.iter().enumerate() {
            check.between(&format!("value[{}]", i + 1), value, 0.0, 1.0)?;
        }
        Ok(())
    }
}
