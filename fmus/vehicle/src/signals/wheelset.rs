//! A wheelset and its wheels.

use fmu::{Declaration, Real, Values, unit};

use super::patch::PatchSignals;
use super::track_forces::TrackForceSignals;
use crate::body::BodyState;
use crate::wheel::PATCHES;
use crate::wheel_output::WheelOutput;

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
    creepage: [Real; 3],
    longitudinal: Real,
    lateral: Real,
    normal: Real,
    friction_power: Real,
    a: Real,
    b: Real,
    rail_lateral: Real,
    standing: Real,
    patches: [PatchSignals; PATCHES],
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
        let mut output = |name: &str, unit, description: &str| {
            d.real(
                format!("{wheelset}.{side}.{name}"),
                unit,
                format!("{description}, {side} wheel"),
            )
            .output()
        };
        Self {
            creepage: [
                output(
                    "creepage.longitudinal",
                    unit::ONE,
                    "Longitudinal creepage, traction positive",
                ),
                output(
                    "creepage.lateral",
                    unit::ONE,
                    "Lateral creepage, wheel slipping right positive",
                ),
                output("creepage.spin", unit::PER_METRE, "Spin creepage, positive about z down"),
            ],
            longitudinal: output(
                "force.longitudinal",
                unit::NEWTON,
                "Creep force on the wheel along the track, traction positive",
            ),
            lateral: output(
                "force.lateral",
                unit::NEWTON,
                "Creep force on the wheel in the contact plane, positive to the right",
            ),
            normal: output("force.normal", unit::NEWTON, "Normal force"),
            friction_power: output("friction_power", unit::WATT, "Power turned into heat by creep"),
            a: output("contact.a", unit::METRE, "Semi-axis of the contact in rolling direction"),
            b: output("contact.b", unit::METRE, "Semi-axis of the contact across"),
            rail_lateral: output(
                "contact.lateral_position",
                unit::METRE,
                "Contact on the rail head from its top, negative towards the gauge side",
            ),
            standing: output(
                "contact.state",
                unit::ONE,
                "0: on its rail, 1: lifted off it, 2: climbed over it or fallen off it",
            ),
            patches: std::array::from_fn(|i| {
                PatchSignals::declare(d, &format!("{wheelset}.{side}"), i + 1)
            }),
        }
    }

    fn write(&self, wheel: &WheelOutput, values: &mut Values) {
        values[self.creepage[0]] = wheel.creepages.longitudinal;
        values[self.creepage[1]] = wheel.creepages.lateral;
        values[self.creepage[2]] = wheel.creepages.spin;
        values[self.longitudinal] = wheel.longitudinal;
        values[self.lateral] = wheel.lateral;
        values[self.normal] = wheel.normal;
        values[self.friction_power] = wheel.friction_power;
        values[self.a] = wheel.a;
        values[self.b] = wheel.b;
        values[self.rail_lateral] = wheel.rail_lateral;
        values[self.standing] = f64::from(wheel.standing as u8);
        for (handles, patch) in self.patches.iter().zip(&wheel.patches) {
            handles.write(patch, values);
        }
    }
}
