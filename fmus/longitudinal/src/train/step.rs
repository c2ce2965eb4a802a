//! The step: kick, drift, kick.
//!
//! A fixed-step symplectic scheme of second order (velocity Verlet, theory, eq. 2): half the impulse
//! of the forces at the old position, a drift at constant velocity, and half the impulse of the
//! forces at the new position. Forces that depend on the velocity take that of the drift.
//!
//! With locked gears of 200 MN/m between masses of 134 t the highest angular frequency is 77 rad/s;
//! the scheme is stable up to a step of 2/77 s = 26 ms. `stability.rs` has the limit of a train.

use crate::brake::pipe;
use crate::command::Command;
use crate::train::dynamics::{TrainDynamics, TrainState};
use crate::train::energy::Work;

/// Longest inner step, s.
pub const LONGEST_STEP: f64 = 1e-3;

/// Share of an inner step by which a step may exceed a whole number of them.
const TOLERANCE: f64 = 1e-6;

impl TrainDynamics {
    /// Advances the train by a time `length`, s, with a constant command for all of it.
    pub fn advance(&mut self, state: &mut TrainState, command: &Command, length: f64) {
        self.advance_groups(state, std::slice::from_ref(command), length);
    }

    /// Advances the train by a time `length`, s, with a constant command for each group.
    ///
    /// Groups of locomotives without a command follow the last one.
    pub fn advance_groups(&mut self, state: &mut TrainState, commands: &[Command], length: f64) {
        let count = (length / LONGEST_STEP - TOLERANCE).ceil().max(1.0);
        for _ in 0..count as usize {
            self.inner_step(state, commands, length / count);
        }
    }

    fn inner_step(&mut self, state: &mut TrainState, commands: &[Command], step: f64) {
        for (vehicle, state) in self.vehicles.iter().zip(&mut state.vehicles) {
            state.kick(vehicle.inverse_inertia, step / 2.0);
            state.position += step * state.velocity;
        }
        self.move_connections(state);
        pipe::note(&mut state.pipe, commands, state.time);
        state.time += step;
        let mut power = Work::default();
        let members = self.vehicles.iter().zip(&mut self.members);
        for ((vehicle, member), own) in members.zip(&mut state.vehicles) {
            if let Some(air) = vehicle.brake.air() {
                pipe::arrive(air, &mut own.brake, member.source, &state.pipe, state.time);
            }
            vehicle.update_drive_and_brakes(
                member,
                own,
                &commands[member.group.min(commands.len() - 1)],
                step,
            );
            vehicle.apply_forces(member, own, &self.track, &self.wind);
            own.kick(vehicle.inverse_inertia, step / 2.0);
            power.add_power(own);
        }
        state.work.add(&state.power, step / 2.0);
        state.work.add(&power, step / 2.0);
        state.power = power;
    }

    /// Brings the connections to the vehicles' new positions (theory, eq. 4).
    fn move_connections(&mut self, state: &mut TrainState) {
        let Some((mut front, others)) = state.vehicles.split_first_mut() else { return };
        let connections = self.connections.iter_mut().zip(&mut state.connections);
        for ((connection, own), rear) in connections.zip(others) {
            let deflection = front.position - rear.position - connection.rest_distance();
            let velocity = front.velocity - rear.velocity;
            state.gear_work += connection.move_to(own, deflection, velocity);
            front.forces.coupler_rear = own.force;
            rear.forces.coupler_front = own.force;
            front = rear;
        }
    }
}
