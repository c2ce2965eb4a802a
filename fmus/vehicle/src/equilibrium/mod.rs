//! The start: quasi-static equilibrium at a chainage, a speed and given forces.
//!
//! All bodies run at one speed and one acceleration along the track; all else is at rest in the
//! moving frames. First the vehicle settles (`settle.rs`); then Newton's method (`newton.rs`) removes
//! what is left, with the changes of velocity in one step as residual, so that the first step of the
//! run changes nothing. Where it fails the vehicle settles on, and is searched for again.

mod newton;
mod settle;

use nalgebra::Vector3;

use self::newton::{STEP, Search};
use self::settle::SETTLING_TIME;
use crate::dynamics::Dynamics;
use crate::dynamics::inputs::Inputs;
use crate::dynamics::wheelset::rolling;
use crate::track::Deflection;

/// Least speed in the search, m/s: slower, friction would hold the wheelsets anywhere.
const LEAST_SPEED: f64 = 0.5;

/// Least speed while settling, m/s: a wheelset settles over some ten metres of track.
const LEAST_SETTLING_SPEED: f64 = 10.0;

/// Ratio of one speed to the one before, from the settling speed down.
const SLOWING: f64 = 0.6;

/// Most searches at one speed.
const ROUNDS: usize = 4;

/// Largest acceleration left over with which the vehicle counts as in equilibrium: of a wheelset's
/// rotation, the lightest, it is a tenth of a newton at the rims. Tables of geometry and creep have
/// kinks between their nodes; where the equilibrium lies on one, Newton's method comes no nearer than
/// a few 1e-5 rad/s² of a wheel that is driven hard.
const REACHED: f64 = 1e-4;

/// Largest acceleration left over with which a search has all but succeeded: settling would only lead
/// away from there.
const NEAR: f64 = 1e-3;

/// How well the equilibrium is met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equilibrium {
    /// Largest acceleration left over, m/s² or rad/s².
    pub residual: f64,
    /// Whether that is small enough.
    pub reached: bool,
}

impl Dynamics {
    /// Puts the vehicle's middle at `position` with `velocity`, in equilibrium with the inputs.
    pub fn start(&mut self, position: f64, velocity: f64, inputs: &Inputs) -> Equilibrium {
        let direction = 1.0_f64.copysign(velocity);
        let speed = velocity.abs().max(LEAST_SPEED) * direction;
        let settling_speed = velocity.abs().max(LEAST_SETTLING_SPEED) * direction;
        self.stand_at(position);
        self.enter_track(settling_speed, inputs);
        let mut at = settling_speed;
        let residual = loop {
            let residual = self.find_equilibrium(at, inputs);
            if at == speed {
                break residual;
            }
            at = (at * SLOWING).abs().max(speed.abs()) * direction;
        };
        self.set_speed(velocity);
        self.find_outputs(inputs);
        Equilibrium { residual, reached: residual <= REACHED }
    }

    /// Settles and searches in turn, until the search succeeds; gives the largest acceleration left over.
    /// What no search improves stays as it has settled.
    fn find_equilibrium(&mut self, speed: f64, inputs: &Inputs) -> f64 {
        let mut residual = f64::INFINITY;
        for _ in 0..ROUNDS {
            let settled = self.state.clone();
            residual = Search::new(self, speed, inputs).solve();
            if self.rest_rails(inputs) {
                residual = Search::new(self, speed, inputs).solve();
            }
            if residual <= NEAR {
                return residual;
            }
            self.state = settled;
            self.locate();
            self.settle(SETTLING_TIME, speed, inputs);
        }
        Search::new(self, speed, inputs).left_over().min(residual)
    }

    /// Outputs of the present state: those of a step that is not made.
    fn find_outputs(&mut self, inputs: &Inputs) {
        let state = self.state.clone();
        self.forget_step();
        self.prepare(STEP);
        self.find_rails(0.0);
        self.kick(STEP, inputs);
        self.state = state;
        self.state.account = Default::default();
    }

    /// Lets elastic rails carry the wheels as they stand; whether the rails are elastic.
    ///
    /// The wheelsets sink with the rails, so that the contacts stay as they are.
    fn rest_rails(&mut self, inputs: &Inputs) -> bool {
        let Some(support) = self.line.support else {
            return false;
        };
        self.find_outputs(inputs);
        let wheels = self.wheels.iter().zip(&mut self.state.deflections);
        for (wheels, deflections) in wheels {
            *deflections = wheels.each_ref().map(|wheel| Deflection::at_rest(&support, wheel));
        }
        true
    }

    /// Puts every body where it stands on straight track, the middle at `position`.
    fn stand_at(&mut self, position: f64) {
        for (state, body) in self.state.bodies.iter_mut().zip(&self.structure.bodies) {
            *state = Default::default();
            state.position.x = position + body.along;
        }
        self.state.elements = self.structure.suspension.at_rest();
        self.state.deflections.fill(Default::default());
        self.locate();
    }

    /// Gives all bodies the velocities of a vehicle that follows the track at `speed`.
    ///
    /// Each wheelset keeps its creepage.
    fn set_speed(&mut self, speed: f64) {
        for data in &self.structure.wheelsets {
            let state = &mut self.state.bodies[data.body];
            state.angular_velocity.y = match state.velocity.x.abs() > 0.0 {
                true => state.angular_velocity.y * (speed / state.velocity.x),
                false => rolling(speed, data.wheel.radius).y,
            };
        }
        self.follow(speed);
    }

    /// Gives all bodies the velocities of a vehicle that follows the track; wheels keep their rotation.
    fn follow(&mut self, speed: f64) {
        let bodies = self.structure.bodies.iter().zip(&self.scratch.frames);
        for (state, (body, frame)) in self.state.bodies.iter_mut().zip(bodies) {
            let turning = frame.rotation * speed;
            let [aside, below] = state.offset(body);
            let turns = state.angular_velocity.y;
            let along = speed * state.lengthening(body, frame);
            state.velocity = Vector3::new(along, -turning.x * below, turning.x * aside);
            state.angular_velocity = turning;
            if body.turns {
                state.angular_velocity.y = turns;
            }
        }
    }
}
