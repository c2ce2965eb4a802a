//! A rigid body in its track-following frame.

use nalgebra::Vector3;
use numerics::constants::STANDARD_GRAVITY;
use serde::{Deserialize, Serialize};

use super::frame::{Frame, Placement};

/// What a body is, constant.
#[derive(Clone, Debug)]
pub struct RigidBody {
    /// Name in the vehicle file.
    pub name: String,
    /// Mass, kg.
    pub mass: f64,
    /// Moments of inertia about x, y, z, kg m².
    pub inertia: Vector3<f64>,
    /// Distance ahead of the vehicle's middle, m.
    pub along: f64,
    /// Distance to the right of the track's centre line at rest, m.
    pub across: f64,
    /// Height of the centre of mass above the rails, m.
    pub height: f64,
    /// Whether it turns about y with the wheels.
    pub turns: bool,
}

/// Where a body is and how it moves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct BodyState {
    /// Chainage, and displacement to the right and down from rest, m.
    pub position: Vector3<f64>,
    /// Roll, pitch and yaw against the track, rad; a wheelset has no pitch.
    pub rotation: Vector3<f64>,
    /// Velocity of the centre of mass, absolute, in the frame's directions, m/s.
    pub velocity: Vector3<f64>,
    /// Angular velocity, absolute, in the frame's directions, rad/s.
    pub angular_velocity: Vector3<f64>,
}

/// Force and moment about the centre of mass, N and N m.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wrench {
    /// Force.
    pub force: Vector3<f64>,
    /// Moment.
    pub moment: Vector3<f64>,
}

/// A body as seen in the vehicle's common frame.
#[derive(Clone, Copy, Debug, Default)]
pub struct Seen {
    /// Displacement of the centre of mass from rest on straight track, m.
    pub displacement: Vector3<f64>,
    /// Rotation, rad.
    pub rotation: Vector3<f64>,
    /// Velocity, m/s.
    pub velocity: Vector3<f64>,
    /// Angular velocity, rad/s; of a wheelset without its turning.
    pub angular_velocity: Vector3<f64>,
}

/// Rates of a body's coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Rates {
    /// Of [`BodyState::position`], m/s.
    pub position: Vector3<f64>,
    /// Of [`BodyState::rotation`], rad/s.
    pub rotation: Vector3<f64>,
}

impl BodyState {
    /// Speed of the body's frame along the track, m/s (eq. 2).
    #[inline]
    pub fn frame_speed(&self, body: &RigidBody, frame: &Frame) -> f64 {
        self.velocity.x / self.lengthening(body, frame)
    }

    /// Speed of a body that follows the track over that of its frame (eq. 2).
    ///
    /// It differs from 1 as the body runs beside and above the centre line.
    #[inline]
    pub fn lengthening(&self, body: &RigidBody, frame: &Frame) -> f64 {
        let [aside, below] = self.offset(body);
        1.0 + frame.rotation.y * below - frame.rotation.z * aside
    }

    /// Centre of mass to the right of the centre line and below the rails, m.
    #[inline]
    pub fn offset(&self, body: &RigidBody) -> [f64; 2] {
        [body.across + self.position.y, self.position.z - body.height]
    }

    /// Rates of the coordinates: absolute velocities less those of the frame (eq. 2).
    #[inline]
    pub fn rates(&self, body: &RigidBody, frame: &Frame) -> Rates {
        let speed = self.frame_speed(body, frame);
        let turning = frame.rotation * speed;
        let [aside, below] = self.offset(body);
        let mut rotation = self.angular_velocity - turning;
        if body.turns {
            rotation.y = 0.0;
        }
        Rates {
            position: Vector3::new(
                speed,
                self.velocity.y + turning.x * below,
                self.velocity.z - turning.x * aside,
            ),
            rotation,
        }
    }

    /// Gravity and the inertia forces of the moving frame (eq. 3 to 5).
    #[inline]
    pub fn frame_forces(&self, body: &RigidBody, frame: &Frame) -> Wrench {
        let turning = frame.rotation * self.frame_speed(body, frame);
        let force = body.mass * (frame.gravity - turning.cross(&self.velocity));
        // The axes of a wheelset do not turn with the wheels.
        let axes = Vector3::new(
            self.angular_velocity.x,
            if body.turns { turning.y } else { self.angular_velocity.y },
            self.angular_velocity.z,
        );
        let momentum = body.inertia.component_mul(&self.angular_velocity);
        Wrench { force, moment: -axes.cross(&momentum) }
    }

    /// The body in the common frame, in which its own frame has this placement (eq. 8, 9).
    #[inline]
    pub fn seen(&self, body: &RigidBody, frame: &Frame, placement: &Placement) -> Seen {
        let at_rest = Vector3::new(body.along, body.across, -body.height);
        let [aside, below] = self.offset(body);
        let local = Vector3::new(0.0, aside, below);
        let mut angular_velocity = self.angular_velocity;
        if body.turns {
            angular_velocity.y = frame.rotation.y * self.velocity.x;
        }
        Seen {
            displacement: placement.offset + placement.out(&local) - at_rest,
            rotation: self.rotation + placement.turn,
            velocity: placement.velocity_out(&self.velocity),
            angular_velocity: placement.out(&angular_velocity),
        }
    }

    /// Kinetic energy, J.
    pub fn kinetic_energy(&self, body: &RigidBody) -> f64 {
        let squares = self.angular_velocity.component_mul(&self.angular_velocity);
        0.5 * (body.mass * self.velocity.norm_squared() + body.inertia.dot(&squares))
    }

    /// Potential energy in gravity, J, against a body at rest at elevation zero.
    pub fn gravity_energy(&self, body: &RigidBody, frame: &Frame) -> f64 {
        let [aside, below] = self.offset(body);
        let across = aside * frame.gravity.y + below * frame.gravity.z;
        body.mass * (STANDARD_GRAVITY * (frame.track.elevation - body.height) - across)
    }
}

impl Wrench {
    /// Adds a force at a point given from the centre of mass.
    #[inline]
    pub fn add(&mut self, force: &Vector3<f64>, arm: &Vector3<f64>) {
        self.force += force;
        self.moment += arm.cross(force);
    }
}

#[cfg(test)]
mod tests {
    use track::TrackPoint;

    use super::*;

    fn body(turns: bool) -> RigidBody {
        RigidBody {
            name: "body".into(),
            mass: 1000.0,
            inertia: Vector3::new(500.0, 80.0, 600.0),
            along: 2.0,
            across: 0.1,
            height: 1.5,
            turns,
        }
    }

    /// A right-hand curve of 500 m with a cant of 0.05 rad.
    fn curve() -> Frame {
        Frame::new(TrackPoint { curvature: 1.0 / 500.0, cant_angle: 0.05, ..TrackPoint::default() })
    }

    fn moving() -> BodyState {
        BodyState {
            position: Vector3::new(100.0, 0.02, -0.01),
            rotation: Vector3::new(0.01, 0.0, -0.02),
            velocity: Vector3::new(20.0, 0.3, -0.1),
            angular_velocity: Vector3::new(0.02, -40.0, 0.05),
        }
    }

    /// The inertia forces of the moving frame do no work; what is left is that of gravity.
    #[test]
    fn property_inertia_forces_do_no_work() {
        let (frame, state) = (curve(), moving());
        for turns in [true, false] {
            let body = body(turns);
            let force = state.frame_forces(&body, &frame).force;
            let power = force.dot(&state.velocity);
            let gravity = body.mass * frame.gravity.dot(&state.velocity);
            assert!((power - gravity).abs() < 1e-9 * body.mass * 400.0);
        }
    }

    /// A body that follows a level curve of 500 m at 20 m/s needs m v²/R = 800 N to the inside; its frame
    /// is slower than a body on the outside.
    #[test]
    fn analytic_centrifugal_force_and_speed_of_the_frame() {
        let flat = Frame::new(TrackPoint { curvature: 1.0 / 500.0, ..TrackPoint::default() });
        let body = RigidBody { across: 0.0, ..body(false) };
        let velocity = Vector3::new(20.0, 0.0, 0.0);
        let state = BodyState { velocity, ..BodyState::default() };
        assert!((state.frame_forces(&body, &flat).force.y + 800.0).abs() < 1e-9);
        let mut outside = state;
        outside.position.y = -1.0;
        assert!((outside.frame_speed(&body, &flat) - 20.0 / 1.002).abs() < 1e-12);
    }

    /// A body at rest is where its vehicle file has it: no displacement in the common frame.
    #[test]
    fn analytic_a_body_at_rest_is_not_displaced() {
        let placement = Frame::default().placement(&Frame::default(), 2.0);
        let seen = BodyState::default().seen(&body(false), &Frame::default(), &placement);
        assert!(seen.displacement.norm() < 1e-15 && seen.rotation.norm() < 1e-15);
    }

    /// Force times arm is the moment: 3 N to the right, 2 m ahead, turns to the right.
    #[test]
    fn analytic_a_force_at_an_arm() {
        let mut wrench = Wrench::default();
        wrench.add(&Vector3::new(0.0, 3.0, 0.0), &Vector3::new(2.0, 0.0, 0.0));
        assert_eq!(wrench.moment, Vector3::new(0.0, 0.0, 6.0));
    }
}
