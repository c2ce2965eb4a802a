//! Forces between a wheelset and its track as acceptance tests judge them (EN 14363): Y and Q of each
//! wheel, Y/Q, the sum of Y, and wheel unloading (eqs 38 to 40).

use fmu::{Declaration, Real, Values, unit};

use crate::contact::WheelOutput;

/// Handles of a wheelset's track forces.
#[derive(Debug)]
pub(super) struct TrackForceSignals {
    wheels: [WheelTrackForces; 2],
    lateral_sum: Real,
}

/// Handles of one wheel.
#[derive(Debug)]
struct WheelTrackForces {
    lateral: Real,
    vertical: Real,
    quotient: Real,
    unloading: Real,
}

impl TrackForceSignals {
    pub fn declare(d: &mut Declaration, wheelset: &str) -> Self {
        Self {
            wheels: ["left", "right"].map(|side| WheelTrackForces::declare(d, wheelset, side)),
            lateral_sum: d
                .real(
                    format!("{wheelset}.track_force.lateral_sum"),
                    unit::NEWTON,
                    "Sum of Y: lateral force of the wheelset on the track, positive to the right",
                )
                .output(),
        }
    }

    /// Writes the forces of both wheels, whose load at rest is `static_load`.
    pub fn write(&self, wheels: &[WheelOutput; 2], static_load: f64, values: &mut Values) {
        // To the field side: left on the left rail.
        let outward = [1.0, -1.0];
        for ((handles, wheel), outward) in self.wheels.iter().zip(wheels).zip(outward) {
            let (lateral, vertical) = (outward * wheel.guiding, wheel.vertical);
            values[handles.lateral] = lateral;
            values[handles.vertical] = vertical;
            values[handles.quotient] = quotient(lateral, vertical, static_load);
            values[handles.unloading] = 1.0 - vertical / static_load;
        }
        values[self.lateral_sum] = -wheels[0].guiding - wheels[1].guiding;
    }
}

/// Y/Q; of a wheel without load, which has none, zero: below a thousandth of the static load.
fn quotient(lateral: f64, vertical: f64, static_load: f64) -> f64 {
    match vertical > 1e-3 * static_load {
        true => lateral / vertical,
        false => 0.0,
    }
}

impl WheelTrackForces {
    fn declare(d: &mut Declaration, wheelset: &str, side: &str) -> Self {
        let mut output = |name: &str, unit, description: &str| {
            let name = format!("{wheelset}.{side}.{name}");
            d.real(name, unit, format!("{description}, {side} wheel")).output()
        };
        Self {
            lateral: output(
                "track_force.lateral",
                unit::NEWTON,
                "Y: lateral force on the rail, positive to the field side",
            ),
            vertical: output("track_force.vertical", unit::NEWTON, "Q: vertical force on the rail"),
            quotient: output("derailment_quotient", unit::ONE, "Y/Q"),
            unloading: output(
                "unloading",
                unit::ONE,
                "Share of the load at rest on level track by which Q is less",
            ),
        }
    }
}
