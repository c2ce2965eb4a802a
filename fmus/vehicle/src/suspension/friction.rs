//! Dry friction with a constant limit in one direction: Coulomb's law with stick (eq. 30).

use nalgebra::Vector3;

use super::ElementEnergy;
use super::ends::Ends;
use super::grip::Grip;
use crate::body::{Seen, Wrench};

/// Friction between two bodies.
#[derive(Clone, Debug)]
pub struct Friction {
    /// Bodies and points.
    pub ends: Ends,
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
        seen: &[Seen],
        force: &mut [f64; 2],
        step: f64,
        wrenches: &mut [Wrench],
        energy: &mut ElementEnergy,
    ) {
        let stretch = self.ends.stretch(seen);
        let trial = self.grip.trial(force, [stretch.rate[self.axis], 0.0], step);
        self.grip.hold(force, trial, self.limit, step, energy);
        let mut along = Vector3::zeros();
        along[self.axis] = force[0];
        self.ends.apply(&stretch, &along, wrenches);
    }
}
