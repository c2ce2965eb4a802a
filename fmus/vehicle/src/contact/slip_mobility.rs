//! How much of a contact's creep counts at the end of a step (eq. 25a).
//!
//! Creep with the secant D is stiff where x = h D μ is large, μ being the velocity that unit impulses
//! of both wheels give a wheelset, shared by two. It must then count at the end of a step h, or a
//! step would turn the slip round. Where x is small, a wheel that slides fast, counting it so only
//! adds a mass h D to the wheelset in the direction of the slip, with which forces on rough track are up to
//! twice as far off. So the share x²/(1 + x²) of D counts at the end and the rest at the beginning.
//!
//! A slip v that only the creep of both wheels changes becomes v (1 - x)²/(1 + x² + 2 x³): at any x
//! it falls and does not turn round.

use contact::CreepForces;

use crate::body::RigidBody;

/// Half the velocities that unit impulses of creep of both wheels give a wheelset's contacts, 1/kg.
#[derive(Clone, Copy, Debug)]
pub struct SlipMobility {
    /// Along the track: 1/m + r²/Iyy.
    longitudinal: f64,
    /// Across: 1/m + r²/Ixx. (On a steep flange a wheel's own is greater, the other one's is not.)
    lateral: f64,
}

impl SlipMobility {
    /// Of a wheelset whose wheels have this `radius` (m).
    pub fn new(wheelset: &RigidBody, radius: f64) -> Self {
        let (inertia, inverse_mass) = (&wheelset.inertia, 1.0 / wheelset.mass);
        let square = radius * radius;
        Self {
            longitudinal: inverse_mass + square / inertia.y,
            lateral: inverse_mass + square / inertia.x,
        }
    }

    /// Reduces the damping of `creep` to what counts at the end of a `step` (s); its forces stay.
    #[inline]
    pub fn reduce(&self, creep: &mut CreepForces, step: f64) {
        let damping = &mut creep.damping;
        damping.longitudinal *= share(step * damping.longitudinal * self.longitudinal);
        damping.lateral *= share(step * damping.lateral * self.lateral);
    }
}

/// Share of a creep of stiffness x that counts at the end of a step.
#[inline]
fn share(x: f64) -> f64 {
    let square = x * x;
    square / (1.0 + square)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A slip that only the creep of one wheel, or of both, changes falls and keeps its sign, for every
    /// stiffness from 1e-3 to 1e6; for both it is (1 - x)²/(1 + x² + 2 x³) of what it was.
    #[test]
    fn property_creep_alone_never_turns_the_slip_round() {
        for n in -30..=60 {
            let x = 10_f64.powf(0.1 * f64::from(n));
            let left = |wheels: f64| 1.0 - wheels * x / (1.0 + wheels * x * share(x));
            for wheels in [1.0, 2.0] {
                let left = left(wheels);
                assert!((-1e-12..1.0).contains(&left), "stiffness {x}, {wheels} wheels: {left}");
            }
            let expected = (1.0 - x).powi(2) / (1.0 + x * x + 2.0 * x.powi(3));
            assert!((left(2.0) - expected).abs() < 1e-12, "stiffness {x}: {}", left(2.0));
        }
    }
}
