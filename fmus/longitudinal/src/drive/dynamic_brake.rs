//! Dynamic brake of a locomotive: the motors as generators.
//!
//! ```text
//! F = −d D(v)      (theory, eq. 14)
//! ```
//!
//! with the share d that the lever has reached and the full effort D by speed. D fades to zero towards
//! standstill, over a few km/h with direct-current motors, so that the brake stops nothing by itself.

use numerics::{Piecewise, TableError};

use crate::drive::traction::effort_by_speed;

/// Dynamic brake of one locomotive.
#[derive(Clone, Debug, PartialEq)]
pub struct DynamicBrake {
    /// Full effort by speed, N over m/s.
    effort: Piecewise,
    /// Time from nothing to full effort, s.
    pub ramp: f64,
}

impl DynamicBrake {
    /// The dynamic brake of a vehicle file.
    ///
    /// # Errors
    /// When its table cannot be used.
    pub fn new(file: &stock::DynamicBrake) -> Result<Self, TableError> {
        Ok(Self { effort: effort_by_speed(&file.effort)?, ramp: file.ramp_s })
    }

    /// Force at a share of the full effort and a velocity, m/s, against the motion, in N.
    pub fn force(&self, share: f64, velocity: f64) -> f64 {
        let effort = self.effort.value(velocity.abs(), &mut 0);
        -(share * effort).copysign(velocity)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::Interpolation;

    /// A brake that fades below 2 m/s: half of it at 1 m/s, nothing at a standstill, and always against
    /// the motion.
    #[test]
    fn analytic_a_share_of_the_full_effort_acts_against_the_motion() {
        let effort =
            Piecewise::new(vec![0.0, 2.0, 10.0], &[0.0, 300e3, 300e3], Interpolation::Linear);
        let brake = DynamicBrake { effort: effort.unwrap(), ramp: 10.0 };
        for (share, velocity, expected) in [
            (1.0, 5.0, -300e3),
            (0.5, 5.0, -150e3),
            (1.0, 1.0, -150e3),
            (1.0, -5.0, 300e3),
            (1.0, 0.0, 0.0),
        ] {
            assert_eq!(brake.force(share, velocity), expected, "{share} at {velocity} m/s");
        }
    }
}
