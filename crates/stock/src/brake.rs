//! Sections of the vehicle file on its brakes: `[brake]`, `[locomotive_brake]`, `[hand_brake]`.

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::propulsion::ValueBySpeed;

/// What commands the friction brake.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum BrakeControl {
    /// A cable along the train (ECP).
    #[default]
    Ecp,
    /// The pressure in the brake pipe, by `[brake.air]`.
    Air,
}

/// Section `[brake]`: the friction brake that the train brake commands.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Brake {
    /// Cable or pipe. A vehicle may have both; the times below are those of the cable.
    #[serde(default)]
    pub control: BrakeControl,
    /// Force of all shoes over the vehicle's weight at full service.
    pub net_braking_ratio: f64,
    /// Share of the friction power that goes into the wheels; the shoes take the rest.
    #[serde(default = "one")]
    pub wheel_heat_share: f64,
    /// Time from a command to the first change of the cylinder pressure, s.
    pub dead_time_s: f64,
    /// Shortest time from empty to full service, s.
    pub build_up_s: f64,
    /// Shortest time from full service to empty, s.
    pub release_s: f64,
    /// Time constant with which the pressure comes to its target, s.
    pub lag_s: f64,
    /// Friction coefficient of the shoes by speed.
    pub shoe_friction: ValueBySpeed,
    /// The conventional air brake.
    pub air: Option<AirBrake>,
}

/// Section `[brake.air]`: a conventional air brake, described by its effect.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AirBrake {
    /// Speed along the train at which a service application arrives, m/s.
    pub service_wave_m_per_s: f64,
    /// Speed at which a release arrives, m/s.
    pub release_wave_m_per_s: f64,
    /// Speed at which an emergency application arrives, m/s.
    pub emergency_wave_m_per_s: f64,
    /// Cylinder pressure after the arrival of a full service application.
    pub build_up: FractionByTime,
    /// Cylinder pressure after the arrival of an emergency application, as a fraction of its own.
    pub emergency_build_up: FractionByTime,
    /// Share of the cylinder pressure that is gone after the arrival of a release.
    pub release: FractionByTime,
    /// Whether the brake can be released by degrees; otherwise any release empties the cylinder.
    #[serde(default)]
    pub graduated_release: bool,
    /// The air that there is; none: reservoirs are always full, and nothing leaks.
    pub reservoir: Option<Reservoir>,
}

/// Section `[brake.air.reservoir]`: the air of the vehicle and of its pipe. Shares are of the change
/// of pressure at full service.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Reservoir {
    /// Time constant of recharging beside the source of the air, s.
    pub recharge_s: f64,
    /// What a kilometre of pipe adds to it, s.
    #[serde(default)]
    pub recharge_s_per_km: f64,
    /// Share of pressure that the pipe loses in a minute while the brake is applied.
    ///
    /// Zero where the driver's valve maintains it.
    #[serde(default)]
    pub pipe_leakage_per_min: f64,
    /// Share of the cylinder's own pressure that is lost in a minute.
    #[serde(default)]
    pub cylinder_leakage_per_min: f64,
    /// Share of the greatest cylinder pressure that a kilometre of pipe costs.
    ///
    /// A pipe that leaks holds less pressure at its end.
    #[serde(default)]
    pub gradient_per_km: f64,
}

/// A fraction that rises from 0 to 1 over time.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FractionByTime {
    /// Times, rising from zero, s.
    pub time_s: Vec<f64>,
    /// Fractions, rising from 0 to 1.
    pub fraction: Vec<f64>,
}

/// Section `[locomotive_brake]`: the brake that only acts on the locomotives.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LocomotiveBrake {
    /// Force of all shoes over the weight when fully applied.
    pub net_braking_ratio: f64,
    /// Time from empty to full, s.
    pub build_up_s: f64,
    /// Time from full to empty, s.
    pub release_s: f64,
}

/// Section `[hand_brake]`: what the consist file applies.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HandBrake {
    /// Force of all shoes over the weight when fully applied.
    pub net_braking_ratio: f64,
}

fn one() -> f64 {
    1.0
}

impl Brake {
    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        check.between("net_braking_ratio", self.net_braking_ratio, 0.0, 1.0)?;
        check.between("wheel_heat_share", self.wheel_heat_share, 0.0, 1.0)?;
        check.between("dead_time_s", self.dead_time_s, 0.0, 60.0)?;
        check.between("build_up_s", self.build_up_s, 0.1, 600.0)?;
        check.between("release_s", self.release_s, 0.1, 600.0)?;
        check.between("lag_s", self.lag_s, 0.1, 60.0)?;
        self.shoe_friction.check(&check.section("shoe_friction"))?;
        match (&self.air, self.control) {
            (Some(air), _) => air.check(&check.section("air")),
            (None, BrakeControl::Air) => {
                Err(check.error("control", "\"air\"", "needs the section [brake.air]"))
            }
            (None, BrakeControl::Ecp) => Ok(()),
        }
    }
}

impl AirBrake {
    fn check(&self, check: &Check) -> Result<(), Mistake> {
        // Above the speed of sound in air nothing moves along a pipe.
        check.between("service_wave_m_per_s", self.service_wave_m_per_s, 1.0, 350.0)?;
        check.between("release_wave_m_per_s", self.release_wave_m_per_s, 1.0, 350.0)?;
        check.between("emergency_wave_m_per_s", self.emergency_wave_m_per_s, 1.0, 350.0)?;
        self.build_up.check(&check.section("build_up"))?;
        self.emergency_build_up.check(&check.section("emergency_build_up"))?;
        self.release.check(&check.section("release"))?;
        self.reservoir.map_or(Ok(()), |reservoir| reservoir.check(&check.section("reservoir")))
    }
}

impl Reservoir {
    fn check(&self, check: &Check) -> Result<(), Mistake> {
        check.between("recharge_s", self.recharge_s, 1.0, 3600.0)?;
        check.between("recharge_s_per_km", self.recharge_s_per_km, 0.0, 3600.0)?;
        check.between("pipe_leakage_per_min", self.pipe_leakage_per_min, 0.0, 1.0)?;
        check.between("cylinder_leakage_per_min", self.cylinder_leakage_per_min, 0.0, 1.0)?;
        check.between("gradient_per_km", self.gradient_per_km, 0.0, 0.2)
    }
}

impl FractionByTime {
    fn check(&self, check: &Check) -> Result<(), Mistake> {
        let columns = (("time_s", &self.time_s[..]), ("fraction", &self.fraction[..]));
        check.columns(columns.0, columns.1, 2)?;
        for i in 1..self.fraction.len() {
            if self.fraction[i] <= self.fraction[i - 1] {
                let wanted =
                    format!("must rise from the value before it, {}", self.fraction[i - 1]);
                let key = format!("fraction[{}]", i + 1);
                return Err(check.error(&key, self.fraction[i], wanted));
            }
        }
        let (first, last) = (self.fraction[0], self.fraction[self.fraction.len() - 1]);
        match first == 0.0 && last == 1.0 {
            true => Ok(()),
            false => {
                Err(check.error("fraction", format!("{first} to {last}"), "must go from 0 to 1"))
            }
        }
    }
}

impl LocomotiveBrake {
    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        check.between("net_braking_ratio", self.net_braking_ratio, 0.0, 1.0)?;
        check.between("build_up_s", self.build_up_s, 0.1, 600.0)?;
        check.between("release_s", self.release_s, 0.1, 600.0)
    }
}

impl HandBrake {
    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        check.between("net_braking_ratio", self.net_braking_ratio, 0.0, 1.0)
    }
}
