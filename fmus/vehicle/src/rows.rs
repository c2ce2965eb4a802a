//! How a contact moves with its wheelset, and how its forces act on it.
//!
//! Rows `longitudinal`, `lateral` and `normal` give the velocity of the wheel's contact point in
//! the three directions of the contact from the wheelset's velocities (vx, vy, vz, wx, wy, wz);
//! their transposes carry the forces back, so that force and slip have the same power. Of each row
//! only the entries that are not zero are kept, at the places below.

use contact::{ContactPoint, SlipVelocity};
use nalgebra::Vector3;

use crate::patch::Linearised;
use crate::six::{Six, SixBySix, add, add_outer, dot};

/// Places of the row of the longitudinal slip among the six velocities.
const LONGITUDINAL: [usize; 4] = [0, 1, 4, 5];

/// Places of the row of the lateral slip.
const LATERAL: [usize; 6] = [0, 1, 2, 3, 4, 5];

/// Places of the row of the approach.
const NORMAL: [usize; 4] = [1, 2, 3, 5];

/// Places of the row of the rotation about the normal.
const SPIN: [usize; 2] = [4, 5];

/// The four rows of a contact.
#[derive(Clone, Copy, Debug)]
pub struct Rows {
    /// Row of the longitudinal slip (eq. 20).
    longitudinal: [f64; LONGITUDINAL.len()],
    /// Row of the lateral slip in the contact plane (eq. 21).
    lateral: [f64; LATERAL.len()],
    /// Row of the speed of approach along the normal (eq. 19).
    normal: [f64; NORMAL.len()],
    /// Row of the rotation about the normal (eq. 22).
    spin: [f64; SPIN.len()],
}

/// How the wheel moves against the rail in a contact.
#[derive(Clone, Copy, Debug)]
pub struct ContactMotion {
    /// Slip.
    pub slip: SlipVelocity,
    /// Speed of approach along the normal, m/s.
    pub approach: f64,
}

impl Rows {
    /// The rows of a contact of a wheel on the side of `sign` (-1 left, 1 right) that rolls on
    /// `radius` (m), `across` (m) from the middle of a wheelset with this `rotation` (rad).
    #[inline]
    pub fn new(
        point: &ContactPoint,
        sign: f64,
        radius: f64,
        across: f64,
        rotation: &Vector3<f64>,
    ) -> Self {
        let (roll, yaw) = (rotation.x, rotation.z);
        let (sin, cos) = (sign * point.sin_angle, point.cos_angle);
        // Under yaw the contact lies ahead of the axle or behind it (eq. 17a); tan = -slope. There it
        // is less far below the axle.
        let turned = -sign * yaw * point.slope;
        let ahead = radius * turned;
        let below = radius * (1.0 - 0.5 * turned * turned);
        Self {
            longitudinal: [1.0, yaw, below, -across],
            lateral: [
                -yaw * cos,
                cos,
                -sin,
                -radius * cos - across * sin,
                ahead * sin,
                ahead * cos,
            ],
            normal: [sin, cos, -radius * sin + across * cos, (ahead - yaw * across) * sin],
            spin: [sin + roll * cos, cos],
        }
    }

    /// How the contact moves with these velocities of the wheelset.
    #[inline]
    pub fn motion(&self, velocities: &Six) -> ContactMotion {
        ContactMotion {
            slip: SlipVelocity {
                longitudinal: dot(LONGITUDINAL, &self.longitudinal, velocities),
                lateral: dot(LATERAL, &self.lateral, velocities),
                spin: dot(SPIN, &self.spin, velocities),
            },
            approach: dot(NORMAL, &self.normal, velocities),
        }
    }

    /// Adds the `forces` of the contact on the wheelset to `right`, and `step` times their change
    /// with its velocities to `matrix` (eq. 25).
    #[inline]
    pub fn add(&self, forces: &Linearised, step: f64, matrix: &mut SixBySix, right: &mut Six) {
        let Linearised { normal, normal_damping, creep, .. } = forces;
        add_outer(LONGITUDINAL, &self.longitudinal, step * creep.damping, matrix);
        add_outer(LATERAL, &self.lateral, step * creep.lateral_damping, matrix);
        add_outer(NORMAL, &self.normal, step * normal_damping, matrix);
        add(LONGITUDINAL, &self.longitudinal, creep.longitudinal, right);
        add(LATERAL, &self.lateral, creep.lateral, right);
        add(SPIN, &self.spin, creep.spin_moment, right);
        add(NORMAL, &self.normal, -normal, right);
    }

    /// Lateral force in the plane of the rails of creep and normal force, N.
    pub fn across(&self, lateral: f64, normal: f64) -> f64 {
        lateral * self.lateral[1] - normal * self.normal[0]
    }

    /// Force upwards, square to the plane of the rails, of creep and normal force, N.
    pub fn upwards(&self, lateral: f64, normal: f64) -> f64 {
        normal * self.normal[1] - lateral * self.lateral[2]
    }
}

impl ContactMotion {
    /// This motion after `share` of a `change`.
    #[inline]
    #[must_use]
    pub fn after(&self, share: f64, change: &Self) -> Self {
        let (slip, change_of_slip) = (&self.slip, &change.slip);
        Self {
            slip: SlipVelocity {
                longitudinal: slip.longitudinal + share * change_of_slip.longitudinal,
                lateral: slip.lateral + share * change_of_slip.lateral,
                spin: slip.spin + share * change_of_slip.spin,
            },
            approach: self.approach + share * change.approach,
        }
    }
}
