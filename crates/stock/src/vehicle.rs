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
//! [resistance]                 # other formulas: see resistance.rs; here factor (constant m + axle n + linear m V + quadratic V^2)
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

use std::path::Path;

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::brake::{Brake, HandBrake, LocomotiveBrake};
use crate::multibody::{Multibody, profile_files};
use crate::propulsion::{DynamicBrake, Traction};
use crate::resistance::Resistance;

/// A type of vehicle.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
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
    /// Brake of the locomotives alone, if this is one.
    pub locomotive_brake: Option<LocomotiveBrake>,
    /// Hand brake, if there is one.
    pub hand_brake: Option<HandBrake>,
    /// Whether gradient and curve act over the whole length instead of at the middle.
    #[serde(default)]
    pub along_its_length: bool,
    /// Bodies, suspension and contact of the three-dimensional model.
    pub multibody: Option<Multibody>,
}

/// Section `[coupler]`: what stands at either end of the vehicle.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Coupler {
    /// What it couples to: the same kind at the neighbour's end. "automatic", "screw", "drawbar" or
    /// any other name.
    #[serde(default = "automatic")]
    pub kind: String,
    /// Name of the draft gear.
    pub draft_gear: String,
    /// Share of this coupler in the free play of a connection, mm.
    pub slack_mm: f64,
    /// What stands at the rear end, if it is not the same, as with a drawbar.
    pub rear: Option<RearCoupler>,
}

/// Section `[coupler.rear]`.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RearCoupler {
    /// What it couples to, as at the front.
    #[serde(default = "automatic")]
    pub kind: String,
    /// Name of the draft gear.
    pub draft_gear: String,
    /// Share of this coupler in the free play of a connection, mm.
    pub slack_mm: f64,
}

fn automatic() -> String {
    "automatic".to_owned()
}

impl Coupler {
    /// What the rear end couples to.
    pub fn rear_kind(&self) -> &str {
        self.rear.as_ref().map_or(&self.kind, |rear| &rear.kind)
    }

    /// Name of the draft gear at the rear end.
    pub fn rear_draft_gear(&self) -> &str {
        self.rear.as_ref().map_or(&self.draft_gear, |rear| &rear.draft_gear)
    }

    /// Share of the rear coupler in the free play of a connection, mm.
    pub fn rear_slack_mm(&self) -> f64 {
        self.rear.as_ref().map_or(self.slack_mm, |rear| rear.slack_mm)
    }
}

impl Vehicle {
    /// Finds the profiles that are files in the folder `library`.
    pub(crate) fn find_profiles(&mut self, check: &Check, library: &Path) -> Result<(), Mistake> {
        match &mut self.multibody {
            Some(multibody) => {
                let check = check.section("multibody").section("contact");
                profile_files::find(&mut multibody.contact, library, &check)
            }
            None => Ok(()),
        }
    }

    /// Refuses values that are not possible.
    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        check.between("mass_kg", self.mass_kg, 100.0, 1e6)?;
        check.between("rotating_mass_kg", self.rotating_mass_kg, 0.0, 1e5)?;
        check.between("length_m", self.length_m, 1.0, 200.0)?;
        check.between("axles", f64::from(self.axles), 2.0, 64.0)?;
        check.between("coupler.slack_mm", self.coupler.slack_mm, 0.0, 500.0)?;
        check.between("coupler.rear.slack_mm", self.coupler.rear_slack_mm(), 0.0, 500.0)?;
        self.resistance.check(&check.section("resistance"))?;
        self.brake.check(&check.section("brake"))?;
        if let Some(brake) = &self.locomotive_brake {
            brake.check(&check.section("locomotive_brake"))?;
        }
        if let Some(brake) = &self.hand_brake {
            brake.check(&check.section("hand_brake"))?;
        }
        if let Some(traction) = &self.traction {
            traction.check(&check.section("traction"))?;
        }
        if let Some(brake) = &self.dynamic_brake {
            brake.check(&check.section("dynamic_brake"))?;
        }
        if let Some(multibody) = &self.multibody {
            let wheelsets = multibody.wheelset.len();
            let wanted = format!("must be {wheelsets}, as [multibody] has {wheelsets} wheelsets");
            check.ensure(self.axles as usize == wheelsets, "axles", self.axles, &wanted)?;
            multibody.check_mass(check, self.mass_kg)?;
            multibody.check(&check.section("multibody"))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn coupler(text: &str) -> Coupler {
        files::Document::new("v.toml", text).parse().unwrap()
    }

    #[test]
    fn a_coupler_stands_at_both_ends_unless_the_rear_has_its_own() {
        let front = "draft_gear = 'friction'\nslack_mm = 9.9\n";
        let both = coupler(front);
        assert_eq!((both.rear_kind(), both.rear_draft_gear()), ("automatic", "friction"));
        assert_eq!(both.rear_slack_mm(), 9.9);
        let rear = "[rear]\nkind = 'drawbar'\ndraft_gear = 'bar'\nslack_mm = 0.0\n";
        let own = coupler(&format!("{front}{rear}"));
        assert_eq!((own.rear_kind(), own.rear_draft_gear()), ("drawbar", "bar"));
        assert_eq!((own.slack_mm, own.rear_slack_mm()), (9.9, 0.0));
    }
}
