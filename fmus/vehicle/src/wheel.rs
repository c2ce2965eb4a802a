//! One wheel on its rail: where it touches, how hard, and how it slips.
//!
//! Rows `longitudinal`, `lateral` and `normal` give the velocity of the wheel's contact point in
//! the three directions of the contact from the wheelset's velocities (vx, vy, vz, wx, wy, wz);
//! their transposes carry the forces back, so that force and slip have the same power.

use contact::{ContactPatch, ContactPoint, CreepForces, GeometryTable, Polach, SlipVelocity};

use crate::body::BodyState;
use crate::six::{Six, dot};

/// Rail on which a wheel runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Left rail.
    Left,
    /// Right rail.
    Right,
}

impl Side {
    /// -1 on the left, +1 on the right.
    pub fn sign(self) -> f64 {
        match self {
            Self::Left => -1.0,
            Self::Right => 1.0,
        }
    }
}

/// Dimensions of a wheel.
#[derive(Clone, Copy, Debug)]
pub struct WheelData {
    /// Radius of the running circle, m.
    pub radius: f64,
    /// Distance of the running circle from the track's middle, m.
    pub half_distance: f64,
    /// Damping force over normal force for a speed of approach, s/m.
    pub damping: f64,
}

/// A wheel at one place, before its forces are known.
#[derive(Clone, Copy, Debug)]
pub struct Wheel {
    /// Geometry from the table.
    point: ContactPoint,
    /// Elastic approach along the normal, m; zero or negative without contact (eq. 17).
    approach: f64,
    /// Normal force without damping, N (eq. 18).
    elastic_force: f64,
    /// Row of the longitudinal slip (eq. 20).
    pub longitudinal: Six,
    /// Row of the lateral slip in the contact plane (eq. 21).
    pub lateral: Six,
    /// Row of the speed of approach along the normal (eq. 19).
    pub normal: Six,
    /// Row of the rotation about the normal (eq. 22).
    spin: Six,
}

/// Forces of a contact at the beginning of a step, and how they change with slip.
#[derive(Clone, Copy, Debug, Default)]
pub struct Linearised {
    /// Normal force, N.
    pub normal: f64,
    /// Its change with the speed of approach, N s/m.
    pub normal_damping: f64,
    /// Creep forces on the wheel.
    pub creep: CreepForces,
    /// Semi-axis of the contact in the rolling direction, m.
    pub a: f64,
    /// Semi-axis across, m.
    pub b: f64,
}

impl Wheel {
    /// The wheel on `side` of a wheelset at `state`.
    #[inline]
    pub fn new(side: Side, data: &WheelData, table: &GeometryTable, state: &BodyState) -> Self {
        let sign = side.sign();
        let (roll, yaw) = (state.rotation.x, state.rotation.z);
        // Eq. 16: shift towards the flange, and descent of the contact point.
        let point = table.at(sign * (state.position.y - data.radius * roll));
        let across = sign * (data.half_distance + point.wheel_lateral);
        let descent = state.position.z + across * roll;
        let approach = (descent - point.drop) * point.cos_angle;
        let pressed = approach.max(0.0);
        let radius = data.radius + point.radius_change + pressed * point.cos_angle;
        let (sin, cos) = (sign * point.sin_angle, point.cos_angle);
        Self {
            point,
            approach,
            elastic_force: point.hertz.normal_force(approach),
            longitudinal: [1.0, yaw, 0.0, 0.0, radius, -across],
            lateral: [-yaw * cos, cos, -sin, -radius * cos - across * sin, 0.0, 0.0],
            normal: [0.0, sin, cos, -radius * sin + across * cos, 0.0, 0.0],
            spin: [0.0, 0.0, 0.0, 0.0, sin + roll * cos, cos],
        }
    }

    /// Forces with the wheelset's velocities against the track's frame; `speed` is that of travel.
    #[inline]
    pub fn forces(
        &self,
        data: &WheelData,
        creep: &Polach,
        velocities: &Six,
        speed: f64,
    ) -> Linearised {
        let normal_damping = self.elastic_force * data.damping;
        let normal = self.elastic_force + normal_damping * dot(&self.normal, velocities);
        if normal.is_nan() || normal <= 0.0 {
            return Linearised::default();
        }
        let patch: ContactPatch = self.point.patch(normal);
        Linearised {
            normal,
            normal_damping,
            creep: creep.force(&patch, &self.slip(velocities), speed),
            a: patch.a,
            b: patch.b,
        }
    }

    /// Slip of the wheel on the rail.
    #[inline]
    pub fn slip(&self, velocities: &Six) -> SlipVelocity {
        SlipVelocity {
            longitudinal: dot(&self.longitudinal, velocities),
            lateral: dot(&self.lateral, velocities),
            spin: dot(&self.spin, velocities),
        }
    }

    /// The row of the rotation about the normal.
    pub fn spin_row(&self) -> &Six {
        &self.spin
    }

    /// Lateral force in the plane of the rails of creep and normal force, N.
    pub fn across(&self, lateral: f64, normal: f64) -> f64 {
        lateral * self.lateral[1] - normal * self.normal[1]
    }

    /// Force upwards, square to the plane of the rails, of creep and normal force, N.
    pub fn upwards(&self, lateral: f64, normal: f64) -> f64 {
        normal * self.normal[2] - lateral * self.lateral[2]
    }

    /// Normal force without damping, N.
    pub fn elastic_force(&self) -> f64 {
        self.elastic_force
    }

    /// Place of the contact on the rail head, m from its top, negative towards the gauge side.
    pub fn rail_lateral(&self) -> f64 {
        self.point.rail_lateral
    }

    /// Whether the wheel has left its profile: climbed over the rail or fallen off it.
    pub fn derailed(&self) -> bool {
        self.point.beyond
    }

    /// Elastic energy of the contact, J: the integral of the normal force over the approach.
    pub fn elastic_energy(&self) -> f64 {
        0.4 * self.elastic_force * self.approach.max(0.0)
    }
}
