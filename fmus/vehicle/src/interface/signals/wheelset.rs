//! A wheelset and its wheels.

use fmu::{Declaration, Real, Values, unit};

use super::contact::ContactSignals;
use super::track_forces::TrackForceSignals;
use crate::body::BodyState;
use crate::contact::PATCHES;
use crate::contact::WheelOutput;

/// Handles of a wheelset.
#[derive(Debug)]
pub(super) struct WheelsetSignals {
    position: Real,
    speed: Real,
    lateral: Real,
    yaw: Real,
    /// Left, right.
    wheels: [WheelSignals; 2],
    track_forces: TrackForceSignals,
}

/// Handles of a wheel.
#[derive(Debug)]
struct WheelSignals {
    total: ContactSignals,
    standing: Real,
    patches: [ContactSignals; PATCHES],
}

impl WheelsetSignals {
    pub fn declare(d: &mut Declaration, number: usize) -> Self {
        let name = format!("wheelset[{number}]");
        Self {
            position: d
                .real(format!("{name}.position"), unit::METRE, "Chainage of the wheelset")
                .output(),
            speed: d
                .real(
                    format!("{name}.speed"),
                    unit::METRE_PER_SECOND,
                    "Speed of the wheelset along the track",
                )
                .output(),
            lateral: d
                .real(
                    format!("{name}.lateral"),
                    unit::METRE,
                    "Displacement of the wheelset's middle to the right of the track's",
                )
                .output(),
            yaw: d
                .real(
                    format!("{name}.yaw"),
                    unit::RADIAN,
                    "Yaw of the wheelset against the track, front to the right positive",
                )
                .output(),
            wheels: ["left", "right"].map(|side| WheelSignals::declare(d, &name, side)),
            track_forces: TrackForceSignals::declare(d, &name),
        }
    }

    /// Shows the wheelset at `state` with both wheels, whose load at rest is `static_load`.
    pub fn write(
        &self,
        state: &BodyState,
        wheels: &[WheelOutput; 2],
        static_load: f64,
        values: &mut Values,
    ) {
        values[self.position] = state.position.x;
        values[self.speed] = state.velocity.x;
        values[self.lateral] = state.position.y;
        values[self.yaw] = state.rotation.z;
        self.track_forces.write(wheels, static_load, values);
        for (handles, wheel) in self.wheels.iter().zip(wheels) {
            handles.write(wheel, values);
        }
    }
}

impl WheelSignals {
    fn declare(d: &mut Declaration, wheelset: &str, side: &str) -> Self {
        let name = format!("{wheelset}.{side}");
        Self {
            total: ContactSignals::declare(d, &name, &format!("{side} wheel")),
            standing: d
                .real(
                    format!("{name}.contact.state"),
                    unit::ONE,
                    format!(
                        "0: on its rail, 1: lifted off it, 2: climbed over it or fallen off it, \
                         {side} wheel"
                    ),
                )
                .output(),
            patches: std::array::from_fn(|i| {
                let whose = match i {
                    0 => "of the contacts the one nearest to the tread".into(),
                    _ => format!("of the contacts number {} towards the flange", i + 1),
                };
                ContactSignals::declare(d, &format!("{name}.patch[{}]", i + 1), &whose)
            }),
        }
    }

    fn write(&self, wheel: &WheelOutput, values: &mut Values) {
        self.total.write(&wheel.total, values);
        values[self.standing] = f64::from(wheel.standing as u8);
        for (handles, patch) in self.patches.iter().zip(&wheel.patches) {
            // One that was not there and still is not costs nothing.
            if patch.normal != 0.0 || handles.shows_one(values) {
                handles.write(patch, values);
            }
        }
    }
}
