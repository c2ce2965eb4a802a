//! Forces from outside, and the friction of the rails.

use fmu::{Declaration, Real, Values, unit};

use crate::dynamics::inputs::Inputs;

/// Handles of the inputs.
#[derive(Debug)]
pub(super) struct InputSignals {
    front_coupler: Real,
    rear_coupler: Real,
    resistance: Real,
    traction: Real,
    brake: Real,
    synchronisation: Real,
    friction: Real,
}

impl InputSignals {
    pub fn declare(d: &mut Declaration, friction: f64) -> Self {
        let mut force = |name, description| d.real(name, unit::NEWTON, description).input(0.0);
        Self {
            front_coupler: force(
                "coupler.front.force",
                "Force of the front coupler, tension positive",
            ),
            rear_coupler: force(
                "coupler.rear.force",
                "Force of the rear coupler, tension positive",
            ),
            resistance: force(
                "resistance.force",
                "Propulsion resistance along the track, negative when running forward; curve and \
                 gradient resistance are not part of it, as the model has both itself",
            ),
            traction: force(
                "traction.force",
                "Traction at the wheel rims, sum of all axles; negative: dynamic brake",
            ),
            synchronisation: force(
                "sync.force",
                "Force on the car body that keeps the vehicle in step with the train",
            ),
            brake: d
                .real(
                    "brake.force",
                    unit::NEWTON,
                    "Friction brake at the treads, sum of all wheels; opposes rotation",
                )
                .min(0.0)
                .input(0.0),
            friction: d
                .real(
                    "friction.coefficient",
                    unit::ONE,
                    "Friction coefficient of wheel and rail without slip",
                )
                .min(0.01)
                .max(1.0)
                .input(friction),
        }
    }

    /// The inputs of now.
    pub fn read(&self, values: &Values) -> Inputs {
        Inputs {
            front_coupler: values[self.front_coupler],
            rear_coupler: values[self.rear_coupler],
            resistance: values[self.resistance],
            traction: values[self.traction],
            brake: values[self.brake],
            synchronisation: values[self.synchronisation],
            friction: values[self.friction],
        }
    }
}
