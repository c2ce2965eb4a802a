//! Newton's method for the equilibrium.

use nalgebra::{DMatrix, DVector};

use crate::dynamics::Dynamics;
use crate::dynamics::inputs::Inputs;

/// Step of the residual, s.
pub(super) const STEP: f64 = 1e-3;

/// Largest acceleration left over at which the search ends, m/s² or rad/s².
const TOLERANCE: f64 = 1e-7;

/// Most steps of Newton's method.
const ITERATIONS: usize = 25;

/// Steps for the difference quotients: lengths and angles (m, rad), and rotation (rad/s).
const DIFFERENCES: (f64, f64) = (1e-8, 1e-7);

/// A search for the equilibrium at a speed.
///
/// Unknowns are the coordinates of all bodies, with the rotation of a wheelset instead of its
/// pitch, but without the first body's chainage; equations are the accelerations of all bodies
/// against the first one's along the track.
pub(super) struct Search<'a> {
    dynamics: &'a mut Dynamics,
    inputs: &'a Inputs,
    speed: f64,
    unknowns: DVector<f64>,
}

impl<'a> Search<'a> {
    /// A search from the present state.
    pub fn new(dynamics: &'a mut Dynamics, speed: f64, inputs: &'a Inputs) -> Self {
        // Dampers with stiffness in series take their steady force at once.
        dynamics.scratch.decay.fill(0.0);
        dynamics.set_speed(speed);
        let mut search = Self { unknowns: DVector::zeros(0), dynamics, inputs, speed };
        search.unknowns = search.read();
        search
    }

    /// The largest acceleration of the present state.
    pub fn left_over(mut self) -> f64 {
        self.residual(&self.unknowns.clone()).amax()
    }

    /// Goes to the equilibrium as far as possible; gives the largest acceleration left over.
    pub fn solve(mut self) -> f64 {
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

    /// Goes along the step until the next step is shorter; gives the residual there.
    ///
    /// The next step is estimated with the same Jacobian. Accelerations themselves say little: contacts
    /// are stiff, and soft directions count as much.
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
