//! Attitudes of the bodies, and accelerations of the first one.

use fmu::{Declaration, Real, Values, unit};
use nalgebra::Vector3;

use crate::body::BodyState;

/// Handles of the attitude of a body.
#[derive(Debug)]
pub(super) struct AttitudeSignals {
    lateral: Real,
    vertical: Real,
    roll: Real,
    pitch: Real,
    yaw: Real,
}

/// Handles of what an accelerometer in the first body's centre of mass feels.
#[derive(Debug)]
pub(super) struct AccelerationSignals {
    lateral: Real,
    vertical: Real,
}

impl AttitudeSignals {
    pub fn declare(d: &mut Declaration, name: &str, title: &str) -> Self {
        let mut output = |what: &str, unit, description: &str| {
            d.real(format!("{name}.{what}"), unit, format!("{description}, {title}")).output()
        };
        Self {
            lateral: output(
                "lateral",
                unit::METRE,
                "Displacement of the centre of mass to the right",
            ),
            vertical: output(
                "vertical",
                unit::METRE,
                "Displacement of the centre of mass downwards",
            ),
            roll: output("roll", unit::RADIAN, "Roll against the track, right side down positive"),
            pitch: output("pitch", unit::RADIAN, "Pitch against the track, front up positive"),
            yaw: output("yaw", unit::RADIAN, "Yaw against the track, front to the right positive"),
        }
    }

    /// Shows the body at `state`.
    pub fn write(&self, state: &BodyState, values: &mut Values) {
        values[self.lateral] = state.position.y;
        values[self.vertical] = state.position.z;
        values[self.roll] = state.rotation.x;
        values[self.pitch] = state.rotation.y;
        values[self.yaw] = state.rotation.z;
    }
}

impl AccelerationSignals {
    pub fn declare(d: &mut Declaration) -> Self {
        let mut output = |what: &str, description: &str| {
            let name = format!("body.acceleration.{what}");
            let description = format!(
                "Acceleration less gravity at the body's centre of mass in the last step, {description}"
            );
            d.real(name, unit::METRE_PER_SECOND_SQUARED, description).output()
        };
        Self {
            lateral: output("lateral", "to the right in the plane of the rails"),
            vertical: output("vertical", "down, square to that plane; -9.81 m/s2 at rest"),
        }
    }

    /// Shows the acceleration less gravity.
    pub fn write(&self, felt: &Vector3<f64>, values: &mut Values) {
        values[self.lateral] = felt.y;
        values[self.vertical] = felt.z;
    }
}
