//! Attitudes of the bodies, and accelerations of the first one.

use nalgebra::Vector3;

use crate::body::BodyState;

fmu::variables! {
    /// Attitude of a body.
    #[derive(Copy)]
    pub struct Attitude: output {
        /// Displacement of the centre of mass to the right, {}
        lateral: "lateral", METRE;
        /// Displacement of the centre of mass downwards, {}
        vertical: "vertical", METRE;
        /// Roll against the track, right side down positive, {}
        roll: "roll", RADIAN;
        /// Pitch against the track, front up positive, {}
        pitch: "pitch", RADIAN;
        /// Yaw against the track, front to the right positive, {}
        yaw: "yaw", RADIAN;
    }

    /// What an accelerometer in the first body's centre of mass measures (eq. 41).
    #[derive(Copy)]
    pub struct BodyAcceleration: output {
        /// Acceleration less gravity at the body's centre of mass in the last step, to the right in
        /// the plane of the rails
        lateral: "lateral", METRE_PER_SECOND_SQUARED;
        /// Acceleration less gravity at the body's centre of mass in the last step, down, square to
        /// that plane; -9.80665 m/s2 at rest
        vertical: "vertical", METRE_PER_SECOND_SQUARED;
    }
}

impl From<&BodyState> for Attitude {
    fn from(state: &BodyState) -> Self {
        let (position, rotation) = (&state.position, &state.rotation);
        Self {
            lateral: position.y,
            vertical: position.z,
            roll: rotation.x,
            pitch: rotation.y,
            yaw: rotation.z,
        }
    }
}

impl From<Vector3<f64>> for BodyAcceleration {
    fn from(acceleration: Vector3<f64>) -> Self {
        Self { lateral: acceleration.y, vertical: acceleration.z }
    }
}
