//! Rod with a joint at either end, such as a traction rod: F = -k (l - l0) - c dl/dt along the line
//! between its joints, whose length is l (eq. 29). Unlike a spring at one point it swings, so that it
//! pulls aside when the bodies move across.

use nalgebra::Vector3;

use super::ElementEnergy;
use super::ends::Ends;
use crate::body::{Seen, Wrench};

/// A rod between two bodies.
#[derive(Clone, Debug)]
pub struct Rod {
    /// Bodies, and the arms to the joint on each of them.
    pub ends: Ends,
    /// From the joint on the first body to that on the second at rest, m.
    pub line: Vector3<f64>,
    /// Stiffness k, N/m.
    pub stiffness: f64,
    /// Damping c, N s/m.
    pub damping: f64,
    /// Force that draws the joints together while the vehicle stands on straight level track, N.
    pub preload: f64,
}

impl Rod {
    /// Adds the forces on both bodies.
    #[inline]
    pub fn apply(&self, seen: &[Seen], wrenches: &mut [Wrench], energy: &mut ElementEnergy) {
        let [first, second] = self.ends.bodies.map(|body| &seen[body]);
        let turned =
            [first.rotation.cross(&self.ends.arms[0]), second.rotation.cross(&self.ends.arms[1])];
        let line = self.line + second.displacement + turned[1] - first.displacement - turned[0];
        let arms = [self.ends.arms[0] + turned[0], self.ends.arms[1] + turned[1]];
        let length = line.norm();
        let along = line / length;
        let rate = along.dot(
            &(second.velocity + second.angular_velocity.cross(&arms[1])
                - first.velocity
                - first.angular_velocity.cross(&arms[0])),
        );
        let stretch = length - self.line.norm();
        let force = -(self.preload + self.stiffness * stretch + self.damping * rate) * along;
        wrenches[self.ends.bodies[1]].add(&force, &arms[1]);
        wrenches[self.ends.bodies[0]].add(&-force, &arms[0]);
        energy.stored += stretch * (self.preload + 0.5 * self.stiffness * stretch);
        energy.dissipated += self.damping * rate * rate;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rod of 1 m whose end moves 1 mm along and 0.1 m across: its length is sqrt(1.001² + 0.1²),
    /// and its pull has the direction of the line.
    #[test]
    fn analytic_a_rod_swings() {
        let rod = Rod {
            ends: Ends { bodies: [0, 1], arms: [Vector3::zeros(); 2] },
            line: Vector3::new(1.0, 0.0, 0.0),
            stiffness: 1e6,
            damping: 0.0,
            preload: 0.0,
        };
        let moved = Seen { displacement: Vector3::new(0.001, 0.1, 0.0), ..Seen::default() };
        let mut wrenches = [Wrench::default(); 2];
        rod.apply(&[Seen::default(), moved], &mut wrenches, &mut ElementEnergy::default());
        let length = 1.001_f64.hypot(0.1);
        let expected = -1e6 * (length - 1.0) / length * Vector3::new(1.001, 0.1, 0.0);
        assert!((wrenches[1].force - expected).norm() < 1e-6);
        assert!((wrenches[0].force + expected).norm() < 1e-6);
    }
}
