//! The rails under a wheelset: how far they lie off their design, and how they move.
//!
//! Irregularities come with the track. An elastic support lets each rail give way at each wheel: a
//! massless rail on a spring k and a damper c, across and down (eq. 34),
//!
//!   c dd/dt + k d = F,
//!
//! where F is the force of the wheel on the rail. As F falls with the deflection (stiffness K of the
//! contact) and with its rate (creep D), a step h takes both at its end:
//!
//!   v = (F - k d + D v0)/(c + D + h (k + K)),   d -> d + h v.

use nalgebra::{Vector2, Vector3};
use serde::{Deserialize, Serialize};
use track::{RailOffset, Support};

use crate::body::BodyState;
use crate::contact::WheelOutput;
use crate::contact::six::Six;
use crate::energy::Account;

/// Least slip, m/s, by which the slope of the creep force is estimated.
const LEAST_SLIP: f64 = 1e-4;

/// Displacement and velocity of a rail at a wheel from its design, across and down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RailMotion {
    /// Displacement, m.
    pub displacement: Vector2<f64>,
    /// Velocity, m/s.
    pub velocity: Vector2<f64>,
}

/// How far a rail has given way at a wheel, across and down.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Deflection {
    /// Deflection d, m.
    pub displacement: Vector2<f64>,
    /// Its rate v in the last step, m/s.
    pub velocity: Vector2<f64>,
}

impl RailMotion {
    /// The rail with this irregularity that a wheel meets at `speed`, and this deflection.
    #[inline]
    pub fn new(offset: &RailOffset, speed: f64, deflection: &Deflection) -> Self {
        let irregularity = Vector2::new(offset.lateral, offset.vertical);
        let slope = Vector2::new(offset.lateral_slope, offset.vertical_slope);
        Self {
            displacement: irregularity + deflection.displacement,
            velocity: speed * slope + deflection.velocity,
        }
    }

    /// A wheelset seen from this rail.
    #[inline]
    pub fn seen_from(&self, state: &BodyState) -> BodyState {
        let [across, down] = [self.displacement.x, self.displacement.y];
        BodyState { position: state.position - Vector3::new(0.0, across, down), ..*state }
    }

    /// Velocities of a wheelset against this rail.
    #[inline]
    pub fn against(&self, velocities: &Six) -> Six {
        let mut against = *velocities;
        against[1] -= self.velocity.x;
        against[2] -= self.velocity.y;
        against
    }
}

impl Deflection {
    /// Brings the deflection to the end of a step under the forces of `wheel`.
    pub fn step(
        &mut self,
        support: &Support,
        wheel: &WheelOutput,
        speed: f64,
        step: f64,
        account: &mut Account,
    ) {
        let force = Vector2::new(-wheel.guiding, wheel.vertical);
        let contact = contact_stiffness(wheel);
        let creep = creep_slope(wheel, speed);
        let before = *self;
        for axis in [0, 1] {
            let (k, c) = (support.stiffness[axis], support.damping[axis]);
            let slope = if axis == 0 { creep } else { 0.0 };
            let pull = force[axis] - k * before.displacement[axis];
            self.velocity[axis] =
                (pull + slope * before.velocity[axis]) / (c + slope + step * (k + contact));
            self.displacement[axis] += step * self.velocity[axis];
            account.track_heat +=
                step * self.velocity[axis] * (force[axis] - k * self.middle(&before)[axis]);
        }
    }

    /// The deflection at which the support carries the wheel at rest.
    pub fn at_rest(support: &Support, wheel: &WheelOutput) -> Self {
        let force = Vector2::new(-wheel.guiding, wheel.vertical);
        let displacement = force.component_div(&Vector2::from(support.stiffness));
        Self { displacement, velocity: Vector2::zeros() }
    }

    /// Elastic energy of the support, J.
    pub fn elastic_energy(&self, support: &Support) -> f64 {
        let square = self.displacement.component_mul(&self.displacement);
        0.5 * square.dot(&Vector2::from(support.stiffness))
    }

    fn middle(&self, before: &Self) -> Vector2<f64> {
        0.5 * (self.displacement + before.displacement)
    }
}

/// Stiffness of Hertz's contact, which stores 2/5 of force times approach: 3/2 F over the approach.
fn contact_stiffness(wheel: &WheelOutput) -> f64 {
    match wheel.elastic_energy > 0.0 {
        true => 0.6 * wheel.total.force.normal * wheel.total.force.normal / wheel.elastic_energy,
        false => 0.0,
    }
}

/// Creep force over slip velocity.
fn creep_slope(wheel: &WheelOutput, speed: f64) -> f64 {
    let creepage = libm::hypot(wheel.total.creepages.longitudinal, wheel.total.creepages.lateral);
    let slip = (creepage * speed.abs()).max(LEAST_SLIP);
    libm::hypot(wheel.total.force.longitudinal, wheel.total.force.lateral) / slip
}

#[cfg(test)]
mod tests {
    use super::*;

    const SUPPORT: Support = Support { stiffness: [25e6, 60e6], damping: [50e3, 100e3] };

    /// A wheel that pushes its rail down and to the left without changing with its motion.
    fn wheel() -> WheelOutput {
        WheelOutput { guiding: 10e3, vertical: 100e3, ..WheelOutput::default() }
    }

    /// Under a constant force the deflection is F/k (1 - exp(-k t/c)) (equation 34); at rest F/k.
    /// Tolerance: steps of 0.01 ms against time constants of 1.7 and 2 ms.
    #[test]
    fn analytic_deflection_under_a_constant_force() {
        let (mut deflection, mut account) = (Deflection::default(), Account::default());
        let step = 1e-5;
        for _ in 0..200 {
            deflection.step(&SUPPORT, &wheel(), 10.0, step, &mut account);
        }
        for (axis, force) in [(0, -10e3), (1, 100e3)] {
            let (k, c) = (SUPPORT.stiffness[axis], SUPPORT.damping[axis]);
            let expected = force / k * (1.0 - (-k * 2e-3 / c).exp());
            let found = deflection.displacement[axis];
            assert!((found / expected - 1.0).abs() < 0.01, "{found} m, expected {expected} m");
        }
        let rest = Deflection::at_rest(&SUPPORT, &wheel()).displacement;
        assert!((rest - Vector2::new(-10e3 / 25e6, 100e3 / 60e6)).norm() < 1e-15);
    }

    /// Work of the force less what the spring stores is the heat in the damper.
    #[test]
    fn property_the_support_accounts_for_all_energy() {
        let (mut deflection, mut account) = (Deflection::default(), Account::default());
        let (mut work, force) = (0.0, Vector2::new(-10e3, 100e3));
        for _ in 0..100 {
            let before = deflection;
            deflection.step(&SUPPORT, &wheel(), 10.0, 1e-3, &mut account);
            work += force.dot(&(deflection.displacement - before.displacement));
        }
        let stored = deflection.elastic_energy(&SUPPORT);
        assert!((work - stored - account.track_heat).abs() < 1e-9 * work, "{work} J");
    }

    /// A wheelset is seen from its rail, and moves against it.
    #[test]
    fn analytic_a_displaced_rail() {
        let offset = RailOffset { lateral: 2e-3, vertical: -1e-3, ..RailOffset::default() };
        let deflection = Deflection { velocity: Vector2::new(0.1, 0.2), ..Deflection::default() };
        let rail = RailMotion::new(&offset, 20.0, &deflection);
        let seen = rail.seen_from(&BodyState::default()).position;
        assert_eq!([seen.y, seen.z], [-2e-3, 1e-3]);
        assert_eq!(rail.against(&[1.0; 6]), [1.0, 0.9, 0.8, 1.0, 1.0, 1.0]);
    }
}
