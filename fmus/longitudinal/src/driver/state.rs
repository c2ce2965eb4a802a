//! What changes in a driver.

use serde::{Deserialize, Serialize};

use super::levers::LeverState;
use super::remote::RadioState;

/// What changes in a driver.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DriverState {
    /// Number of commands of the schedule whose time or chainage has come.
    pub reached: usize,
    /// Hands of a driver who controls the speed.
    pub levers: LeverState,
    /// Speed that the driver keeps to, m/s; zero without one.
    pub target_speed: f64,
    /// Speed that the logger has measured, m/s; zero without one.
    pub measured_speed: f64,
    /// Integral of the squared difference from the measured speed, m²/s, and its time, s.
    squares: (f64, f64),
    /// What the remote groups have received.
    pub radio: RadioState,
}

impl DriverState {
    /// The state at the beginning of a run.
    pub(super) fn new(radio: RadioState) -> Self {
        Self { radio, ..Self::default() }
    }

    /// Root mean square of the difference between simulated and measured speed so far, m/s.
    pub fn speed_rms(&self) -> f64 {
        match self.squares.1 > 0.0 {
            true => (self.squares.0 / self.squares.1).sqrt(),
            false => 0.0,
        }
    }

    /// Adds a difference from the measured speed, m/s, over a time, s.
    pub(super) fn add_difference(&mut self, difference: f64, time: f64) {
        self.squares.0 += difference * difference * time;
        self.squares.1 += time;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 3 m/s for 4 s and 1 m/s for 12 s: √((9·4 + 1·12)/16) m/s.
    #[test]
    fn analytic_root_mean_square_of_the_difference() {
        let mut state = DriverState::default();
        assert_eq!(state.speed_rms(), 0.0);
        state.add_difference(3.0, 4.0);
        state.add_difference(-1.0, 12.0);
        assert!((state.speed_rms() - 3.0_f64.sqrt()).abs() < 1e-15);
    }
}
