//! How a contact moves with its wheelset, and how its forces act on it.
//!
//! Each row gives one velocity of the contact from the wheelset's six (vx, vy, vz, wx, wy, wz):
//! longitudinal slip, positive in traction; lateral slip, to the right; approach, towards the rail; and
//! rotation about the normal. The transposed rows carry the forces back, so that force and slip have the
//! same power. Traction drives the wheelset against its longitudinal slip, as the normal force pushes it
//! against the approach; so these two forces go back with a minus. Of each row only the entries that are
//! not zero are kept, at the indices below.

use contact::{CreepForces, PressedPatch, SlipVelocity};

use super::six::{Six, SixBySix, add, add_outer, dot};
use super::wheel_motion::WheelMotion;

/// Entries of the row of the longitudinal slip that are not zero.
const LONGITUDINAL: [usize; 4] = [0, 1, 4, 5];

/// Those of the row of the lateral slip.
const LATERAL: [usize; 6] = [0, 1, 2, 3, 4, 5];

/// Those of the row of the approach.
const NORMAL: [usize; 5] = [0, 1, 2, 3, 5];

/// Those of the row of the rotation about the normal.
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

impl Rows {
    /// The rows of a pressed contact of a wheel in motion.
    #[inline]
    pub fn new(pressed: &PressedPatch, wheel: &WheelMotion) -> Self {
        let (PressedPatch { point, .. }, data) = (pressed, wheel.data);
        let sign = wheel.side.sign();
        let (roll, yaw) = (wheel.state.rotation.x, wheel.state.rotation.z);
        let (sin, cos) = (sign * point.sin_angle, point.cos_angle);
        let radius = data.radius + point.radius_change + pressed.approach * cos;
        let across = sign * (data.half_distance + point.wheel_lateral);
        // Under yaw the contact lies ahead of the axle or behind it (eq. 17a); tan = -slope. There it
        // is less far below the axle.
        let turned = -sign * yaw * point.slope;
        let ahead = radius * turned;
        let below = radius * (1.0 - 0.5 * turned * turned);
        // The derivatives of the table's coordinates (eq. 16), so that the normal force does the work of
        // the elastic energy.
        let (by_shift, by_descent) = (sign * pressed.by_shift, pressed.by_descent);
        let arm = sign * (data.half_distance + pressed.roll_arm);
        let by_yaw = 2.0 * yaw * pressed.by_yaw_squared;
        Self {
            longitudinal: [-1.0, -yaw, -below, across],
            lateral: [
                -yaw * cos,
                cos,
                -sin,
                -radius * cos - across * sin,
                ahead * sin,
                ahead * cos,
            ],
            normal: [
                -wheel.turning * by_yaw,
                by_shift,
                by_descent,
                arm * by_descent - data.radius * by_shift,
                by_yaw,
            ],
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

    /// Adds the contact's `forces` to `right`, and `step` times their damping to `matrix` (eq. 25).
    #[inline]
    pub fn add(&self, forces: &Linearised, step: f64, matrix: &mut SixBySix, right: &mut Six) {
        let Linearised { normal, normal_damping, creep, .. } = forces;
        add_outer(LONGITUDINAL, &self.longitudinal, step * creep.damping.longitudinal, matrix);
        add_outer(LATERAL, &self.lateral, step * creep.damping.lateral, matrix);
        add_outer(NORMAL, &self.normal, step * normal_damping, matrix);
        add(LONGITUDINAL, &self.longitudinal, -creep.force.longitudinal, right);
        add(LATERAL, &self.lateral, creep.force.lateral, right);
        add(SPIN, &self.spin, creep.spin_moment, right);
        add(NORMAL, &self.normal, -normal, right);
    }

    /// Lateral force in the plane of the rails of creep and normal force, N.
    pub fn across(&self, lateral: f64, normal: f64) -> f64 {
        lateral * self.lateral[1] - normal * self.normal[1]
    }

    /// Force upwards, square to the plane of the rails, of creep and normal force, N.
    pub fn upwards(&self, lateral: f64, normal: f64) -> f64 {
        normal * self.normal[2] - lateral * self.lateral[2]
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

#[cfg(test)]
mod tests {
    use contact::{GeometryTable, ProfilePair, RailProfile, TangentialForce, WheelProfile};

    use super::*;
    use crate::body::BodyState;
    use crate::contact::{Side, WheelData};

    const RADIUS: f64 = 0.46;

    /// Rows of every contact of a wheel of S1002 on 60E1 that stands like this, 0.1 mm pressed.
    fn rows(side: Side, lateral: f64, yaw: f64) -> Vec<(Rows, f64)> {
        let pair = ProfilePair::standard_gauge(
            WheelProfile::S1002,
            RailProfile::Rail60E1,
            1.0 / 40.0,
            RADIUS,
        );
        let table = GeometryTable::shared(&pair).unwrap();
        let half_distance = pair.running_circle();
        let data = WheelData { radius: RADIUS, half_distance, damping: 0.0 };
        let mut state = BodyState::default();
        (state.position.y, state.rotation.z) = (lateral, yaw);
        let table_row = table.row(side.sign() * lateral);
        state.position.z = table.at(side.sign() * lateral).drop + 1e-4;
        let motion = WheelMotion {
            side,
            data: &data,
            state: &state,
            velocities: &Six::default(),
            speed: 10.0,
            turning: 0.0,
        };
        let position = motion.position();
        let contacts = (0..table.patches()).filter_map(|i| table.patch(i, table_row, &position));
        contacts
            .map(|contact| contact.pressed(&position))
            .filter(|pressed| pressed.approach > 0.0)
            .map(|pressed| {
                let change = pressed.point.radius_change;
                let radius = RADIUS + change + pressed.approach * pressed.point.cos_angle;
                (Rows::new(&pressed, &motion), radius)
            })
            .collect()
    }

    /// A wheelset that rolls at v with v/r does not slip; one that turns 1 % faster has 1 % of v as
    /// longitudinal slip, positive as it drives, and a braked one that of the other sign.
    #[test]
    fn analytic_longitudinal_slip_is_positive_in_traction() {
        for side in Side::BOTH {
            let (rows, radius) = rows(side, 0.0, 0.0)[0];
            for share in [0.0, 0.01, -0.01] {
                let turning = -10.0 / radius * (1.0 + share);
                let slip = rows.motion(&[10.0, 0.0, 0.0, 0.0, turning, 0.0]).slip;
                assert!((slip.longitudinal - 10.0 * share).abs() < 1e-12, "{slip:?}");
                assert!(slip.lateral.abs() < 1e-12);
            }
        }
    }

    /// A wheelset yawed to the right by ψ that rolls along the track slips to the left by ψ v.
    #[test]
    fn analytic_yaw_gives_lateral_slip() {
        let (rows, radius) = rows(Side::Right, 0.0, 2e-3)[0];
        let slip = rows.motion(&[10.0, 0.0, 0.0, 0.0, -10.0 / radius, 0.0]).slip;
        // But for the contact angle of some 1.5 degrees.
        assert!((slip.lateral + 0.02).abs() < 5e-5, "{slip:?}");
    }

    /// The forces of a contact do as much work on its wheelset as they do at slip and approach, on
    /// treads and flanges, with yaw and without. Rounding.
    #[test]
    fn property_forces_and_slip_have_the_same_power() {
        let velocities = [10.0, 0.03, -0.01, 0.02, -21.5, 0.05];
        let force = TangentialForce { longitudinal: 7e3, lateral: -4e3 };
        let creep = CreepForces { force, spin_moment: 30.0, ..CreepForces::default() };
        let forces = Linearised { normal: 9e4, creep, ..Linearised::default() };
        let mut contacts = 0;
        for (side, lateral) in [(Side::Left, 0.0), (Side::Right, 4e-3), (Side::Right, 7e-3)] {
            for (rows, _) in rows(side, lateral, 5e-3) {
                let mut wrench = Six::default();
                rows.add(&forces, 0.0, &mut Default::default(), &mut wrench);
                let power: f64 = wrench.iter().zip(velocities).map(|(f, v)| f * v).sum();
                let ContactMotion { slip, approach } = rows.motion(&velocities);
                let expected = -7e3 * slip.longitudinal - 4e3 * slip.lateral + 30.0 * slip.spin
                    - 9e4 * approach;
                assert!((power - expected).abs() < 1e-12 * 9e4 * 10.0, "{power} W, {expected} W");
                contacts += 1;
            }
        }
        assert!(contacts >= 3, "{contacts} contacts press");
    }
}
