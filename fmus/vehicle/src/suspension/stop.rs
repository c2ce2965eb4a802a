//! Stop with free play: F = -k (u -+ g) beyond the play g to either side (eq. 15).

use nalgebra::Vector3;

use super::energy::ElementEnergy;
use super::pair::{Between, Point};

/// A stop that acts in one direction to both sides.
#[derive(Clone, Debug)]
pub struct Stop {
    /// Where it joins two bodies.
    pub at: Point,
    /// Direction: 0 is x, 1 is y, 2 is z.
    pub axis: usize,
    /// Free play g to each side, m.
    pub free_play: f64,
    /// Stiffness k, N/m.
    pub stiffness: f64,
}

impl Stop {
    /// Adds the forces on both bodies.
    #[inline]
    pub fn apply(&self, between: &mut Between, energy: &mut ElementEnergy) {
        let stretch = between.stretch(&self.at.arm);
        let length = stretch.length[self.axis];
        let pressed = length - length.clamp(-self.free_play, self.free_play);
        if pressed == 0.0 {
            return;
        }
        let mut force = Vector3::zeros();
        force[self.axis] = -self.stiffness * pressed;
        between.push(&stretch, &force);
        energy.stored += 0.5 * self.stiffness * pressed * pressed;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::Seen;
    use crate::suspension::pair::Pair;

    /// 31 mm against a play of 30 mm and 6 MN/m: 6 kN back; nothing within the play.
    #[test]
    fn analytic_force_beyond_the_free_play() {
        let stop = Stop { at: Point::TEST, axis: 1, free_play: 0.030, stiffness: 6e6 };
        let force = |lateral: f64| {
            let displaced =
                Seen { displacement: Vector3::new(0.0, lateral, 0.0), ..Seen::default() };
            let mut between = Pair::TEST.between(&[Seen::default(), displaced]);
            stop.apply(&mut between, &mut ElementEnergy::default());
            between.force.y
        };
        assert!((force(0.031) + 6e3).abs() < 1e-6);
        assert!((force(-0.031) - 6e3).abs() < 1e-6);
        assert_eq!(force(0.029), 0.0);
    }
}
