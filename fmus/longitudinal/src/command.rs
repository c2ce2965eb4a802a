//! What the driver asks of drives and brakes.

use serde::{Deserialize, Serialize};

/// Number of the highest notch.
pub const HIGHEST_NOTCH: f64 = stock::NOTCHES as f64;

/// Greatest command of the train brake: emergency, the level of AAR S-4200.
pub const EMERGENCY: f64 = 1.2;

/// What the driver asks for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Command {
    /// Notch, 0 (idle) to 8; between two notches the drive is between them.
    pub notch: f64,
    /// Dynamic brake as a share of full effort; takes traction away.
    pub dynamic_brake: f64,
    /// Train brake: 1 is full service, 1.2 emergency.
    pub train_brake: f64,
    /// Brake of the locomotives alone, 1 is full.
    pub locomotive_brake: f64,
}

impl Command {
    /// Where the levers of the locomotives go to, from −1 to 1 (see [`crate::drive::lever`]).
    pub fn lever(&self) -> f64 {
        match self.dynamic_brake > 0.0 {
            true => -self.dynamic_brake,
            false => self.notch / HIGHEST_NOTCH,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_lever_is_the_share_of_notches_or_of_dynamic_brake() {
        let command = Command { notch: 6.0, ..Command::default() };
        assert_eq!(command.lever(), 0.75);
        assert_eq!(Command { dynamic_brake: 0.5, ..command }.lever(), -0.5);
    }
}
