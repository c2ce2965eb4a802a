//! The state at the beginning of a run.
//!
//! In balance, all vehicles have the same acceleration a (theory, eq. 17), and each coupler carries
//! what the vehicles behind it need for that:
//!
//! ```text
//! a = Σ F_j / Σ m_j        C_k = Σ_{j>k} (m_j a − F_j)
//! ```
//!
//! so that the run does not begin with a shock through a slack train.

use crate::command::Command;
use crate::coupling::connection::ConnectionState;
use crate::train::dynamics::{TrainDynamics, TrainState};
use crate::train::vehicle_state::{Forces, VehicleState};

/// How the couplers are at the beginning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Couplers {
    /// Without force, in the middle of their slack.
    Unstressed,
    /// Loaded to the forces of uniform acceleration.
    InBalance,
}

/// How a run begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// Chainage of the leading vehicle's middle, m.
    pub position: f64,
    /// Velocity of all vehicles, m/s.
    pub velocity: f64,
    /// Couplers.
    pub couplers: Couplers,
    /// Command to which drives and brakes have come.
    pub applied: Command,
}

impl TrainDynamics {
    /// The state at the beginning of a run.
    pub fn start(&mut self, start: &Start) -> TrainState {
        let vehicle = VehicleState { velocity: start.velocity, ..VehicleState::default() };
        let mut state = TrainState {
            vehicles: vec![vehicle; self.vehicles.len()],
            connections: vec![ConnectionState::default(); self.connections.len()],
            ..TrainState::default()
        };
        for (vehicle, state) in self.vehicles.iter().zip(&mut state.vehicles) {
            vehicle.settle(state, &start.applied);
        }
        state.pipe = self.pipe_histories(&[start.applied]);
        self.position_vehicles(&mut state, start.position);
        if start.couplers == Couplers::InBalance {
            let forces = self.balanced_forces(&state);
            for (k, force) in forces.into_iter().enumerate() {
                state.connections[k] = self.connections[k].loaded_to(force);
            }
            self.position_vehicles(&mut state, start.position);
        }
        for vehicle in &state.vehicles {
            state.power.add_power(vehicle);
        }
        state.initial_energy = self.energy(&state);
        state
    }

    /// Positions the vehicles behind the leading one by the deflections, and finds the forces.
    fn position_vehicles(&mut self, state: &mut TrainState, mut position: f64) {
        for i in 0..self.vehicles.len() {
            if let Some(k) = i.checked_sub(1) {
                let connection = &state.connections[k];
                position -= self.connections[k].rest_distance() + connection.deflection;
                state.vehicles[k].forces.coupler_rear = connection.force;
                state.vehicles[i].forces.coupler_front = connection.force;
            }
            state.vehicles[i].position = position;
            let (member, own) = (&mut self.members[i], &mut state.vehicles[i]);
            self.vehicles[i].apply_forces(member, own, &self.track, &self.wind);
        }
    }

    /// Coupler forces when all vehicles, without coupler forces so far, move alike.
    fn balanced_forces(&self, state: &TrainState) -> Vec<f64> {
        let mut whole = Forces::default();
        let mut inertia = 0.0;
        for (vehicle, state) in self.vehicles.iter().zip(&state.vehicles) {
            whole.traction += state.forces.traction;
            whole.gravity += state.forces.gravity;
            whole.wind += state.forces.wind;
            whole.resistance += state.forces.resisting();
            inertia += vehicle.inertia;
        }
        let share = whole.friction_share(state.vehicles[0].velocity);
        let acceleration = (whole.driving() + share * whole.resisting()) / inertia;

        let mut forces = vec![0.0; self.connections.len()];
        let mut behind = 0.0;
        for k in (0..forces.len()).rev() {
            let (vehicle, state) = (&self.vehicles[k + 1], &state.vehicles[k + 1]);
            let own = state.forces.driving() + share * state.forces.resisting();
            behind += vehicle.inertia * acceleration - own;
            forces[k] = behind;
        }
        forces
    }
}
