//! Spring against rotation, such as an anti-roll bar (roll alone): M = M0 - K θ - C dθ/dt, where θ
//! is the rotation of the second body against the first (eq. 28).

use nalgebra::Vector3;

use super::energy::ElementEnergy;
use super::pair::Between;

/// A spring between the rotations of two bodies.
#[derive(Clone, Debug)]
pub struct RotationalSpring {
    /// Index of the pair of bodies.
    pub pair: usize,
    /// Stiffness K in roll, pitch, yaw, N m/rad.
    pub stiffness: Vector3<f64>,
    /// Damping C in roll, pitch, yaw, N m s/rad.
    pub damping: Vector3<f64>,
    /// Moment M0 on the second body while the vehicle stands on straight level track, N m.
    pub preload: Vector3<f64>,
}

impl RotationalSpring {
    /// Adds the moments on both bodies.
    #[inline]
    pub fn apply(&self, between: &mut Between, energy: &mut ElementEnergy) {
        let (turned, rate) = (between.turned, between.turning);
        let elastic = self.stiffness.component_mul(&turned);
        let viscous = self.damping.component_mul(&rate);
        between.moment += self.preload - elastic - viscous;
        energy.stored += turned.dot(&(0.5 * elastic - self.preload));
        energy.dissipated += rate.dot(&viscous);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::Seen;
    use crate::suspension::pair::Pair;

    /// An anti-roll bar of 940 kN m/rad and 10 kN m s/rad, rolled by 10 mrad at 0.1 rad/s: 9.4 kN m and
    /// 1 kN m back, 47 J in it and 100 W of heat; other axes are free.
    #[test]
    fn analytic_an_anti_roll_bar_turns_back() {
        let along = |value: f64| Vector3::new(value, 0.0, 0.0);
        let bar = RotationalSpring {
            pair: 0,
            stiffness: along(940e3),
            damping: along(10e3),
            preload: Vector3::zeros(),
        };
        let rolled = Seen {
            rotation: Vector3::new(0.01, 0.02, 0.03),
            angular_velocity: Vector3::new(0.1, 0.2, 0.3),
            ..Seen::default()
        };
        let mut between = Pair::TEST.between(&[Seen::default(), rolled]);
        let mut energy = ElementEnergy::default();
        bar.apply(&mut between, &mut energy);
        assert!((between.moment - along(-9.4e3 - 1e3)).norm() < 1e-9);
        assert!((energy.stored - 47.0).abs() < 1e-9 && (energy.dissipated - 100.0).abs() < 1e-9);
    }
}
