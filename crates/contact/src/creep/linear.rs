//! Kalker's linear theory, and Shen, Hedrick and Elkins' limit of it.
//!
//! The linear forces of [`kalker`](crate::kalker) hold for small creepages only; without limit they serve
//! for eigenvalues. Shen, Hedrick and Elkins (8th IAVSD Symposium, 1983) reduce them by
//!
//! ```text
//! F'/F = 1 - u/3 + u²/27  for u = F/(mu N) < 3,  1/u above,   F² = Fx² + Fy²                       (C9)
//! ```
//!
//! which is good for small spin. Beyond the source, the spin moment is kept and reduced alike: force and
//! moment together then never give power to the wheel.

use super::friction::Friction;
use super::{CreepDamping, CreepForces, SlipVelocity, TangentialForce, reference_speed};
use crate::geometry::contact_point::ContactPatch;
use crate::material::STEEL;

/// The share of Kalker's forces that is left of a force `u` times mu N (C9).
fn share(u: f64) -> f64 {
    if u < 3.0 { 1.0 - u / 3.0 + u * u / 27.0 } else { 1.0 / u }
}

/// Kalker's linear forces on the wheel, without limit.
pub(crate) fn linear(patch: &ContactPatch, slip: &SlipVelocity, speed: f64) -> CreepForces {
    let per_speed = 1.0 / reference_speed(speed);
    let direction = 1.0_f64.copysign(speed);
    let area = patch.a * patch.b;
    let (stiffness, kalker) = (STEEL.shear_modulus * area * per_speed, &patch.kalker);
    let coupling = stiffness * area.sqrt() * kalker.c23;
    let damping =
        CreepDamping { longitudinal: stiffness * kalker.c11, lateral: stiffness * kalker.c22 };
    let spin_damping = stiffness * area * kalker.c33;
    let spin_force = -direction * coupling * slip.spin;
    CreepForces {
        force: TangentialForce {
            longitudinal: damping.longitudinal * slip.longitudinal,
            lateral: spin_force - damping.lateral * slip.lateral,
        },
        spin_moment: direction * coupling * slip.lateral - spin_damping * slip.spin,
        friction_power: damping.longitudinal * slip.longitudinal * slip.longitudinal
            + damping.lateral * slip.lateral * slip.lateral
            + spin_damping * slip.spin * slip.spin,
        damping,
        spin_force,
        flash_factor: 1.0,
    }
}

/// The same reduced so that they stay below friction (C9).
pub(crate) fn limited(
    friction: &Friction,
    patch: &ContactPatch,
    slip: &SlipVelocity,
    speed: f64,
) -> CreepForces {
    let sliding = friction.sliding(patch, slip, speed);
    let limit = sliding.coefficient * patch.normal_force;
    if limit.is_nan() || limit <= 0.0 {
        return CreepForces::default();
    }
    let linear = linear(patch, slip, speed);
    let share = share(libm::hypot(linear.force.longitudinal, linear.force.lateral) / limit);
    let (force, damping) = (&linear.force, &linear.damping);
    CreepForces {
        force: TangentialForce {
            longitudinal: share * force.longitudinal,
            lateral: share * force.lateral,
        },
        spin_moment: share * linear.spin_moment,
        friction_power: share * linear.friction_power,
        damping: CreepDamping {
            longitudinal: share * damping.longitudinal,
            lateral: share * damping.lateral,
        },
        spin_force: share * linear.spin_force,
        flash_factor: sliding.flash,
    }
}
