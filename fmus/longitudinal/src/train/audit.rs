//! The energy audit of the train.
//!
//! It compares (theory, eq. 18) what was put into the train with what became of it:
//!
//! ```text
//! residual = W_traction − W_dynamic brake − W_brake − W_resistance − W_curve − W_gears
//!            − Δ(kinetic + potential)
//! ```
//!
//! The work on the draft gears is booked from forces and deflections, the rest from forces and
//! velocities, so that the residual is the error of the integration and not zero by construction.

use numerics::constants::STANDARD_GRAVITY;

use crate::train::dynamics::{TrainDynamics, TrainState};
use crate::train::energy::Energy;

impl TrainDynamics {
    /// The energy that the train has.
    pub fn energy(&self, state: &TrainState) -> Energy {
        self.energy_and_heat(state, |_, _, _| {})
    }

    /// The energy that the train has, and the heat of each draft gear.
    ///
    /// Calls `see` with each `k` and the energy that the two gears between the vehicles `k` and
    /// `k + 1` have turned into heat since the start, J: that of the vehicle in front first.
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
