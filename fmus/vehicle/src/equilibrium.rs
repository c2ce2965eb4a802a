//! The start: quasi-static equilibrium at a place, a speed and given forces.
//!
//! All bodies run at one speed and one acceleration along the track; all else is at rest in the
//! moving frames. First the vehicle settles with its own step, heavily damped, while its chainage
//! is held (that finds the side to which the flanges go); then Newton's method removes what is
//! left, with the changes of velocity in one step as residual, so that the first step of the run
//! changes nothing.

use nalgebra::{DMatrix, DVector, Vector3};

use crate::dynamics::Dynamics;
use crate::inputs::Inputs;
use crate::rail::Deflection;
use crate::wheelset::rolling;

/// Step of the residual, s.
const STEP: f64 = 1e-3;

/// Time to settle, s: with the damping below, 12 time constants of the slowest mode (0.7 Hz).
const SETTLING_TIME: f64 = 3.0;

/// Damping of all motion against the track while settling, 1/s.
const SETTLING_DAMPING: f64 = 8.0;

/// Least speed in the search, m/s: slower, friction would hold the wheelsets anywhere.
const LEAST_SPEED: f64 = 0.5;

/// Least speed while settling, m/s: a wheelset settles over some ten metres of track.
const LEAST_SETTLING_SPEED: f64 = 10.0;

/// From one speed to the next on the way down from the settling speed.
const SLOWING: f64 = 0.6;

/// Largest acceleration left over at which the search ends, m/s² or rad/s².
const TOLERANCE: f64 = 1e-7;

/// Largest acceleration left over with which the vehicle counts as in equilibrium. Tables of geometry
/// and creep have kinks between their nodes; where the equilibrium lies on one, Newton's method comes
/// no nearer than a few 1e-6.
const REACHED: f64 = 1e-5;

/// Most steps of Newton's method.
const ITERATIONS: usize = 25;

/// Steps for the difference quotients: lengths and angles (m, rad), and rotation (rad/s).
const DIFFERENCES: (f64, f64) = (1e-8, 1e-7);

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
        self.place(position, settling_speed);
        self.settle(settling_speed, inputs);
        let mut at = settling_speed;
        let residual = loop {
            let mut residual = Search::new(self, at, inputs).solve();
            if self.rest_rails(inputs) {
                residual = Search::new(self, at, inputs).solve();
            }
            if at == speed {
                break residual;
            }
            at = (at * SLOWING).abs().max(speed.abs()) * direction;
        };
        self.set_speed(velocity);
        self.find_outputs(inputs);
        Equilibrium { residual, reached: residual <= REACHED }
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

    /// Lets elastic rails carry the wheels as they stand. The wheelsets sink with them, so that the
    /// contacts stay as they are. Tells whether there was anything to do.
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

    /// Every body at its place at rest.
    fn place(&mut self, position: f64, speed: f64) {
        for (state, body) in self.state.bodies.iter_mut().zip(&self.structure.bodies) {
            *state = Default::default();
            state.position.x = position + body.along;
        }
        self.state.elements = self.structure.suspension.at_rest();
        self.state.deflections.fill(Default::default());
        self.locate();
        self.set_speed(speed);
    }

    /// All velocities as those of a vehicle that follows the track at `speed`; a wheelset keeps
    /// its creepage.
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

    /// All velocities but the rotation of the wheels as those of a vehicle that follows the track.
    fn follow(&mut self, speed: f64) {
        let bodies = self.structure.bodies.iter().zip(&self.frames);
        for (state, (body, frame)) in self.state.bodies.iter_mut().zip(bodies) {
            let turning = frame.rotation * speed;
            let [aside, below] = state.place(body);
            let turns = state.angular_velocity.y;
            let along = speed * state.lengthening(body, frame);
            state.velocity = Vector3::new(along, -turning.x * below, turning.x * aside);
            state.angular_velocity = turning;
            if body.turns {
                state.angular_velocity.y = turns;
            }
        }
    }

    /// Damped motion at a held chainage and speed.
    fn settle(&mut self, speed: f64, inputs: &Inputs) {
        let step = self.longest_step();
        self.prepare(step);
        for _ in 0..(SETTLING_TIME / step) as usize {
            self.drift(0.5 * step, speed);
            self.find_rails(0.0);
            self.kick(step, inputs);
            self.bend_rails(step);
            self.hold(self.acceleration * step);
            self.brake_motion(speed, (-SETTLING_DAMPING * step).exp());
            self.drift(0.5 * step, speed);
        }
    }

    /// Takes the common change of speed away from all bodies and wheels.
    fn hold(&mut self, change: f64) {
        for state in &mut self.state.bodies {
            state.velocity.x -= change;
        }
        for data in &self.structure.wheelsets {
            let state = &mut self.state.bodies[data.body];
            state.angular_velocity -= rolling(change, data.wheel.radius);
        }
    }

    /// Leaves the share `kept` of all velocities against the track.
    fn brake_motion(&mut self, speed: f64, kept: f64) {
        let bodies = self.structure.bodies.iter().zip(&self.frames);
        for (state, (body, frame)) in self.state.bodies.iter_mut().zip(bodies) {
            let mut rates = state.rates(body, frame);
            rates.position.x -= speed;
            state.velocity -= (1.0 - kept) * rates.position;
            state.angular_velocity -= (1.0 - kept) * rates.rotation;
        }
    }
}

/// Newton's method for the equilibrium.
///
/// Unknowns are the coordinates of all bodies, with the rotation of a wheelset in place of its
/// pitch, but without the first body's chainage; equations are the accelerations of all bodies
/// against the first one's along the track.
struct Search<'a> {
    dynamics: &'a mut Dynamics,
    inputs: &'a Inputs,
    speed: f64,
    unknowns: DVector<f64>,
}

impl<'a> Search<'a> {
    fn new(dynamics: &'a mut Dynamics, speed: f64, inputs: &'a Inputs) -> Self {
        // Dampers with stiffness in series take their steady force at once.
        dynamics.decay.fill(0.0);
        dynamics.set_speed(speed);
        let mut search = Self { unknowns: DVector::zeros(0), dynamics, inputs, speed };
        search.unknowns = search.read();
        search
    }

    /// Goes to the equilibrium as far as possible; gives the largest acceleration left over.
    fn solve(mut self) -> f64 {
        let mut residual = self.residual(&self.unknowns.clone());
        for _ in 0..ITERATIONS {
            if residual.amax() <= TOLERANCE {
                break;
            }
            let factors = self.jacobian(&residual).lu();
            let Some(step) = factors.solve(&residual) else {
                break;
            };
            match self.search_line(&step, |residual| factors.solve(residual)) {
                Some(better) => residual = better,
                None => break,
            }
        }
        let unknowns = self.unknowns.clone();
        self.write(&unknowns);
        residual.amax()
    }

    /// Goes along the step until the next step, estimated with the same Jacobian, is shorter; gives
    /// the residual there. (Accelerations themselves say little: contacts are stiff and soft
    /// directions count as much.)
    fn search_line(
        &mut self,
        step: &DVector<f64>,
        next: impl Fn(&DVector<f64>) -> Option<DVector<f64>>,
    ) -> Option<DVector<f64>> {
        let length = step.norm();
        let mut share = 1.0;
        for _ in 0..10 {
            let trial = &self.unknowns - share * step;
            let residual = self.residual(&trial);
            if next(&residual)?.norm() < (1.0 - 0.25 * share) * length {
                self.unknowns = trial;
                return Some(residual);
            }
            share *= 0.5;
        }
        None
    }

    fn jacobian(&mut self, residual: &DVector<f64>) -> DMatrix<f64> {
        let size = self.unknowns.len();
        let mut jacobian = DMatrix::zeros(size, size);
        let at = self.unknowns.clone();
        for j in 0..size {
            let difference = self.difference(j);
            let mut moved = at.clone();
            moved[j] += difference;
            let column = (self.residual(&moved) - residual) / difference;
            jacobian.set_column(j, &column);
        }
        jacobian
    }

    /// Step of the difference quotient for an unknown.
    fn difference(&self, unknown: usize) -> f64 {
        let (body, coordinate) = ((unknown + 1) / 6, (unknown + 1) % 6);
        match coordinate == 4 && self.dynamics.structure.bodies[body].turns {
            true => DIFFERENCES.1,
            false => DIFFERENCES.0,
        }
    }

    /// Accelerations at the unknowns.
    fn residual(&mut self, unknowns: &DVector<f64>) -> DVector<f64> {
        self.write(unknowns);
        let before = self.dynamics.state.bodies.clone();
        let elements = self.dynamics.state.elements.clone();
        self.dynamics.kick(STEP, self.inputs);
        let common = self.dynamics.acceleration;
        self.dynamics.hold(common * STEP);
        let after = &self.dynamics.state.bodies;
        let changes = before.iter().zip(after).flat_map(|(before, after)| {
            let linear = (after.velocity - before.velocity) / STEP;
            let angular = (after.angular_velocity - before.angular_velocity) / STEP;
            [linear.x, linear.y, linear.z, angular.x, angular.y, angular.z]
        });
        let residual: Vec<f64> = changes.skip(1).collect();
        self.dynamics.state.bodies.copy_from_slice(&before);
        self.dynamics.state.elements = elements;
        DVector::from_vec(residual)
    }

    /// The unknowns of the present state.
    fn read(&self) -> DVector<f64> {
        let bodies = &self.dynamics.structure.bodies;
        let states = self.dynamics.state.bodies.iter().zip(bodies);
        let all = states.flat_map(|(state, body)| {
            let turning = match body.turns {
                true => state.angular_velocity.y,
                false => state.rotation.y,
            };
            let (p, r) = (&state.position, &state.rotation);
            [p.x, p.y, p.z, r.x, turning, r.z]
        });
        DVector::from_vec(all.skip(1).collect())
    }

    /// The state with these unknowns, following the track.
    fn write(&mut self, unknowns: &DVector<f64>) {
        let bodies = &self.dynamics.structure.bodies;
        let states = self.dynamics.state.bodies.iter_mut().zip(bodies);
        for (i, (state, body)) in states.enumerate() {
            // The first body's chainage stays.
            let value = |coordinate: usize| unknowns[6 * i + coordinate - 1];
            if i > 0 {
                state.position.x = value(0);
            }
            state.position.y = value(1);
            state.position.z = value(2);
            state.rotation.x = value(3);
            state.rotation.z = value(5);
            match body.turns {
                true => state.angular_velocity.y = value(4),
                false => state.rotation.y = value(4),
            }
        }
        self.dynamics.locate();
        self.dynamics.find_rails(0.0);
        self.dynamics.follow(self.speed);
    }
}
