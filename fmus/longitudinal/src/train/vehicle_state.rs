//! What changes in a vehicle: its motion and the forces on it.

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
