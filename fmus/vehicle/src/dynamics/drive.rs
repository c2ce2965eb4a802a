//! Traction and brake of one wheelset.
//!
//! The traction force F at the rims acts as a torque -F r about y (a wheel that rolls forward turns
//! negatively about y, which points to the right); the nose-suspended motor reacts on the bogie
//! frame (eq. 23). The friction brake acts as a torque against the rotation, at most B r, that
//! holds at standstill (eq. 24).

use crate::energy::Account;

/// Speed of rotation below which the brake holds rather than slides, rad/s: 5 micrometres a second
/// at the rim.
const HOLDING_SPEED: f64 = 1e-5;

/// Drive and brake of a wheelset in a step.
#[derive(Clone, Copy, Debug, Default)]
pub struct Drive {
    /// Torque of the motor about y, N m.
    pub torque: f64,
    /// Largest torque of the brake, N m.
    pub brake: f64,
    /// Speed of rotation about y of the body that takes the reaction, rad/s.
    pub carrier: f64,
}

/// Torque at the beginning of a step and how it changes with the wheelset's rotation.
#[derive(Clone, Copy, Debug)]
pub struct DriveStep {
    /// Torque of motor and brake, N m.
    pub torque: f64,
    /// Decrease of the torque with the speed of rotation, N m s.
    pub damping: f64,
    /// The part of the brake.
    brake: f64,
}

impl Drive {
    /// The torque at a speed of rotation `turning` of the wheelset. The brake's dry friction is
    /// taken by its secant, so that it stops the wheelset without reversing it.
    pub fn linearised(&self, turning: f64) -> DriveStep {
        let relative = turning - self.carrier;
        let damping = self.brake / relative.abs().max(HOLDING_SPEED);
        let brake = -damping * relative;
        DriveStep { torque: self.torque + brake, damping, brake }
    }

    /// Adds the work of the motor and the heat of the brake in a step at the mean speed `turning`.
    pub fn account(&self, brake: f64, turning: f64, step: f64, account: &mut Account) {
        let relative = step * (turning - self.carrier);
        account.traction += self.torque * relative;
        account.brake_heat -= brake * relative;
    }
}

impl DriveStep {
    /// Torque of the brake at the end of the step.
    pub fn brake_torque(&self, change: f64) -> f64 {
        self.brake - self.damping * change
    }
}
