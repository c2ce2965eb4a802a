//! What all elements have in common: two bodies and a point on each.

use nalgebra::Vector3;

use crate::body::{Seen, Wrench};

/// Two bodies and the arms from their centres of mass to the element's place.
#[derive(Clone, Copy, Debug)]
pub struct Ends {
    /// Indices of the bodies.
    pub bodies: [usize; 2],
    /// Arms at rest, m.
    pub arms: [Vector3<f64>; 2],
}

/// How the second end has moved against the first one, in axes that turn with both bodies.
#[derive(Clone, Copy, Debug)]
pub struct Stretch {
    /// Displacement, m (eq. 10).
    pub length: Vector3<f64>,
    /// Its rate, m/s (eq. 11).
    pub rate: Vector3<f64>,
    /// Rotation of the axes: mean of both bodies, rad.
    tilt: Vector3<f64>,
    /// Arms to the middle of the stretched element, m.
    arms: [Vector3<f64>; 2],
}

impl Ends {
    /// Displacement and rate of the second end against the first.
    #[inline(always)]
    pub fn stretch(&self, seen: &[Seen]) -> Stretch {
        let [first, second] = self.bodies.map(|body| &seen[body]);
        let a = self.arms[0] + first.rotation.cross(&self.arms[0]);
        let b = self.arms[1] + second.rotation.cross(&self.arms[1]);
        let turned = [a - self.arms[0], b - self.arms[1]];
        let apart = second.displacement + turned[1] - first.displacement - turned[0];
        let half = 0.5 * apart;
        let arms = [a + half, b - half];
        let rate = second.velocity + second.angular_velocity.cross(&arms[1])
            - first.velocity
            - first.angular_velocity.cross(&arms[0]);
        let tilt = 0.5 * (first.rotation + second.rotation);
        Stretch { length: apart - tilt.cross(&apart), rate: rate - tilt.cross(&rate), tilt, arms }
    }

    /// Lets `force`, given in the element's axes, act on the second body and its opposite on the
    /// first, both at the middle of the stretched element, so that no moment is lost.
    #[inline(always)]
    pub fn apply(&self, stretch: &Stretch, force: &Vector3<f64>, wrenches: &mut [Wrench]) {
        let force = force + stretch.tilt.cross(force);
        wrenches[self.bodies[1]].add(&force, &stretch.arms[1]);
        wrenches[self.bodies[0]].add(&-force, &stretch.arms[0]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ends() -> Ends {
        Ends { bodies: [0, 1], arms: [Vector3::new(1.0, -1.2, 0.3), Vector3::new(0.0, -1.2, 0.0)] }
    }

    /// Two bodies that move and turn as one do not stretch an element (small angles).
    #[test]
    fn property_a_common_small_motion_does_not_stretch() {
        let turn = Vector3::new(1e-5, -2e-5, 3e-5);
        let rate = Vector3::new(0.01, 0.02, -0.03);
        // The second body's centre of mass lies at (1, 0, 0.3) from the first one's.
        let arm = Vector3::new(1.0, 0.0, 0.3);
        let at = |arm: Vector3<f64>| Seen {
            displacement: turn.cross(&arm),
            rotation: turn,
            velocity: rate.cross(&arm),
            angular_velocity: rate,
        };
        let stretch = ends().stretch(&[at(Vector3::zeros()), at(arm)]);
        // What is left is of second order in the angles.
        assert!(stretch.length.norm() < 1e-8);
        assert!(stretch.rate.norm() < 1e-5);
    }

    /// Force and moment of an element on both bodies together vanish about any point.
    #[test]
    fn property_an_element_keeps_momentum_and_angular_momentum() {
        let second = Seen {
            displacement: Vector3::new(0.01, 0.03, -0.02),
            rotation: Vector3::new(0.001, 0.002, 0.003),
            ..Seen::default()
        };
        let ends = ends();
        let stretch = ends.stretch(&[Seen::default(), second]);
        let mut wrenches = [Wrench::default(); 2];
        ends.apply(&stretch, &Vector3::new(1e3, 2e3, 1e5), &mut wrenches);
        let between = ends.arms[0] - ends.arms[1] + second.displacement;
        let moment = wrenches[0].moment + wrenches[1].moment + between.cross(&wrenches[1].force);
        assert!((wrenches[0].force + wrenches[1].force).norm() < 1e-9);
        assert!(moment.norm() < 1e-9);
    }
}
