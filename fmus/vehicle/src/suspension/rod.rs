//! Rod with a joint at either end, such as a traction rod: F = -k (l - l0) - c dl/dt along the line
//! between its joints, whose length is l (eq. 29). Unlike a spring at one point it swings, so that it
//! pulls aside when the bodies move across.

use nalgebra::Vector3;

use super::energy::ElementEnergy;
use super::pair::{Between, Point};

/// A rod between two bodies.
#[derive(Clone, Debug)]
pub struct Rod {
    /// Its joint on the first body.
    pub at: Point,
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
    pub fn apply(&self, between: &mut Between, energy: &mut ElementEnergy) {
        let arm = &self.at.arm;
        let joint = arm + between.rotation.cross(arm);
        let line = self.line
            + between.displacement
            + between.turned.cross(&(arm + self.line))
            + between.rotation.cross(&self.line);
        let length = line.norm();
        let along = line / length;
        // What the line turns with the first body is square to it.
        let rate = along.dot(&(between.velocity + between.turning.cross(&(joint + line))));
        let stretch = length - self.line.norm();
        let force = -(self.preload + self.stiffness * stretch + self.damping * rate) * along;
        between.push_at(&joint, &force);
        energy.stored += stretch * (self.preload + 0.5 * self.stiffness * stretch);
        energy.dissipated += self.damping * rate * rate;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::Seen;
    use crate::suspension::pair::Pair;

    /// A rod of 1 m whose end moves 1 mm along and 0.1 m across: its length is sqrt(1.001² + 0.1²),
    /// and its pull has the direction of the line.
    #[test]
    fn analytic_a_rod_swings() {
        let rod = Rod {
            at: Point::TEST,
            line: Vector3::new(1.0, 0.0, 0.0),
            stiffness: 1e6,
            damping: 0.0,
            preload: 0.0,
        };
        let moved = Seen { displacement: Vector3::new(0.001, 0.1, 0.0), ..Seen::default() };
        let mut between = Pair::TEST.between(&[Seen::default(), moved]);
        rod.apply(&mut between, &mut ElementEnergy::default());
        let length = 1.001_f64.hypot(0.1);
        let expected = -1e6 * (length - 1.0) / length * Vector3::new(1.001, 0.1, 0.0);
        assert!((between.force - expected).norm() < 1e-6);
    }
}
