//! Friction that falls with the slip velocity.

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
