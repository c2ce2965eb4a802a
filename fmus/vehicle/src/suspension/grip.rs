//! Dry friction that sticks: an elastic grip with a bounded force.
//!
//! dF/dt = -k v while |F| is below the limit; at the limit F keeps that magnitude and the surfaces
//! slide (Jenkins' element, in one or two directions; eq. 30). Over a step it is solved by
//! returning the elastic trial force to the limit, which is stable for any rate of sliding.

use super::energy::ElementEnergy;

/// An elastic grip.
#[derive(Clone, Copy, Debug)]
pub struct Grip {
    /// Stiffness k while it sticks, N/m (or N m/rad for a moment).
    pub stiffness: f64,
}

impl Grip {
    /// The force after a step at this rate if nothing slid.
    #[inline]
    pub fn trial(&self, force: &[f64; 2], rate: [f64; 2], step: f64) -> [f64; 2] {
        [0, 1].map(|i| force[i] - self.stiffness * step * rate[i])
    }

    /// Brings `force` to the end of the step: the trial force, or what the limit leaves of it.
    #[inline]
    pub fn hold(
        &self,
        force: &mut [f64; 2],
        trial: [f64; 2],
        limit: f64,
        step: f64,
        energy: &mut ElementEnergy,
    ) {
        let size = magnitude(&trial);
        let held = size.min(limit);
        *force = if size > held { trial.map(|part| part * (held / size)) } else { trial };
        energy.stored += 0.5 * held * held / self.stiffness;
        energy.dissipated += held * (size - held) / (self.stiffness * step);
    }
}

/// Length of a vector in the plane.
#[inline]
pub fn magnitude([x, y]: &[f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A grip of 1 MN/m and 1 kN follows 0.5 mm elastically, slides on to 3 mm at 1 kN, and comes
    /// back by 2 mm to -1 kN: the loop of Coulomb's law with a stiffness. 2 mm at 1 kN are 2 J.
    #[test]
    fn analytic_loop_of_stick_and_slip() {
        let grip = Grip { stiffness: 1e6 };
        let (mut force, mut heat) = ([0.0; 2], 0.0);
        let mut push = |distance: f64, force: &mut [f64; 2]| {
            for _ in 0..100 {
                let mut energy = ElementEnergy::default();
                let trial = grip.trial(force, [distance / 0.1, 0.0], 1e-3);
                grip.hold(force, trial, 1e3, 1e-3, &mut energy);
                heat += 1e-3 * energy.dissipated;
            }
        };
        push(0.5e-3, &mut force);
        assert!((force[0] + 500.0).abs() < 1e-9);
        push(2.5e-3, &mut force);
        assert!((force[0] + 1e3).abs() < 1e-9);
        push(-2e-3, &mut force);
        assert!((force[0] - 1e3).abs() < 1e-9);
        assert!((heat - 2.0).abs() < 1e-3, "{heat}");
    }

    /// In two directions the resultant is bounded, not each part.
    #[test]
    fn analytic_the_resultant_is_bounded() {
        let grip = Grip { stiffness: 1e6 };
        let mut force = [0.0; 2];
        let trial = grip.trial(&force, [3.0, 4.0], 1e-3);
        grip.hold(&mut force, trial, 1e3, 1e-3, &mut ElementEnergy::default());
        assert!((force[0] + 600.0).abs() < 1e-9 && (force[1] + 800.0).abs() < 1e-9);
    }
}
