//! What acts on the vehicle from outside.

/// Forces on the vehicle, N, and the state of the rails; constant in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inputs {
    /// Front coupler, tension positive.
    pub front_coupler: f64,
    /// Rear coupler, tension positive.
    pub rear_coupler: f64,
    /// Propulsion resistance along the track; negative against forward motion.
    pub resistance: f64,
    /// Traction at the wheel rims, sum of all axles; negative is dynamic brake.
    pub traction: f64,
    /// Friction brake at the treads, sum of all wheels, not negative.
    pub brake: f64,
    /// Force that keeps the vehicle in step with the train.
    pub synchronisation: f64,
    /// Friction coefficient without slip, where the rails' factor is 1.
    pub friction: f64,
}

impl Inputs {
    /// No force at all, and rails with this friction coefficient.
    pub fn none(friction: f64) -> Self {
        Self {
            front_coupler: 0.0,
            rear_coupler: 0.0,
            resistance: 0.0,
            traction: 0.0,
            brake: 0.0,
            synchronisation: 0.0,
            friction,
        }
    }
}
