//! Work of each kind of force, and the energy audit.
//!
//! The audit (theory, eq. 18) compares what was put into the train with what became of it:
//!
//! ```text
//! residual = W_traction − W_dynamic brake − W_brake − W_resistance − W_curve − W_gears
//!            − Δ(kinetic + potential)
//! ```
//!
//! The work on the draft gears is booked from forces and deflections, the rest from forces and
//! velocities, so that the residual is the error of the integration and not zero by construction.

use serde::{Deserialize, Serialize};

use crate::line::gravity::STANDARD_GRAVITY;
use crate::train::dynamics::{TrainDynamics, TrainState};
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
    fn net(&self) -> f64 {
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

impl TrainDynamics {
    /// The energy that the train has.
    pub fn energy(&self, state: &TrainState) -> Energy {
        self.energy_and_heat(state, |_, _, _| {})
    }

    /// The energy that the train has; calls `see` with each `k` and the energy that the gears
    /// between the vehicles `k` and `k + 1` have turned into heat since the start, J: that of the
    /// gear of the vehicle in front, and of the one behind it.
    pub fn energy_and_heat(
        &self,
        state: &TrainState,
        mut see: impl FnMut(usize, f64, f64),
    ) -> Energy {
        let mut energy = Energy::default();
        for (vehicle, state) in self.vehicles.iter().zip(&state.vehicles) {
            energy.kinetic += vehicle.inertia * state.velocity * state.velocity / 2.0;
            energy.potential += vehicle.mass * STANDARD_GRAVITY * state.elevation;
        }
        for (k, (connection, own)) in self.connections.iter().zip(&state.connections).enumerate() {
            let stored = connection.stored_energy(own);
            let heat = own.taken - stored;
            let front = connection.front_loss_share() * heat;
            see(k, front, heat - front);
            energy.stored += stored;
        }
        energy
    }

    /// Energy that the draft gears have turned into heat since the start, J.
    pub fn gear_dissipation(&self, state: &TrainState, now: &Energy) -> f64 {
        state.gear_work - (now.stored - state.initial_energy.stored)
    }

    /// Error of the energy balance since the start, J.
    pub fn energy_residual(&self, state: &TrainState, now: &Energy) -> f64 {
        let gained = now.kinetic + now.potential
            - (state.initial_energy.kinetic + state.initial_energy.potential);
        state.work.net() - state.gear_work - gained
    }
}
