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
