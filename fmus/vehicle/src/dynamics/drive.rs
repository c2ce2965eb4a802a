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

#[cfg(test)]
mod tests {
    use super::*;

    const INERTIA: f64 = 100.0;

    /// Speed after a step of a wheelset on which only its drive acts.
    fn after(drive: &Drive, turning: f64, step: f64, account: &mut Account) -> f64 {
        let DriveStep { torque, damping, .. } = drive.linearised(turning);
        let change = step * torque / (INERTIA + step * damping);
        let brake = drive.linearised(turning).brake_torque(change);
        drive.account(brake, turning + 0.5 * change, step, account);
        turning + change
    }

    /// A brake of 1 kN m on 100 kg m² slows 20 rad/s by 10 rad/s²: it stands after 2 s and stays, and
    /// its heat is the kinetic energy of before, 20 kJ. Tolerance: steps of 1 ms.
    #[test]
    fn analytic_the_brake_stops_a_wheelset_and_holds_it() {
        for sign in [1.0, -1.0] {
            let drive = Drive { brake: 1e3, ..Drive::default() };
            let (mut turning, mut account) = (20.0 * sign, Account::default());
            for _ in 0..1000 {
                turning = after(&drive, turning, 1e-3, &mut account);
            }
            assert!((turning - 10.0 * sign).abs() < 0.02, "{turning} rad/s");
            for _ in 0..1500 {
                turning = after(&drive, turning, 1e-3, &mut account);
                assert!(sign * turning >= 0.0, "the brake turns the wheelset round");
            }
            assert!(turning.abs() < 1e-5, "{turning} rad/s");
            assert!((account.brake_heat - 20e3).abs() < 1e-6 * 20e3, "{} J", account.brake_heat);
        }
    }

    /// The motor's work is torque times rotation against the body that carries it.
    #[test]
    fn analytic_work_of_the_motor() {
        let drive = Drive { torque: -500.0, brake: 0.0, carrier: 1.0 };
        let mut account = Account::default();
        drive.account(0.0, -19.0, 0.1, &mut account);
        assert!((account.traction - 500.0 * 20.0 * 0.1).abs() < 1e-9);
    }
}
