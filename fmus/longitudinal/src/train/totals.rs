//! Sums and extremes over the train.

use crate::train::dynamics::{TrainDynamics, TrainState};

/// Sums and extremes over the train; forces in N.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Totals {
    /// Velocity of the train's centre of mass, m/s.
    pub velocity: f64,
    /// Force of all drives: traction positive, dynamic brake negative.
    pub traction: f64,
    /// Force of the gradients.
    pub gravity: f64,
    /// Propulsion resistance in the running direction.
    pub resistance: f64,
    /// Curve resistance in the running direction.
    pub curve_resistance: f64,
    /// Friction force of all brake shoes, ≥ 0.
    pub brake: f64,
    /// Greatest tension in a coupler, ≥ 0.
    pub greatest_tension: f64,
    /// Greatest buff force in a coupler, ≥ 0.
    pub greatest_buff: f64,
}

impl TrainDynamics {
    /// Sums and extremes over the train.
    pub fn totals(&self, state: &TrainState) -> Totals {
        let mut totals = Totals::default();
        let mut mass = 0.0;
        for (vehicle, state) in self.vehicles.iter().zip(&state.vehicles) {
            let forces = &state.forces;
            let share = forces.friction_share(state.velocity);
            mass += vehicle.mass;
            totals.velocity += vehicle.mass * state.velocity;
            totals.traction += forces.traction;
            totals.gravity += forces.gravity;
            totals.resistance += share * forces.resistance + forces.wind;
            totals.curve_resistance += share * forces.curve_resistance;
            totals.brake += forces.brake;
        }
        totals.velocity /= mass;
        for connection in &state.connections {
            totals.greatest_tension = totals.greatest_tension.max(connection.force);
            totals.greatest_buff = totals.greatest_buff.max(-connection.force);
        }
        totals
    }
}
