//! What acts on the vehicle from outside.

fmu::variables! {
    /// Forces on the vehicle, N, and the friction of the rails; constant in a step.
    #[derive(Copy)]
    pub struct Inputs: input {
        /// Force of the front coupler, tension positive
        front_coupler: "coupler.front.force", NEWTON = 0.0;
        /// Force of the rear coupler, tension positive
        rear_coupler: "coupler.rear.force", NEWTON = 0.0;
        /// Propulsion resistance along the track, negative when running forward; curve and gradient
        /// resistance are not part of it, as the model has both itself
        resistance: "resistance.force", NEWTON = 0.0;
        /// Traction at the wheel rims, sum of all axles; negative: dynamic brake
        traction: "traction.force", NEWTON = 0.0;
        /// Force on the car body that keeps the vehicle in step with the train
        synchronisation: "sync.force", NEWTON = 0.0;
        /// Friction brake at the treads, sum of all wheels; opposes rotation
        brake: "brake.force", NEWTON = 0.0, 0.0..;
        /// Friction coefficient of wheel and rail without slip.
        ///
        /// Where the rails' factor is 1. A vehicle file has a start value of its own.
        friction: "friction.coefficient", ONE = 0.36, 0.01..=1.0;
    }
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
