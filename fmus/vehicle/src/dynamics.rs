//! The vehicle in motion: its state, and one step.
//!
//! A step of length h moves the coordinates by half of it, changes the velocities with the forces
//! there, and moves the coordinates by the other half (Störmer and Verlet's scheme: second order
//! in the springs, and it neither feeds nor eats energy). Contact friction and damping, and the
//! brake, count with the velocities at the end of the step (`wheelset.rs`).

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::body::{BodyState, Seen, Wrench};
use crate::drive::Drive;
use crate::energy::{Account, Stored};
use crate::frame::{Frame, Placement};
use crate::inputs::Inputs;
use crate::line::Line;
use crate::rail::{Deflection, RailMotion};
use crate::structure::Structure;
use crate::suspension::pair::Between;
use crate::suspension::{ElementEnergy, ElementState};
use crate::wheel_output::WheelOutput;
use crate::wheelset::WheelsetStep;

/// Longest step of any vehicle, s.
pub const LONGEST_STEP: f64 = 1e-3;

/// Greatest natural circular frequency times step on stiff rails: the scheme is stable below 2, and
/// a contact may get three times its static load and with it 1.2 times its frequency.
const GREATEST_PHASE: f64 = 1.4;

/// The same on elastic rails, which follow the wheels a step late.
const GREATEST_PHASE_ON_ELASTIC_RAILS: f64 = 0.95;

/// All that changes in a step.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Bodies in the structure's order.
    pub bodies: Vec<BodyState>,
    /// What the force elements remember.
    pub elements: ElementState,
    /// Deflection of the rails under each wheelset, left and right.
    pub deflections: Vec<[Deflection; 2]>,
    /// Work and heat since the start.
    pub account: Account,
}

/// A vehicle on a track.
#[derive(Clone, Debug)]
pub struct Dynamics {
    /// What the vehicle is.
    pub structure: Arc<Structure>,
    /// Where it runs.
    pub line: Arc<Line>,
    /// Where it is and how it moves; [`Self::restore`] puts another in its place.
    pub state: State,
    /// Wheels of each wheelset, left and right, at the end of the last step.
    pub wheels: Vec<[WheelOutput; 2]>,
    /// Acceleration of the first body along the track in the last step, m/s².
    pub acceleration: f64,
    /// The track under each body where it is.
    pub(crate) frames: Vec<Frame>,
    rails: Vec<[RailMotion; 2]>,
    pub(crate) decay: Vec<f64>,
    elements: ElementEnergy,
    step: f64,
    placements: Vec<Placement>,
    seen: Vec<Seen>,
    between: Vec<Between>,
    pub(crate) wrenches: Vec<Wrench>,
    pub(crate) track_index: usize,
}

impl Dynamics {
    /// A vehicle whose bodies stand at the beginning of the track until it is placed.
    pub fn new(structure: Arc<Structure>, line: Arc<Line>) -> Self {
        let bodies = structure.bodies.len();
        let dampers = structure.suspension.dampers.len();
        Self {
            state: State {
                bodies: vec![BodyState::default(); bodies],
                elements: structure.suspension.at_rest(),
                deflections: vec![Default::default(); structure.wheelsets.len()],
                account: Account::default(),
            },
            wheels: vec![Default::default(); structure.wheelsets.len()],
            acceleration: 0.0,
            frames: vec![Frame::default(); bodies],
            rails: vec![Default::default(); structure.wheelsets.len()],
            decay: vec![0.0; dampers],
            elements: ElementEnergy::default(),
            step: 0.0,
            placements: vec![Placement::default(); bodies],
            seen: vec![Seen::default(); bodies],
            between: vec![Between::default(); structure.suspension.pairs.len()],
            wrenches: vec![Wrench::default(); bodies],
            track_index: 0,
            structure,
            line,
        }
    }

    /// Takes the vehicle `step` seconds further.
    pub fn step(&mut self, step: f64, inputs: &Inputs) {
        self.prepare(step);
        self.drift(0.5 * step, 0.0);
        self.locate();
        self.find_rails(1.0);
        self.kick(step, inputs);
        self.bend_rails(step);
        self.drift(0.5 * step, 0.0);
        self.locate();
    }

    /// Goes on from another state.
    pub fn restore(&mut self, state: State) {
        self.state = state;
        self.locate();
    }

    /// Longest step that resolves the stiffest body, s.
    pub fn longest_step(&self) -> f64 {
        let phase = match self.line.support {
            None => GREATEST_PHASE,
            Some(_) => GREATEST_PHASE_ON_ELASTIC_RAILS,
        };
        LONGEST_STEP.min(phase / self.structure.highest_frequency)
    }

    /// Chainage of the vehicle's middle, m.
    pub fn position(&self) -> f64 {
        self.state.bodies[0].position.x - self.structure.bodies[0].along
    }

    /// Speed of the first body along the track, m/s.
    pub fn velocity(&self) -> f64 {
        self.state.bodies[0].velocity.x
    }

    /// Energy in the vehicle now; the elastic part belongs to the middle of the last step.
    pub fn stored_energy(&self) -> Stored {
        let mut stored = Stored { elastic: self.elements.stored, ..Stored::default() };
        for wheel in self.wheels.iter().flatten() {
            stored.elastic += wheel.elastic_energy;
        }
        if let Some(support) = &self.line.support {
            let deflections = self.state.deflections.iter().flatten();
            stored.elastic += deflections.map(|d| d.elastic_energy(support)).sum::<f64>();
        }
        let bodies = self.structure.bodies.iter().zip(&self.frames);
        for (state, (body, frame)) in self.state.bodies.iter().zip(bodies) {
            stored.kinetic += state.kinetic_energy(body);
            stored.gravity += state.gravity_energy(body, frame);
        }
        stored
    }

    /// Constants that depend on the length of the step.
    pub(crate) fn prepare(&mut self, step: f64) {
        if step == self.step {
            return;
        }
        self.step = step;
        let dampers = &self.structure.suspension.dampers;
        for (decay, damper) in self.decay.iter_mut().zip(dampers) {
            *decay = damper.decay(step);
        }
    }

    /// Lets the next step prepare its constants anew.
    pub(crate) fn forget_step(&mut self) {
        self.step = 0.0;
    }

    /// The track under every body.
    pub(crate) fn locate(&mut self) {
        for (frame, state) in self.frames.iter_mut().zip(&self.state.bodies) {
            *frame = Frame::new(self.line.track.at(state.position.x, &mut self.track_index));
        }
    }

    /// The rails under every wheelset; `moving` is 1, or 0 for rails whose irregularities do not
    /// move up and down under the wheels.
    pub(crate) fn find_rails(&mut self, moving: f64) {
        let line = &*self.line;
        if line.is_stiff_and_smooth() {
            return;
        }
        for (i, data) in self.structure.wheelsets.iter().enumerate() {
            let state = &self.state.bodies[data.body];
            let offsets = line.irregularity.at(state.position.x);
            let speed = moving * state.velocity.x;
            self.rails[i] = [0, 1].map(|side| {
                RailMotion::new(&offsets[side], speed, &self.state.deflections[i][side])
            });
        }
    }

    /// The deflections of the rails at the end of a step, and what irregularities and support did.
    pub(crate) fn bend_rails(&mut self, step: f64) {
        if self.line.is_stiff_and_smooth() {
            return;
        }
        let speed = self.velocity();
        let State { deflections, account, .. } = &mut self.state;
        for (i, deflections) in deflections.iter_mut().enumerate() {
            for (side, deflection) in deflections.iter_mut().enumerate() {
                let (wheel, rail) = (&self.wheels[i][side], &self.rails[i][side]);
                let lifting = rail.velocity - deflection.velocity;
                account.irregularities +=
                    step * (lifting.x * wheel.guiding - lifting.y * wheel.vertical);
                if let Some(support) = &self.line.support {
                    deflection.step(support, wheel, speed, step, account);
                }
            }
        }
    }

    /// Moves the coordinates with the velocities, in a frame that itself runs at `speed`.
    pub(crate) fn drift(&mut self, step: f64, speed: f64) {
        let bodies = self.structure.bodies.iter().zip(&self.frames);
        for (state, (body, frame)) in self.state.bodies.iter_mut().zip(bodies) {
            let mut rates = state.rates(body, frame);
            rates.position.x -= speed;
            state.position += step * rates.position;
            state.rotation += step * rates.rotation;
        }
    }

    /// Changes the velocities by the forces of a step.
    pub(crate) fn kick(&mut self, step: f64, inputs: &Inputs) {
        self.suspend(step);
        self.add_outer_forces(inputs);
        let before = self.velocity();
        self.roll(step, inputs);
        for (i, body) in self.structure.bodies.iter().enumerate() {
            if !body.turns {
                let (state, wrench) = (&mut self.state.bodies[i], &self.wrenches[i]);
                state.velocity += wrench.force * (step / body.mass);
                state.angular_velocity += step * wrench.moment.component_div(&body.inertia);
            }
        }
        self.account_outer_forces(inputs, step, before);
        self.acceleration = (self.velocity() - before) / step;
    }

    /// Forces of the suspension, weight and moving frames, each in its body's frame.
    fn suspend(&mut self, step: f64) {
        let structure = &*self.structure;
        let origin = self.frames[0];
        let start = self.state.bodies[0].position.x;
        for (i, body) in structure.bodies.iter().enumerate() {
            let state = &self.state.bodies[i];
            let placement = origin.placement(&self.frames[i], state.position.x - start);
            self.seen[i] = state.seen(body, &self.frames[i], &placement);
            self.placements[i] = placement;
        }
        let suspension = &structure.suspension;
        for (place, between) in self.between.iter_mut().zip(suspension.between(&self.seen)) {
            *place = between;
        }
        let (between, elements) = (&mut self.between, &mut self.state.elements);
        self.elements = suspension.apply(between, elements, &self.decay, step);
        self.wrenches.fill(Wrench::default());
        suspension.pass_on(&self.between, &mut self.wrenches);
        self.state.account.suspension_heat += step * self.elements.dissipated;
        for (i, body) in structure.bodies.iter().enumerate() {
            let (wrench, placement) = (&mut self.wrenches[i], &self.placements[i]);
            let own = self.state.bodies[i].frame_forces(body, &self.frames[i]);
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
        let structure = &*self.structure;
        let creep = structure.creep.with_friction(inputs.friction);
        for (i, data) in structure.wheelsets.iter().enumerate() {
            let drive = Drive {
                torque: -inputs.traction * data.traction_share * data.wheel.radius,
                brake: inputs.brake.max(0.0) * data.brake_share * data.wheel.radius,
                carrier: self.state.bodies[data.frame].angular_velocity.y,
            };
            let wheelset = WheelsetStep {
                data,
                body: &structure.bodies[data.body],
                frame: &self.frames[data.body],
                rails: self.rails[i],
                creep: &creep,
                wrench: self.wrenches[data.body],
                drive,
                step,
            };
            let state = &mut self.state;
            let body = &mut state.bodies[data.body];
            let brake = wheelset.run(body, &mut self.wheels[i], &mut state.account);
            self.wrenches[data.frame].moment.y -= drive.torque + brake;
        }
    }
}
