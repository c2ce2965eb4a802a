//! Friction that falls with the slip velocity, or with the temperature of the contact.

use super::friction_by_temperature::FrictionByTemperature;
use super::sliding::Sliding;
use super::{SlipVelocity, reference_speed};
use crate::geometry::contact_point::ContactPatch;

/// How friction depends on what a contact does.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize)]
pub enum Friction {
    /// By the slip velocity.
    Falling(FallingFriction),
    /// By the temperature.
    ByTemperature(FrictionByTemperature),
}

/// mu = mu0 ((1 - A) exp(-B w) + A) with the slip velocity w in m/s.
///
/// Source: Polach, Wear 258 (2005) 992-1000, eq. 11. A = 1 is Coulomb's constant friction.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize)]
#[serde(deny_unknown_fields)]
pub struct FallingFriction {
    /// Friction coefficient mu0 at no slip velocity.
    pub static_coefficient: f64,
    /// A: friction at infinite slip velocity by mu0, between 0 and 1.
    pub limit_ratio: f64,
    /// B in s/m: how fast friction falls, not negative.
    pub decay: f64,
}

impl FallingFriction {
    /// Friction that does not depend on the slip velocity.
    pub fn constant(coefficient: f64) -> Self {
        Self { static_coefficient: coefficient, limit_ratio: 1.0, decay: 0.0 }
    }

    /// Friction coefficient at a `slip_velocity` (magnitude, m/s).
    pub fn coefficient(&self, slip_velocity: f64) -> f64 {
        let fallen = libm::exp(-self.decay * slip_velocity);
        self.static_coefficient * ((1.0 - self.limit_ratio) * fallen + self.limit_ratio)
    }
}

impl Friction {
    /// Friction of a contact that slips, while it rolls at `speed` (m/s).
    #[inline]
    pub(crate) fn sliding(&self, patch: &ContactPatch, slip: &SlipVelocity, speed: f64) -> Sliding {
        let slide = slip.longitudinal * slip.longitudinal + slip.lateral * slip.lateral;
        match self {
            Self::Falling(friction) => {
                Sliding { coefficient: friction.coefficient(slide.sqrt()), flash: 1.0 }
            }
            Self::ByTemperature(friction) => {
                // Mean over the pressure of the square of the spin's slip velocity.
                let reach = (patch.a * patch.a + patch.b * patch.b) / 5.0;
                let slip_velocity = (slide + reach * slip.spin * slip.spin).sqrt();
                friction.sliding(patch, slip_velocity, reference_speed(speed))
            }
        }
    }

    /// The same friction with another coefficient without slip, or at the reference temperature.
    pub fn with_coefficient(mut self, coefficient: f64) -> Self {
        match &mut self {
            Self::Falling(friction) => friction.static_coefficient = coefficient,
            Self::ByTemperature(friction) => friction.reference_coefficient = coefficient,
        }
        self
    }
}

impl From<FallingFriction> for Friction {
    fn from(friction: FallingFriction) -> Self {
        Self::Falling(friction)
    }
}

impl From<FrictionByTemperature> for Friction {
    fn from(friction: FrictionByTemperature) -> Self {
        Self::ByTemperature(friction)
    }
}
