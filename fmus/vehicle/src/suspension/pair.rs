//! Two bodies that elements join: how they move against each other, and what passes between them.
//!
//! All elements between two bodies share most of equations 10 and 11. With the arm r of an element's
//! point from the first body's centre of mass, the arm c from the second one's to the first one's at
//! rest, the arm s from the first one's to the second one's now, and differences Δ second less first:
//!
//! ```text
//! ū = (Δd + θ₂ × c) + Δθ × r     m = r + θ₁ × r + ū/2     w = (Δv - ω₂ × s) + Δω × m
//! ```
//!
//! where m is the arm to the middle of the stretched element. The sums F and M of the forces on the
//! second body and of m × force give the first body -F and -M, the second F and M - s × F.

use nalgebra::Vector3;

use crate::body::{Seen, Wrench};

/// Two bodies that elements join.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    /// Indices of the bodies.
    pub bodies: [usize; 2],
    /// From the centre of mass of the second to that of the first at rest, m.
    pub offset: Vector3<f64>,
}

/// A point at which an element joins two bodies.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Index of the pair of bodies.
    pub pair: usize,
    /// Arm from the first body's centre of mass at rest, m.
    pub arm: Vector3<f64>,
}

/// Motion of a pair's second body against the first, and what their elements do to the second.
#[derive(Clone, Copy, Debug, Default)]
pub struct Between {
    /// Displacement of the second body against the first at the first one's centre of mass, m.
    pub displacement: Vector3<f64>,
    /// Rotation of the first body, rad.
    pub rotation: Vector3<f64>,
    /// Rotation against each other, rad.
    pub turned: Vector3<f64>,
    /// Velocity against each other at the first one's centre of mass, m/s.
    pub velocity: Vector3<f64>,
    /// Angular velocity against each other, rad/s.
    pub turning: Vector3<f64>,
    /// Rotation of the elements' axes: mean of both bodies, rad.
    tilt: Vector3<f64>,
    /// From the first body's centre of mass to the second one's, m.
    arm_to_second: Vector3<f64>,
    /// Force of the elements on the second body, N.
    pub force: Vector3<f64>,
    /// Moment of the elements on the second body about the first one's centre of mass, N m.
    pub moment: Vector3<f64>,
}

/// How an element is stretched, in axes that turn with both bodies.
#[derive(Clone, Copy, Debug)]
pub struct Stretch {
    /// Displacement of the second end against the first, m (eq. 10).
    pub length: Vector3<f64>,
    /// Its rate, m/s (eq. 11).
    pub rate: Vector3<f64>,
    /// Arm to the middle of the stretched element, m.
    middle: Vector3<f64>,
}

impl Pair {
    /// How the bodies move against each other; nothing passes between them yet.
    #[inline]
    pub fn between(&self, seen: &[Seen]) -> Between {
        let [first, second] = self.bodies.map(|body| &seen[body]);
        let displaced = second.displacement - first.displacement;
        let arm_to_second = displaced - self.offset;
        Between {
            displacement: displaced + second.rotation.cross(&self.offset),
            rotation: first.rotation,
            turned: second.rotation - first.rotation,
            velocity: second.velocity
                - first.velocity
                - second.angular_velocity.cross(&arm_to_second),
            turning: second.angular_velocity - first.angular_velocity,
            tilt: 0.5 * (first.rotation + second.rotation),
            arm_to_second,
            ..Between::default()
        }
    }

    /// Adds to both bodies what passes between them.
    #[inline]
    pub fn pass_on(&self, between: &Between, wrenches: &mut [Wrench]) {
        let Between { force, moment, arm_to_second, .. } = between;
        let first = &mut wrenches[self.bodies[0]];
        first.force -= force;
        first.moment -= moment;
        let second = &mut wrenches[self.bodies[1]];
        second.force += force;
        second.moment += moment - arm_to_second.cross(force);
    }
}

impl Between {
    /// Displacement of the second body against the first at this arm, m: ū of equation 10.
    #[inline(always)]
    pub fn displacement_at(&self, arm: &Vector3<f64>) -> Vector3<f64> {
        self.displacement + self.turned.cross(arm)
    }

    /// How an element at this arm is stretched.
    ///
    /// It is compiled into each kind of element, so that what an element does not need costs nothing.
    #[inline(always)]
    pub fn stretch(&self, arm: &Vector3<f64>) -> Stretch {
        let displaced = self.displacement_at(arm);
        let middle = arm + self.rotation.cross(arm) + 0.5 * displaced;
        let rate = self.velocity + self.turning.cross(&middle);
        Stretch {
            length: displaced - self.tilt.cross(&displaced),
            rate: rate - self.tilt.cross(&rate),
            middle,
        }
    }

    /// Applies `force`, in the element's axes, to the second body and its opposite to the first.
    ///
    /// Both act at the middle of the stretched element, so that no moment is lost.
    #[inline(always)]
    pub fn push(&mut self, stretch: &Stretch, force: &Vector3<f64>) {
        self.push_at(&stretch.middle, &(force + self.tilt.cross(force)));
    }

    /// Applies `force`, in the common frame, to the second body and its opposite to the first.
    ///
    /// Both act at this arm from the first body's centre of mass.
    #[inline]
    pub fn push_at(&mut self, arm: &Vector3<f64>, force: &Vector3<f64>) {
        self.force += force;
        self.moment += arm.cross(force);
    }
}

#[cfg(test)]
impl Pair {
    /// The bodies 0 and 1, whose centres of mass coincide at rest.
    pub(super) const TEST: Self = Self { bodies: [0, 1], offset: Vector3::new(0.0, 0.0, 0.0) };
}

#[cfg(test)]
impl Point {
    /// The centres of mass of such bodies.
    pub(super) const TEST: Self = Self { pair: 0, arm: Vector3::new(0.0, 0.0, 0.0) };
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The second body's centre of mass lies at (1, 0, 0.3) from the first one's.
    const PAIR: Pair = Pair { bodies: [0, 1], offset: Vector3::new(-1.0, 0.0, -0.3) };
    const ARM: Vector3<f64> = Vector3::new(1.0, -1.2, 0.3);

    fn moved() -> [Seen; 2] {
        let first = Seen {
            displacement: Vector3::new(-0.02, 0.01, 0.005),
            rotation: Vector3::new(-0.002, 0.001, 0.004),
            velocity: Vector3::new(0.1, 0.2, -0.1),
            angular_velocity: Vector3::new(0.03, -0.01, 0.02),
        };
        let second = Seen {
            displacement: Vector3::new(0.01, 0.03, -0.02),
            rotation: Vector3::new(0.001, 0.002, 0.003),
            velocity: Vector3::new(-0.2, 0.1, 0.3),
            angular_velocity: Vector3::new(0.01, 0.04, -0.05),
        };
        [first, second]
    }

    /// Equations 10 and 11 as they stand, with the arms of both bodies.
    #[test]
    fn analytic_stretch_and_rate_by_both_arms() {
        let seen = moved();
        let arms = [ARM, ARM + PAIR.offset];
        let turned = [0, 1].map(|i| arms[i] + seen[i].rotation.cross(&arms[i]));
        let displaced = seen[1].displacement - seen[0].displacement + (turned[1] - arms[1])
            - (turned[0] - arms[0]);
        let middle = [turned[0] + 0.5 * displaced, turned[1] - 0.5 * displaced];
        let moving = [0, 1].map(|i| seen[i].velocity + seen[i].angular_velocity.cross(&middle[i]));
        let rate = moving[1] - moving[0];
        let tilt = 0.5 * (seen[0].rotation + seen[1].rotation);

        let stretch = PAIR.between(&seen).stretch(&ARM);
        assert!((stretch.length - (displaced - tilt.cross(&displaced))).norm() < 1e-15);
        assert!((stretch.rate - (rate - tilt.cross(&rate))).norm() < 1e-15);
    }

    /// Two bodies that move and turn as one do not stretch an element (small angles).
    #[test]
    fn property_a_common_small_motion_does_not_stretch() {
        let turn = Vector3::new(1e-5, -2e-5, 3e-5);
        let rate = Vector3::new(0.01, 0.02, -0.03);
        let at = |arm: Vector3<f64>| Seen {
            displacement: turn.cross(&arm),
            rotation: turn,
            velocity: rate.cross(&arm),
            angular_velocity: rate,
        };
        let stretch = PAIR.between(&[at(Vector3::zeros()), at(-PAIR.offset)]).stretch(&ARM);
        // What is left is of second order in the angles.
        assert!(stretch.length.norm() < 1e-8);
        assert!(stretch.rate.norm() < 1e-5);
    }

    /// Force and moment of an element on both bodies together vanish about any point.
    #[test]
    fn property_an_element_keeps_momentum_and_angular_momentum() {
        let seen = moved();
        let mut between = PAIR.between(&seen);
        let stretch = between.stretch(&ARM);
        between.push(&stretch, &Vector3::new(1e3, 2e3, 1e5));
        let mut wrenches = [Wrench::default(); 2];
        PAIR.pass_on(&between, &mut wrenches);
        let arm_to_second = seen[1].displacement - seen[0].displacement - PAIR.offset;
        let moment =
            wrenches[0].moment + wrenches[1].moment + arm_to_second.cross(&wrenches[1].force);
        assert!((wrenches[0].force + wrenches[1].force).norm() < 1e-9);
        assert!(moment.norm() < 1e-9);
    }
}
