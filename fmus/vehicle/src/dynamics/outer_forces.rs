//! Forces from outside on the first body: couplers, resistance, synchronisation.

use nalgebra::Vector3;

use crate::body::Frame;
use crate::dynamics::Dynamics;
use crate::dynamics::inputs::Inputs;

impl Dynamics {
    /// Couplers, resistance and synchronisation on the first body. A coupler pulls along the track
    /// where it is, which is towards the inside of a curve (eq. 26).
    pub(crate) fn add_outer_forces(&mut self, inputs: &Inputs) {
        self.scratch.wrenches[0].force.x += inputs.resistance + inputs.synchronisation;
        for (i, force) in self.coupler_forces(inputs).into_iter().enumerate() {
            self.scratch.wrenches[0].add(&force, &self.structure.couplers[i]);
        }
    }

    /// Forces of front and rear coupler in the first body's frame.
    fn coupler_forces(&mut self, inputs: &Inputs) -> [Vector3<f64>; 2] {
        let pulls = [inputs.front_coupler, -inputs.rear_coupler];
        let here = self.state.bodies[0].position.x;
        [0, 1].map(|i| {
            if pulls[i] == 0.0 {
                return Vector3::zeros();
            }
            let ahead = self.structure.couplers[i].x;
            let there = Frame::new(self.line.track.at(here + ahead, &mut self.scratch.track_index));
            let turn = self.scratch.frames[0].placement(&there, ahead).turn;
            pulls[i] * Vector3::new(1.0, turn.z, -turn.y)
        })
    }

    /// Work of these forces in a step, from the velocity `before` it.
    pub(crate) fn account_outer_forces(&mut self, inputs: &Inputs, step: f64, before: f64) {
        let distance = 0.5 * step * (before + self.velocity());
        let turned = step * self.state.bodies[0].angular_velocity;
        let moved = step * self.state.bodies[0].velocity;
        let mut couplers = 0.0;
        for (i, force) in self.coupler_forces(inputs).iter().enumerate() {
            couplers += force.dot(&(moved + turned.cross(&self.structure.couplers[i])));
        }
        let account = &mut self.state.account;
        account.couplers += couplers;
        account.resistance += distance * inputs.resistance;
        account.synchronisation += distance * inputs.synchronisation;
    }
}
