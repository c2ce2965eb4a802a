//! The longest stable step of a train.
//!
//! For a linear chain with the greatest ω² of its stiffness and the greatest λ of its damping, both
//! per mass, the step of `step.rs` is stable while (theory, eq. 3a)
//!
//! ```text
//! ω² h² + 2 λ h < 4
//! ```
//!
//! Both are bounded by the row sums (Gershgorin): ω² ≤ 2 (K_before + K_behind)/m of any vehicle, and
//! λ alike with the damping. The stiffness is that of the locked gears. A law that is blended over a
//! transition speed v_e has the damping (F_loading − F_unloading)/(2 v_e) besides.

use crate::train::build::BuildError;
use crate::train::dynamics::TrainDynamics;
use crate::train::step::LONGEST_STEP;

/// Speed of the gears up to which hydraulic cushions are taken into account, m/s.
const FASTEST_GEAR: f64 = 3.0;

impl TrainDynamics {
    /// The longest stable step, s, and the index of the vehicle that sets it.
    ///
    /// Without connections it is infinite.
    pub fn longest_stable_step(&self) -> (f64, usize) {
        let stiffest: Vec<(f64, f64)> =
            self.connections.iter().map(|connection| connection.stiffest(FASTEST_GEAR)).collect();
        let at = |k: Option<usize>| k.and_then(|k| stiffest.get(k)).copied().unwrap_or_default();
        let steps = self.vehicles.iter().enumerate().map(|(i, vehicle)| {
            let (before, behind) = (at(i.checked_sub(1)), at(Some(i)));
            let frequency = 2.0 * (before.0 + behind.0) * vehicle.inverse_inertia;
            let damping = 2.0 * (before.1 + behind.1) * vehicle.inverse_inertia;
            (longest_step(frequency, damping), i)
        });
        steps.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::INFINITY, 0))
    }

    /// Refuses a train that the step of the model is too long for.
    ///
    /// # Errors
    /// When the longest stable step is shorter.
    pub fn check_step(&self) -> Result<(), BuildError> {
        let (longest, vehicle) = self.longest_stable_step();
        match longest > LONGEST_STEP {
            true => Ok(()),
            false => {
                let number = (vehicle + 1).min(self.connections.len());
                Err(BuildError::Unstable { step: LONGEST_STEP, longest, number, next: number + 1 })
            }
        }
    }
}

/// The step at which ω² h² + 2 λ h = 4, written so that a missing stiffness divides by nothing.
fn longest_step(frequency: f64, damping: f64) -> f64 {
    4.0 / (damping + (damping * damping + 4.0 * frequency).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without damping the limit is 2/ω, without stiffness 2/λ.
    /// A step at the limit of both meets ω² h² + 2 λ h = 4.
    #[test]
    fn analytic_longest_steps() {
        assert!((longest_step(77.0 * 77.0, 0.0) - 2.0 / 77.0).abs() < 1e-16);
        assert!((longest_step(0.0, 300.0) - 2.0 / 300.0).abs() < 1e-17);
        assert_eq!(longest_step(0.0, 0.0), f64::INFINITY);
        let step = longest_step(5000.0, 40.0);
        assert!((5000.0 * step * step + 2.0 * 40.0 * step - 4.0).abs() < 1e-14, "{step}");
    }
}
