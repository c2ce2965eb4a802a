//! Spring with parallel damping: F = F0 - K u - C du/dt (eq. 12).

use nalgebra::Vector3;

use super::energy::ElementEnergy;
use super::pair::{Between, Point};

/// A spring without length between two bodies, with its own stiffness and damping in x, y, z.
#[derive(Clone, Debug)]
pub struct Spring {
    /// Where it joins two bodies.
    pub at: Point,
    /// Stiffness K, N/m.
    pub stiffness: Vector3<f64>,
    /// Damping C, N s/m.
    pub damping: Vector3<f64>,
    /// Force F0 on the second body while the vehicle stands on straight level track, N.
    pub preload: Vector3<f64>,
}

impl Spring {
    /// Adds the forces on both bodies.
    #[inline]
    pub fn apply(&self, between: &mut Between, energy: &mut ElementEnergy) {
        let stretch = between.stretch(&self.at.arm);
        let elastic = self.stiffness.component_mul(&stretch.length);
        let viscous = self.damping.component_mul(&stretch.rate);
        between.push(&stretch, &(self.preload - elastic - viscous));
        energy.stored += stretch.length.dot(&(0.5 * elastic - self.preload));
        energy.dissipated += stretch.rate.dot(&viscous);
    }
}
