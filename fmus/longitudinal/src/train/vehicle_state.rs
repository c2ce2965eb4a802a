//! What changes in a vehicle: its motion and the forces on it (theory, eq. 1).

use serde::{Deserialize, Serialize};

use crate::brake::state::BrakeState;

/// What changes in a vehicle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct VehicleState {
    /// Chainage of the vehicle's middle, m.
    pub position: f64,
    /// Velocity in the running direction, m/s.
    pub velocity: f64,
    /// Elevation of the track at the vehicle's middle, or the mean over its length, m.
    pub elevation: f64,
    /// Lever of the drive between full dynamic brake (−1) and the highest notch (1).
    pub lever: f64,
    /// Friction brake.
    pub brake: BrakeState,
    /// What acts on the vehicle.
    pub forces: Forces,
}

/// The forces on a vehicle, N.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Forces {
    /// Force of the front coupler, tension positive: pulls forward.
    pub coupler_front: f64,
    /// Force of the rear coupler, tension positive: pulls backward.
    pub coupler_rear: f64,
    /// Force of the drive at the wheel rims: traction positive, dynamic brake negative when
    /// running forward.
    pub traction: f64,
    /// Force of the gradient, forward downhill.
    pub gravity: f64,
    /// What the wind adds to the propulsion resistance, positive forward.
    pub wind: f64,
    /// Greatest propulsion resistance, ≥ 0.
    pub resistance: f64,
    /// Greatest curve resistance, ≥ 0.
    pub curve_resistance: f64,
    /// Greatest friction force of the brake shoes, ≥ 0.
    pub brake: f64,
}

impl Forces {
    /// Sum of the forces that can set the vehicle in motion.
    pub fn driving(&self) -> f64 {
        self.traction + self.gravity + self.wind + self.coupler_front - self.coupler_rear
    }

    /// Sum of the forces that can only stop it.
    pub fn resisting(&self) -> f64 {
        self.resistance + self.curve_resistance + self.brake
    }

    /// Share of each resisting force that acts in the running direction, from −1 to 1.
    ///
    /// In motion it is all of the force against the motion; at standstill as much as holds the
    /// vehicle.
    pub fn friction_share(&self, velocity: f64) -> f64 {
        if velocity != 0.0 {
            return -1.0_f64.copysign(velocity);
        }
        match self.resisting() {
            0.0 => 0.0,
            resisting => (-self.driving() / resisting).clamp(-1.0, 1.0),
        }
    }
}

impl VehicleState {
    /// Adds the impulse of the forces over a time `step`, s (theory, eq. 3).
    ///
    /// Resisting forces stop the vehicle but do not turn it back, so that the velocity of a braked
    /// vehicle comes to exactly zero.
    #[inline]
    pub(crate) fn kick(&mut self, inverse_inertia: f64, step: f64) {
        let free = self.velocity + step * inverse_inertia * self.forces.driving();
        let loss = step * inverse_inertia * self.forces.resisting();
        self.velocity = match free.abs() > loss {
            true => free - loss.copysign(free),
            false => 0.0,
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOVING: Forces = Forces {
        coupler_front: 50e3,
        coupler_rear: 20e3,
        traction: 100e3,
        gravity: -30e3,
        wind: -1e3,
        resistance: 5e3,
        curve_resistance: 2e3,
        brake: 40e3,
    };

    #[test]
    fn analytic_resisting_forces_act_against_the_motion() {
        assert_eq!((MOVING.driving(), MOVING.resisting()), (99e3, 47e3));
        assert_eq!([3.0, -3.0].map(|velocity| MOVING.friction_share(velocity)), [-1.0, 1.0]);
        // At standstill they cannot hold 99 kN.
        assert_eq!(MOVING.friction_share(0.0), -1.0);
        let held = Forces { traction: 10e3, ..MOVING };
        assert!((held.friction_share(0.0) + 9e3 / 47e3).abs() < 1e-15);
        assert_eq!(Forces::default().friction_share(0.0), 0.0);
    }

    /// 47 kN stop 100 t from 1 mm/s within 2.1 ms: a longer kick ends at exactly zero.
    #[test]
    fn analytic_a_braked_vehicle_comes_to_exactly_zero() {
        let forces = Forces { brake: 47e3, ..Forces::default() };
        for velocity in [1e-3, -1e-3] {
            let mut vehicle = VehicleState { velocity, forces, ..VehicleState::default() };
            vehicle.kick(1e-5, 1e-3);
            assert!((vehicle.velocity.abs() - 0.53e-3).abs() < 1e-15);
            assert_eq!(vehicle.velocity.signum(), velocity.signum());
            vehicle.kick(1e-5, 2e-3);
            assert_eq!(vehicle.velocity, 0.0);
        }
    }
}
