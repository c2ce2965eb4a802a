//! A wheelset and its wheels.

use fmu::{Handles, Values, Variables};

use super::track_forces::TrackForces;
use crate::body::BodyState;
use crate::contact::{ContactOutput, PATCHES, Side, WheelOutput};

fmu::variables! {
    /// A wheelset.
    pub struct WheelsetSignals: output {
        /// Chainage of the wheelset
        position: "position", METRE;
        /// Speed of the wheelset along the track
        speed: "speed", METRE_PER_SECOND;
        /// Displacement of the wheelset's middle to the right of the track's
        lateral: "lateral", METRE;
        /// Yaw of the wheelset against the track, front to the right positive
        yaw: "yaw", RADIAN;
        /// Both wheels on their rails.
        wheels: ["left", "right"], group(WheelSignals) = ["left wheel", "right wheel"];
        /// Forces of both wheels on the track.
        track_forces: ["left", "right"], group(TrackForces) = ["left wheel", "right wheel"];
        /// Sum of Y: lateral force of the wheelset on the track, positive to the right
        lateral_sum: "track_force.lateral_sum", NEWTON;
    }

    /// A wheel on its rail.
    pub struct WheelSignals: output {
        /// All its contacts together.
        total: "", group(ContactOutput);
        /// 0: on its rail, 1: lifted off it, 2: climbed over it or fallen off it, {}
        standing: "contact.state", ONE;
        /// Each of its contacts.
        patches: ["patch[1]", "patch[2]", "patch[3]"], group(ContactOutput) = [
            "of the contacts the one nearest to the tread",
            "of the contacts number 2 towards the flange",
            "of the contacts number 3 towards the flange"
        ];
    }
}

/// Shows the wheelset at `state` with both wheels, whose load at rest is `static_load` (N).
pub(super) fn write(
    handles: &Handles<WheelsetSignals>,
    state: &BodyState,
    wheels: &[WheelOutput; 2],
    static_load: f64,
    values: &mut Values,
) {
    values[handles.position] = state.position.x;
    values[handles.speed] = state.velocity.x;
    values[handles.lateral] = state.position.y;
    values[handles.yaw] = state.rotation.z;
    for (i, side) in Side::BOTH.into_iter().enumerate() {
        let forces = TrackForces::new(&wheels[i], side, static_load);
        forces.write(&handles.track_forces[i], values);
        write_wheel(&handles.wheels[i], &wheels[i], values);
    }
    values[handles.lateral_sum] = -wheels[0].guiding - wheels[1].guiding;
}

fn write_wheel(handles: &Handles<WheelSignals>, wheel: &WheelOutput, values: &mut Values) {
    wheel.total.write(&handles.total, values);
    values[handles.standing] = f64::from(wheel.standing as u8);
    let patches: &[Handles<ContactOutput>; PATCHES] = &handles.patches;
    for (handles, patch) in patches.iter().zip(&wheel.patches) {
        // A contact that was not there and still is not costs nothing.
        if patch.force.normal != 0.0 || values[handles.force.normal] != 0.0 {
            patch.write(handles, values);
        }
    }
}
