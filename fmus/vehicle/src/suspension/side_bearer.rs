//! Constant-contact side bearer between a body (first) and its bolster (second): a preloaded spring
//! that goes solid after a gap, and friction on its top (eq. 33):
//!
//!   N = P + k w + k_s max(0, w - g), not negative, for the compression w;   friction at most μ N.

use nalgebra::Vector3;

use super::energy::ElementEnergy;
use super::grip::Grip;
use super::pair::{Between, Point};

/// A side bearer.
#[derive(Clone, Debug)]
pub struct SideBearer {
    /// Where it joins body and bolster.
    pub at: Point,
    /// Force P at rest, N.
    pub preload: f64,
    /// Stiffness k, N/m.
    pub stiffness: f64,
    /// Compression g from rest at which it is solid, m.
    pub solid_gap: f64,
    /// Further stiffness k_s when solid, N/m.
    pub solid_stiffness: f64,
    /// Friction coefficient μ.
    pub friction: f64,
    /// How it sticks.
    pub grip: Grip,
}

impl SideBearer {
    /// Brings the friction `force` on the bolster (x, y) to the end of the step and adds all forces.
    #[inline]
    pub fn apply(
        &self,
        between: &mut Between,
        force: &mut [f64; 2],
        step: f64,
        energy: &mut ElementEnergy,
    ) {
        let stretch = between.stretch(&self.at.arm);
        let compressed = (-stretch.length.z).max(-self.preload / self.stiffness);
        let solid = (compressed - self.solid_gap).max(0.0);
        let normal = self.preload + self.stiffness * compressed + self.solid_stiffness * solid;
        energy.stored += compressed * (self.preload + 0.5 * self.stiffness * compressed)
            + 0.5 * self.solid_stiffness * solid * solid;

        let trial = self.grip.trial(force, [stretch.rate.x, stretch.rate.y], step);
        self.grip.hold(force, trial, self.friction * normal, step, energy);
        between.push(&stretch, &Vector3::new(force[0], force[1], normal));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::Seen;
    use crate::suspension::pair::Pair;

    /// 27 kN and 1 MN/m, solid with 100 MN/m after 6 mm: forces on the bolster by hand at 4 mm and
    /// 7 mm, none after 30 mm of lift, and at most 0.3 N of friction.
    #[test]
    fn analytic_forces() {
        let bearer = SideBearer {
            at: Point::TEST,
            preload: 27e3,
            stiffness: 1e6,
            solid_gap: 6e-3,
            solid_stiffness: 100e6,
            friction: 0.3,
            grip: Grip { stiffness: 5e6 },
        };
        let force = |down: f64| {
            let body = Seen {
                displacement: Vector3::new(0.0, 0.0, down),
                velocity: Vector3::new(1e3, 0.0, 0.0),
                ..Seen::default()
            };
            let mut between = Pair::TEST.between(&[body, Seen::default()]);
            bearer.apply(&mut between, &mut [0.0; 2], 1e-3, &mut ElementEnergy::default());
            between.force
        };
        assert!((force(4e-3) - Vector3::new(9.3e3, 0.0, 31e3)).norm() < 1e-6);
        assert!((force(7e-3) - Vector3::new(40.2e3, 0.0, 134e3)).norm() < 1e-6);
        assert!(force(-30e-3).norm() < 1e-6);
    }
}
