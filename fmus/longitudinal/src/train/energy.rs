//! Work of each kind of force, and where the energy of the train is.

use serde::{Deserialize, Serialize};

use crate::train::vehicle_state::VehicleState;

/// Work that has been done, J; or the power that does it, W. Traction counts what it gives to the
/// train, all others what they take from it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Work {
    /// Traction.
    pub traction: f64,
    /// Dynamic brake.
    pub dynamic_brake: f64,
    /// Friction brakes.
    pub brake: f64,
    /// Propulsion resistance with the wind.
    pub resistance: f64,
    /// Curve resistance.
    pub curve_resistance: f64,
}

impl Work {
    /// Adds the power of the forces on a vehicle, W.
    #[inline]
    pub(crate) fn add_power(&mut self, vehicle: &VehicleState) {
        let speed = vehicle.velocity.abs();
        let forces = &vehicle.forces;
        let drive = forces.traction * vehicle.velocity;
        self.traction += drive.max(0.0);
        self.dynamic_brake -= drive.min(0.0);
        self.brake += forces.brake * speed;
        self.resistance += forces.resistance * speed - forces.wind * vehicle.velocity;
        self.curve_resistance += forces.curve_resistance * speed;
    }

    /// Adds the work of `power` over a time, s.
    pub(crate) fn add(&mut self, power: &Self, time: f64) {
        self.traction += power.traction * time;
        self.dynamic_brake += power.dynamic_brake * time;
        self.brake += power.brake * time;
        self.resistance += power.resistance * time;
        self.curve_resistance += power.curve_resistance * time;
    }

    /// What the train has got in all, J.
    pub(crate) fn net(&self) -> f64 {
        self.traction - self.dynamic_brake - self.brake - self.resistance - self.curve_resistance
    }
}

/// Where the energy of the train is, J.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Energy {
    /// Of the motion, with that of the rotating parts.
    pub kinetic: f64,
    /// Of the height, from the zero of the track's elevation.
    pub potential: f64,
    /// In the springs of the draft gears.
    pub stored: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::train::vehicle_state::Forces;

    /// 100 kN of drive and 16 kN against the motion at 20 m/s for 3 s, forwards and backwards.
    /// Backwards a forward drive takes energy, as a dynamic brake does.
    #[test]
    fn analytic_work_is_power_times_time() {
        let forces = Forces {
            traction: 100e3,
            resistance: 5e3,
            curve_resistance: 4e3,
            brake: 6e3,
            wind: -1e3,
            ..Forces::default()
        };
        let work = |velocity: f64| {
            let (mut power, mut work) = (Work::default(), Work::default());
            power.add_power(&VehicleState { velocity, forces, ..VehicleState::default() });
            work.add(&power, 3.0);
            work
        };
        let forward = work(20.0);
        let expected = Work {
            traction: 6e6,
            dynamic_brake: 0.0,
            brake: 360e3,
            // The head wind adds its 1 kN.
            resistance: 360e3,
            curve_resistance: 240e3,
        };
        assert_eq!(forward, expected);
        assert_eq!(forward.net(), 6e6 - 960e3);
        let backward = work(-20.0);
        assert_eq!((backward.traction, backward.dynamic_brake), (0.0, 6e6));
        assert_eq!((backward.brake, backward.resistance), (360e3, 240e3));
    }
}
