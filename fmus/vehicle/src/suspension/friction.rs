//! Dry friction with a constant limit in one direction: Coulomb's law with stick (eq. 30).

use nalgebra::Vector3;

use super::energy::ElementEnergy;
use super::grip::Grip;
use super::pair::{Between, Point};

/// Friction between two bodies.
#[derive(Clone, Debug)]
pub struct Friction {
    /// Where it joins two bodies.
    pub at: Point,
    /// Direction: 0 is x, 1 is y, 2 is z.
    pub axis: usize,
    /// Friction force while sliding, N.
    pub limit: f64,
    /// How it sticks.
    pub grip: Grip,
}

impl Friction {
    /// Brings the friction `force` on the second body to the end of the step and adds it.
    #[inline]
    pub fn apply(
        &self,
        between: &mut Between,
        force: &mut [f64; 2],
        step: f64,
        energy: &mut ElementEnergy,
    ) {
        let stretch = between.stretch(&self.at.arm);
        let trial = self.grip.trial(force, [stretch.rate[self.axis], 0.0], step);
        self.grip.hold(force, trial, self.limit, step, energy);
        let mut along = Vector3::zeros();
        along[self.axis] = force[0];
        between.push(&stretch, &along);
    }
}
