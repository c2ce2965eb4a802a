//! The creep laws a vehicle can have.

use super::exact_rolling::ExactRolling;
use super::friction::Friction;
use super::linear;
use super::modified_fastsim::ModifiedFastsim;
use super::polach::Polach;
use super::{CreepForces, SlipVelocity};
use crate::geometry::contact_point::ContactPatch;

/// A law of creep forces.
#[derive(Clone, Copy, Debug)]
pub enum CreepLaw {
    /// Exact rolling, by table.
    ExactRolling(ExactRolling),
    /// Modified FASTSIM, marched in every evaluation.
    Fastsim(ModifiedFastsim),
    /// Polach's closed formula.
    Polach(Polach),
    /// Kalker's linear forces reduced by Shen, Hedrick and Elkins.
    ShenHedrickElkins(Friction),
    /// Kalker's linear forces without limit; friction does not count.
    KalkerLinear,
}

impl CreepLaw {
    /// Forces on the wheel in a loaded contact that slips, while it rolls at `speed` (m/s).
    ///
    /// Without load all is zero. Lateral slip and force lie in the contact plane.
    #[inline]
    pub fn force(&self, patch: &ContactPatch, slip: &SlipVelocity, speed: f64) -> CreepForces {
        match self {
            Self::ExactRolling(law) => law.force(patch, slip, speed),
            Self::Fastsim(law) => law.force(patch, slip, speed),
            Self::Polach(law) => law.force(patch, slip, speed),
            Self::ShenHedrickElkins(friction) => linear::limited(friction, patch, slip, speed),
            Self::KalkerLinear => linear::linear(patch, slip, speed),
        }
    }

    /// The law on rails with another friction coefficient without slip; it falls with slip or
    /// temperature as before.
    pub fn with_friction(mut self, coefficient: f64) -> Self {
        let friction = match &mut self {
            Self::ExactRolling(law) => &mut law.friction,
            Self::Fastsim(law) => &mut law.friction,
            Self::Polach(law) => &mut law.friction,
            Self::ShenHedrickElkins(friction) => friction,
            Self::KalkerLinear => return self,
        };
        *friction = friction.with_coefficient(coefficient);
        self
    }
}
