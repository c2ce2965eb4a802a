//! The forces of a step, and the velocities they give.

use super::Dynamics;
use super::drive::Drive;
use super::inputs::Inputs;
use super::wheelset::WheelsetStep;
use crate::body::Wrench;

impl Dynamics {
    /// Changes the velocities by the forces of a step.
    pub(crate) fn kick(&mut self, step: f64, inputs: &Inputs) {
        self.suspend(step);
        self.add_outer_forces(inputs);
        let before = self.velocity();
        self.roll(step, inputs);
        for (i, body) in self.structure.bodies.iter().enumerate() {
            if !body.turns {
                let (state, wrench) = (&mut self.state.bodies[i], &self.scratch.wrenches[i]);
                state.velocity += wrench.force * (step / body.mass);
                state.angular_velocity += step * wrench.moment.component_div(&body.inertia);
            }
        }
        self.account_outer_forces(inputs, step, before);
        self.acceleration = (self.velocity() - before) / step;
    }

    /// Forces of the suspension, weight and moving frames, each in its body's frame.
    fn suspend(&mut self, step: f64) {
        let Self { structure, state, scratch, .. } = self;
        let (suspension, origin) = (&structure.suspension, scratch.frames[0]);
        let start = state.bodies[0].position.x;
        for (i, body) in structure.bodies.iter().enumerate() {
            let (own, frame) = (&state.bodies[i], &scratch.frames[i]);
            let placement = origin.placement(frame, own.position.x - start);
            scratch.seen[i] = own.seen(body, frame, &placement);
            scratch.placements[i] = placement;
        }
        for (kept, between) in scratch.between.iter_mut().zip(suspension.between(&scratch.seen)) {
            *kept = between;
        }
        let (between, elements) = (&mut scratch.between, &mut state.elements);
        scratch.elements = suspension.apply(between, elements, &scratch.decay, step);
        scratch.wrenches.fill(Wrench::default());
        suspension.pass_on(&scratch.between, &mut scratch.wrenches);
        state.account.suspension_heat += step * scratch.elements.dissipated;
        for (i, body) in structure.bodies.iter().enumerate() {
            let (wrench, placement) = (&mut scratch.wrenches[i], &scratch.placements[i]);
            let own = state.bodies[i].frame_forces(body, &scratch.frames[i]);
            wrench.force = placement.force_back(&wrench.force) + own.force;
            wrench.moment = placement.back(&wrench.moment) + own.moment;
            if body.turns {
                // Axle boxes do not turn with the wheels.
                wrench.moment.y = own.moment.y;
            }
        }
    }

    /// The wheelsets, and the reaction of their drives.
    fn roll(&mut self, step: f64, inputs: &Inputs) {
        let Self { structure, line, state, wheels, scratch, .. } = self;
        for (i, data) in structure.wheelsets.iter().enumerate() {
            let drive = Drive {
                torque: -inputs.traction * data.traction_share * data.wheel.radius,
                brake: inputs.brake.max(0.0) * data.brake_share * data.wheel.radius,
                carrier: state.bodies[data.frame].angular_velocity.y,
            };
            let body = &mut state.bodies[data.body];
            let rails = line.friction.factor(body.position.x, &mut scratch.friction_index);
            let creep = structure.creep.with_friction(rails * inputs.friction);
            let wheelset = WheelsetStep {
                data,
                body: &structure.bodies[data.body],
                frame: &scratch.frames[data.body],
                rails: scratch.rails[i],
                creep: &creep,
                wrench: scratch.wrenches[data.body],
                drive,
                step,
            };
            let brake = wheelset.run(body, &mut wheels[i], &mut state.account);
            scratch.wrenches[data.frame].moment.y -= drive.torque + brake;
        }
    }
}
