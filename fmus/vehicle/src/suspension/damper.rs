//! Hydraulic damper, rigid or with a stiffness in series, with blow-off.
//!
//! Rigid: F = -c v, bounded by the blow-off force (eq. 13). With the stiffness k of oil and mounts
//! in series (Maxwell): dF/dt = -k (v + F/c), bounded (eq. 14), solved exactly over a step in which
//! the rate v is constant: F -> -c v + (F + c v) exp(-k h/c).

use super::energy::ElementEnergy;
use super::pair::{Between, Point};
use nalgebra::Vector3;

/// A damper that acts in one direction.
#[derive(Clone, Debug)]
pub struct Damper {
    /// Where it joins two bodies.
    pub at: Point,
    /// Direction: 0 is x, 1 is y, 2 is z.
    pub axis: usize,
    /// Damping c, N s/m.
    pub damping: f64,
    /// Stiffness in series k, N/m; infinite when rigid.
    pub series_stiffness: f64,
    /// Blow-off force, N; infinite when it has none.
    pub blow_off: f64,
}

impl Damper {
    /// The factor exp(-k h/c) of a step h; zero for a rigid damper.
    pub fn decay(&self, step: f64) -> f64 {
        libm::exp(-self.series_stiffness * step / self.damping)
    }

    /// Brings the damper's `force` on the second body to the end of the step and adds it.
    #[inline]
    pub fn apply(
        &self,
        between: &mut Between,
        force: &mut f64,
        decay: f64,
        energy: &mut ElementEnergy,
    ) {
        let stretch = between.stretch(&self.at.arm);
        let rate = stretch.rate[self.axis];
        let steady = -self.damping * rate;
        let before = *force;
        *force = (steady + (before - steady) * decay).clamp(-self.blow_off, self.blow_off);
        let mut along = Vector3::zeros();
        along[self.axis] = *force;
        between.push(&stretch, &along);
        energy.stored += 0.5 * *force * *force / self.series_stiffness;
        energy.dissipated += self.dissipated(*force, rate);
    }

    /// Heat: the power taken up when rigid or blown off, else that of the viscous part, F²/c.
    fn dissipated(&self, force: f64, rate: f64) -> f64 {
        match force.abs() < self.blow_off && self.series_stiffness.is_finite() {
            true => force * force / self.damping,
            false => -force * rate,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::Seen;
    use crate::suspension::pair::Pair;

    fn damper(series_stiffness: f64) -> Damper {
        Damper { at: Point::TEST, axis: 0, damping: 400e3, series_stiffness, blow_off: 12e3 }
    }

    /// Force after `steps` of 1 ms at a constant rate.
    fn force(damper: &Damper, rate: f64, steps: usize) -> f64 {
        let moving = Seen { velocity: Vector3::new(rate, 0.0, 0.0), ..Seen::default() };
        let mut force = 0.0;
        for _ in 0..steps {
            let between = &mut Pair::TEST.between(&[Seen::default(), moving]);
            let energy = &mut ElementEnergy::default();
            damper.apply(between, &mut force, damper.decay(1e-3), energy);
        }
        force
    }

    /// F = -c v (1 - exp(-k t/c)): 400 kN s/m and 8 MN/m have a time constant of 50 ms.
    #[test]
    fn analytic_a_maxwell_damper_builds_its_force_up() {
        let expected = -400e3 * 0.01 * (1.0 - (-1.0_f64).exp());
        assert!((force(&damper(8e6), 0.01, 50) - expected).abs() < 1e-9 * expected.abs());
    }

    #[test]
    fn analytic_a_rigid_damper_follows_at_once_and_blows_off() {
        assert_eq!(force(&damper(f64::INFINITY), 0.01, 1), -4e3);
        assert_eq!(force(&damper(f64::INFINITY), 0.10, 1), -12e3);
    }
}
