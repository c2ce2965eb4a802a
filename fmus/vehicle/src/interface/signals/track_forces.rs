//! Forces between a wheel and its rail as acceptance tests judge them (EN 14363): Y, Q, their quotient,
//! and wheel unloading (eq. 38 to 40).

use crate::contact::{Side, WheelOutput};

fmu::variables! {
    /// Track forces of a wheel.
    #[derive(Copy)]
    pub struct TrackForces: output {
        /// Y: lateral force on the rail, positive to the field side, {}
        lateral: "track_force.lateral", NEWTON;
        /// Q: vertical force on the rail, {}
        vertical: "track_force.vertical", NEWTON;
        /// Y/Q, {}
        quotient: "derailment_quotient", ONE;
        /// Share of the load at rest on level track by which Q is less, {}
        unloading: "unloading", ONE;
    }
}

impl TrackForces {
    /// The forces of a wheel on this side, whose load at rest is `static_load` (N).
    pub fn new(wheel: &WheelOutput, side: Side, static_load: f64) -> Self {
        // To the field side: left on the left rail.
        let (lateral, vertical) = (-side.sign() * wheel.guiding, wheel.vertical);
        Self {
            lateral,
            vertical,
            quotient: quotient(lateral, vertical, static_load),
            unloading: 1.0 - vertical / static_load,
        }
    }
}

/// Y/Q; of a wheel without load, which has none, zero: below a thousandth of the static load.
fn quotient(lateral: f64, vertical: f64, static_load: f64) -> f64 {
    match vertical > 1e-3 * static_load {
        true => lateral / vertical,
        false => 0.0,
    }
}
