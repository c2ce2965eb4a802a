//! One contact of a wheel with its rail: how hard it presses, and how it slips.
//!
//! Rows `longitudinal`, `lateral` and `normal` give the velocity of the wheel's contact point in
//! the three directions of the contact from the wheelset's velocities (vx, vy, vz, wx, wy, wz);
//! their transposes carry the forces back, so that force and slip have the same power.

use contact::{ContactPatch, ContactPoint, CreepForces, Polach, SlipVelocity};

use crate::body::BodyState;
use crate::six::{Six, dot};
use crate::wheel::{Side, WheelData};

/// A contact at one place, and the forces in it once they are known.
#[derive(Clone, Copy, Debug, Default)]
pub struct Patch {
    /// Number of the patch in the table, from 0.
    pub number: usize,
    /// Geometry from the table.
    point: ContactPoint,
    /// Elastic approach along the normal, m; zero or negative without contact (eq. 17).
    pub approach: f64,
    /// Normal force without damping, N (eq. 18).
    pub elastic_force: f64,
    /// Row of the longitudinal slip (eq. 20).
    pub longitudinal: Six,
    /// Row of the lateral slip in the contact plane (eq. 21).
    pub lateral: Six,
    /// Row of the speed of approach along the normal (eq. 19).
    pub normal: Six,
    /// Row of the rotation about the normal (eq. 22).
    pub spin: Six,
    /// Forces at the beginning of the step.
    pub forces: Linearised,
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

impl Patch {
    /// The contact `number` with this geometry, on the wheel on `side` of a wheelset at `state`,
    /// without its forces.
    #[inline]
    pub fn new(
        number: usize,
        point: ContactPoint,
        side: Side,
        data: &WheelData,
        state: &BodyState,
    ) -> Self {
        let sign = side.sign();
        let (roll, yaw) = (state.rotation.x, state.rotation.z);
        let across = sign * (data.half_distance + point.wheel_lateral);
        let descent = state.position.z + across * roll;
        // The table's shift is that of the running circle's height (eq. 16); the contact lies lower.
        let lower = sign * roll * point.radius_change;
        let approach = (descent - point.drop + point.slope * lower) * point.cos_angle;
        let pressed = approach.max(0.0);
        let radius = data.radius + point.radius_change + pressed * point.cos_angle;
        let (sin, cos) = (sign * point.sin_angle, point.cos_angle);
        // Under yaw the contact lies ahead of the axle or behind it (eq. 17a).
        let ahead = yaw * radius * sin / cos;
        Self {
            number,
            point,
            approach,
            elastic_force: point.hertz.normal_force(approach),
            longitudinal: [1.0, yaw, 0.0, 0.0, radius, -across],
            lateral: [
                -yaw * cos,
                cos,
                -sin,
                -radius * cos - across * sin,
                ahead * sin,
                ahead * cos,
            ],
            normal: [
                0.0,
                sin,
                cos,
                -radius * sin + across * cos,
                0.0,
                (ahead - yaw * across) * sin,
            ],
            spin: [0.0, 0.0, 0.0, 0.0, sin + roll * cos, cos],
            forces: Linearised::default(),
        }
    }

    /// Finds the forces with the wheelset's velocities against the track's frame; `speed` is that
    /// of travel.
    #[inline]
    pub fn load(&mut self, damping: f64, creep: &Polach, velocities: &Six, speed: f64) {
        let normal_damping = self.elastic_force * damping;
        let normal = self.elastic_force + normal_damping * dot(&self.normal, velocities);
        if normal > 0.0 {
            let patch: ContactPatch = self.point.patch(normal);
            self.forces = Linearised {
                normal,
                normal_damping,
                creep: creep.force(&patch, &self.slip(velocities), speed),
                a: patch.a,
                b: patch.b,
            };
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

    /// Lateral force in the plane of the rails of creep and normal force, N.
    pub fn across(&self, lateral: f64, normal: f64) -> f64 {
        lateral * self.lateral[1] - normal * self.normal[1]
    }

    /// Force upwards, square to the plane of the rails, of creep and normal force, N.
    pub fn upwards(&self, lateral: f64, normal: f64) -> f64 {
        normal * self.normal[2] - lateral * self.lateral[2]
    }

    /// Place of the contact on the rail head, m from its top, negative towards the gauge side.
    pub fn rail_lateral(&self) -> f64 {
        self.point.rail_lateral
    }

    /// Contact angle, rad, positive as on a tread.
    pub fn angle(&self) -> f64 {
        self.point.angle()
    }

    /// Elastic energy of the contact, J: the integral of the normal force over the approach.
    pub fn elastic_energy(&self) -> f64 {
        0.4 * self.elastic_force * self.approach.max(0.0)
    }
}
