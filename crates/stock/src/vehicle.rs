//! The vehicle file: one type of vehicle.
//!
//! ```toml
//! name = "Wagon of 134 t with six axles"
//! source = "paper, table 1"
//! mass_kg = 134000.0
//! length_m = 20.0              # over the couplers
//! axles = 6
//!
//! [coupler]
//! draft_gear = "friction-gear-m901e"   # a file in draft_gears/
//! slack_mm = 9.9                       # this coupler's share of the free play of a connection
//!
//! [resistance]                 # factor (constant m + axle n + linear m V + quadratic V^2)
//! factor = 1.0
//! constant_n_per_t = 2.943
//! axle_n = 89.2
//! linear_n_per_t_kmh = 0.0306
//! quadratic_n_per_kmh2 = 0.12187
//! curve_n_m_per_t = 6116.0     # over the curve's radius
//!
//! [brake]
//! net_braking_ratio = 0.1      # shoe force over weight at full service
//! dead_time_s = 0.5
//! build_up_s = 10.0
//! release_s = 15.0
//! lag_s = 1.0
//! shoe_friction = { speed_kmh = [0.0, 100.0], value = [0.5, 0.3] }
//! ```

use serde::Deserialize;

use crate::check::{Check, StockError};
use crate::multibody::Multibody;
use crate::propulsion::{DynamicBrake, Traction, ValueBySpeed};

/// A type of vehicle.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Vehicle {
    /// Name for people.
    pub name: String,
    /// Where the values come from.
    pub source: String,
    /// Mass, kg.
    pub mass_kg: f64,
    /// Mass that would have the inertia of all rotating parts, ΣI/r², kg.
    #[serde(default)]
    pub rotating_mass_kg: f64,
    /// Length over the couplers, m.
    pub length_m: f64,
    /// Number of axles.
    pub axles: u32,
    /// Couplers at both ends.
    pub coupler: Coupler,
    /// Propulsion and curve resistance.
    pub resistance: Resistance,
    /// Traction; none: a wagon.
    pub traction: Option<Traction>,
    /// Dynamic brake, if there is one.
    pub dynamic_brake: Option<DynamicBrake>,
    /// Friction brake.
    pub brake: Brake,
    /// Bodies, suspension and contact of the three-dimensional model.
    pub multibody: Option<Multibody>,
}

/// Section `[coupler]`: what stands at either end of the vehicle.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Coupler {
    /// Name of the draft gear.
    pub draft_gear: String,
    /// Share of this coupler in the free play of a connection, mm.
    pub slack_mm: f64,
}

/// Section `[resistance]`: coefficients of the propulsion resistance
/// `factor (constant m + axle n + linear m V + quadratic V²)` and of the curve resistance, with
/// the mass m in t, n axles and the speed V in km/h.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Resistance {
    /// Factor on the propulsion resistance.
    pub factor: f64,
    /// Part by mass, N/t.
    pub constant_n_per_t: f64,
    /// Part by axles, N.
    pub axle_n: f64,
    /// Part by mass and speed, N/(t km/h).
    pub linear_n_per_t_kmh: f64,
    /// Part by the square of the speed, N/(km/h)².
    pub quadratic_n_per_kmh2: f64,
    /// Curve resistance times radius, N m/t.
    pub curve_n_m_per_t: f64,
}

/// Section `[brake]`: an electronically controlled pneumatic (ECP) friction brake.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Brake {
    /// Force of all shoes over the vehicle's weight at full service.
    pub net_braking_ratio: f64,
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
}

impl Vehicle {
    pub(crate) fn check(&self, file: &str) -> Result<(), StockError> {
        let check = Check::new(file);
        check.between("mass_kg", self.mass_kg, 100.0, 1e6)?;
        check.between("rotating_mass_kg", self.rotating_mass_kg, 0.0, 1e5)?;
        check.between("length_m", self.length_m, 1.0, 200.0)?;
        check.between("axles", f64::from(self.axles), 2.0, 64.0)?;
        check.between("coupler.slack_mm", self.coupler.slack_mm, 0.0, 500.0)?;
        self.resistance.check(&check.section("resistance"))?;
        self.brake.check(&check.section("brake"))?;
        if let Some(traction) = &self.traction {
            traction.check(&check.section("traction"))?;
        }
        if let Some(brake) = &self.dynamic_brake {
            brake.check(&check.section("dynamic_brake"))?;
        }
        if let Some(multibody) = &self.multibody {
            multibody.check(&check.section("multibody"), self.mass_kg)?;
        }
        Ok(())
    }
}

impl Resistance {
    fn check(&self, check: &Check) -> Result<(), StockError> {
        check.between("factor", self.factor, 0.0, 10.0)?;
        check.between("constant_n_per_t", self.constant_n_per_t, 0.0, 1000.0)?;
        check.between("axle_n", self.axle_n, 0.0, 1e4)?;
        check.between("linear_n_per_t_kmh", self.linear_n_per_t_kmh, 0.0, 10.0)?;
        check.between("quadratic_n_per_kmh2", self.quadratic_n_per_kmh2, 0.0, 100.0)?;
        check.between("curve_n_m_per_t", self.curve_n_m_per_t, 0.0, 1e5)
    }
}

impl Brake {
    fn check(&self, check: &Check) -> Result<(), StockError> {
        check.between("net_braking_ratio", self.net_braking_ratio, 0.0, 1.0)?;
        check.between("dead_time_s", self.dead_time_s, 0.0, 60.0)?;
        check.between("build_up_s", self.build_up_s, 0.1, 600.0)?;
        check.between("release_s", self.release_s, 0.1, 600.0)?;
        check.between("lag_s", self.lag_s, 0.1, 60.0)?;
        self.shoe_friction.check(&check.section("shoe_friction"))
    }
}
