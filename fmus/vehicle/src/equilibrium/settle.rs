//! Settling: the vehicle's own step, heavily damped, while its chainage is held. That finds the side to
//! which the flanges go, and where dry friction sticks.
//!
//! Curvature and cant grow from nothing, as in a transition. Set down in a curve at once, a vehicle has
//! its car body across (145 mm between pivots 13.2 m apart on R 150 m) and presses its stops so hard
//! that wheels leave their rails before it has settled.

use track::TrackPoint;

use crate::body::Frame;
use crate::dynamics::Dynamics;
use crate::dynamics::inputs::Inputs;
use crate::dynamics::wheelset::rolling;

/// Time to settle before each search, s.
pub(super) const SETTLING_TIME: f64 = 1.0;

/// Damping of all motion against the track while settling, 1/s.
const SETTLING_DAMPING: f64 = 8.0;

/// Further damping of the wheelsets' motion up and down and in roll, 1/s: wheels that bounce on their
/// flanges come to rest.
const UPRIGHT_DAMPING: f64 = 200.0;

/// Time in which curvature and cant grow, s.
const ENTERING_TIME: f64 = 2.0;

/// Steps in which they grow.
const ENTERING_STEPS: u32 = 400;

/// Step of the settling over the longest of a run: contacts on flanges are stiffer than those on treads.
const STEP_SHARE: f64 = 0.5;

impl Dynamics {
    /// Comes from straight track into what lies under the vehicle, and settles there. It coasts:
    /// driven near the limit of adhesion at this speed, wheels would spin before a lower one is tried.
    pub(super) fn enter_track(&mut self, speed: f64, inputs: &Inputs) {
        let inputs = &Inputs { traction: 0.0, brake: 0.0, ..*inputs };
        let track: Vec<TrackPoint> = self.scratch.frames.iter().map(|frame| frame.track).collect();
        self.flatten(&track, 0.0);
        self.set_speed(speed);
        for n in 1..=ENTERING_STEPS {
            self.flatten(&track, f64::from(n) / f64::from(ENTERING_STEPS));
            self.settle(ENTERING_TIME / f64::from(ENTERING_STEPS), speed, inputs);
        }
        self.settle(SETTLING_TIME, speed, inputs);
    }

    /// Damped motion for a time, at a held chainage and speed.
    pub(super) fn settle(&mut self, time: f64, speed: f64, inputs: &Inputs) {
        let step = STEP_SHARE * self.longest_step();
        self.forget_step();
        self.prepare(step);
        for _ in 0..(time / step).ceil() as usize {
            self.drift(0.5 * step, speed);
            self.find_rails(0.0);
            self.kick(step, inputs);
            self.bend_rails(step);
            self.hold(self.acceleration * step);
            self.brake_motion(speed, step);
            self.drift(0.5 * step, speed);
        }
    }

    /// The frames on a track with a share of the curvature and the cant of the `track` under them.
    fn flatten(&mut self, track: &[TrackPoint], share: f64) {
        let first = track[0];
        let start = self.state.bodies[0].position.x;
        let bodies = self.state.bodies.iter().zip(track);
        for (frame, (state, full)) in self.scratch.frames.iter_mut().zip(bodies) {
            let straight = first.heading_integral + (state.position.x - start) * first.heading;
            *frame = Frame::new(TrackPoint {
                curvature: share * full.curvature,
                cant_angle: share * full.cant_angle,
                cant_angle_slope: share * full.cant_angle_slope,
                heading: first.heading + share * (full.heading - first.heading),
                heading_integral: straight + share * (full.heading_integral - straight),
                ..*full
            });
        }
    }

    /// Takes the common change of speed away from all bodies and wheels.
    pub(super) fn hold(&mut self, change: f64) {
        for state in &mut self.state.bodies {
            state.velocity.x -= change;
        }
        for data in &self.structure.wheelsets {
            let state = &mut self.state.bodies[data.body];
            state.angular_velocity -= rolling(change, data.wheel.radius);
        }
    }

    /// Damps all velocities against the track.
    fn brake_motion(&mut self, speed: f64, step: f64) {
        let lost = 1.0 - libm::exp(-SETTLING_DAMPING * step);
        let lost_upright = 1.0 - libm::exp(-UPRIGHT_DAMPING * step);
        let bodies = self.structure.bodies.iter().zip(&self.scratch.frames);
        for (state, (body, frame)) in self.state.bodies.iter_mut().zip(bodies) {
            let mut rates = state.rates(body, frame);
            rates.position.x -= speed;
            state.velocity -= lost * rates.position;
            state.angular_velocity -= lost * rates.rotation;
            if body.turns {
                state.velocity.z -= lost_upright * rates.position.z;
                state.angular_velocity.x -= lost_upright * rates.rotation.x;
            }
        }
    }
}
