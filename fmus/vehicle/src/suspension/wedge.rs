//! Friction wedge of a three-piece bogie: a massless wedge between the sloping face of the bolster
//! (first body) and the column of the side frame (second body), pressed up by its own spring.
//!
//! Its face on the bolster stands at the angle β from the vertical and slides freely. With the
//! spring's force F_w and the friction s μ N on the column (s = 1: it acts on the side frame
//! downwards, the bolster goes down), its equilibrium gives (eq. 31)
//!
//!   N = F_w/(tan β - s μ),   vertical force on the bolster F_w + s μ N.
//!
//! So the wedge rubs harder on loading than on unloading. The friction acts in the plane of the column
//! (y, z) and sticks as `grip.rs` says. Form: Iwnicki, Stichel, Orlova & Hecht, VSD 53(7), 2015, on
//! massless wedges.

use nalgebra::Vector3;

use super::energy::ElementEnergy;
use super::grip::{Grip, magnitude};
use super::pair::{Between, Point};

/// A wedge.
#[derive(Clone, Debug)]
pub struct Wedge {
    /// Where it joins bolster and side frame.
    pub at: Point,
    /// tan β.
    pub slope: f64,
    /// Friction coefficient μ on the column.
    pub friction: f64,
    /// Force of the spring at rest, N.
    pub spring_force: f64,
    /// Stiffness of the spring, N/m.
    pub spring_stiffness: f64,
    /// How it sticks to the column.
    pub grip: Grip,
}

impl Wedge {
    /// Brings the friction `force` on the side frame (y, z) to the end of the step and adds all
    /// forces.
    #[inline]
    pub fn apply(
        &self,
        between: &mut Between,
        force: &mut [f64; 2],
        step: f64,
        energy: &mut ElementEnergy,
    ) {
        let stretch = between.stretch(&self.at.arm);
        let lift = stretch.length.z.min(self.spring_force / self.spring_stiffness);
        let spring = self.spring_force - self.spring_stiffness * lift;
        energy.stored += lift * (0.5 * self.spring_stiffness * lift - self.spring_force);

        let trial = self.grip.trial(force, [stretch.rate.y, stretch.rate.z], step);
        let limit = self.friction * self.normal_force(spring, &trial);
        self.grip.hold(force, trial, limit, step, energy);
        between.push(&stretch, &Vector3::new(0.0, force[0], force[1] + spring));
    }

    /// Force N on the column while the friction acts in the direction of `trial`.
    fn normal_force(&self, spring: f64, trial: &[f64; 2]) -> f64 {
        let size = magnitude(trial);
        let downwards = if size > 0.0 { trial[1] / size } else { 0.0 };
        spring / (self.slope - downwards * self.friction)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::Seen;
    use crate::suspension::pair::Pair;

    /// Force on the side frame after the bolster went far down or up again.
    fn vertical(speed: f64) -> f64 {
        let wedge = Wedge {
            at: Point::TEST,
            slope: 36.3_f64.to_radians().tan(),
            friction: 0.3,
            spring_force: 20e3,
            spring_stiffness: 393e3,
            grip: Grip { stiffness: 10e6 },
        };
        let bolster = Seen { velocity: Vector3::new(0.0, 0.0, speed), ..Seen::default() };
        let mut force = [0.0; 2];
        let mut between = Between::default();
        for _ in 0..1000 {
            between = Pair::TEST.between(&[bolster, Seen::default()]);
            wedge.apply(&mut between, &mut force, 1e-3, &mut ElementEnergy::default());
        }
        between.force.z
    }

    /// Equilibrium of a wedge of 36.3 degrees under 20 kN, friction 0.3: by hand,
    /// 20 (1 + 0.3/(0.7346 - 0.3)) = 33.81 kN on loading, 20 (1 - 0.3/(0.7346 + 0.3)) = 14.20 kN on
    /// unloading.
    #[test]
    fn analytic_loading_and_unloading() {
        assert!((vertical(0.1) - 33.81e3).abs() < 5.0, "{}", vertical(0.1));
        assert!((vertical(-0.1) - 14.20e3).abs() < 5.0, "{}", vertical(-0.1));
    }
}
