//! The vehicle in motion: its state, and one step.
//!
//! A step of length h moves the coordinates by half of it, changes the velocities with the forces
//! there, and moves the coordinates by the other half (Störmer and Verlet's scheme: second order
//! in the springs, and it neither feeds nor eats energy). Contact friction and damping, and the
//! brake, count with the velocities at the end of the step (`wheelset.rs`).

pub mod drive;
mod forces;
pub mod inputs;
mod outer_forces;
pub(crate) mod scratch;
pub mod wheelset;

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use self::inputs::Inputs;
use self::scratch::Scratch;
use crate::body::BodyState;
use crate::body::Frame;
use crate::contact::WheelOutput;
use crate::energy::{Account, Stored};
use crate::structure::Structure;
use crate::suspension::ElementState;
use crate::track::Line;
use crate::track::{Deflection, RailMotion};

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
    /// Where it is and how it moves; [`Self::restore`] sets another state.
    pub state: State,
    /// Wheels of each wheelset, left and right, at the end of the last step.
    pub wheels: Vec<[WheelOutput; 2]>,
    /// Acceleration of the first body along the track in the last step, m/s².
    pub acceleration: f64,
    /// What a step works with.
    pub(crate) scratch: Scratch,
}

impl Dynamics {
    /// A vehicle whose bodies stand at the beginning of the track until it is placed.
    pub fn new(structure: Arc<Structure>, line: Arc<Line>) -> Self {
        let bodies = structure.bodies.len();
        Self {
            state: State {
                bodies: vec![BodyState::default(); bodies],
                elements: structure.suspension.at_rest(),
                deflections: vec![Default::default(); structure.wheelsets.len()],
                account: Account::default(),
            },
            wheels: vec![Default::default(); structure.wheelsets.len()],
            acceleration: 0.0,
            scratch: Scratch::new(&structure),
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

    /// Continues from another state.
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
        let mut stored = Stored { elastic: self.scratch.elements.stored, ..Stored::default() };
        for wheel in self.wheels.iter().flatten() {
            stored.elastic += wheel.elastic_energy;
        }
        if let Some(support) = &self.line.support {
            let deflections = self.state.deflections.iter().flatten();
            stored.elastic += deflections.map(|d| d.elastic_energy(support)).sum::<f64>();
        }
        let bodies = self.structure.bodies.iter().zip(&self.scratch.frames);
        for (state, (body, frame)) in self.state.bodies.iter().zip(bodies) {
            stored.kinetic += state.kinetic_energy(body);
            stored.gravity += state.gravity_energy(body, frame);
        }
        stored
    }

    /// Computes the constants that depend on the length of the step.
    pub(crate) fn prepare(&mut self, step: f64) {
        let scratch = &mut self.scratch;
        if step == scratch.step {
            return;
        }
        scratch.step = step;
        let dampers = &self.structure.suspension.dampers;
        for (decay, damper) in scratch.decay.iter_mut().zip(dampers) {
            *decay = damper.decay(step);
        }
    }

    /// Lets the next step prepare its constants anew.
    pub(crate) fn forget_step(&mut self) {
        self.scratch.step = 0.0;
    }

    /// Finds the track under every body.
    pub(crate) fn locate(&mut self) {
        let Scratch { frames, track_index, .. } = &mut self.scratch;
        for (frame, state) in frames.iter_mut().zip(&self.state.bodies) {
            *frame = Frame::new(self.line.track.at(state.position.x, track_index));
        }
    }

    /// Finds where the rails lie under every wheelset, and how they move.
    ///
    /// `moving` is 1, or 0 for rails whose irregularities do not move up and down under the wheels.
    pub(crate) fn find_rails(&mut self, moving: f64) {
        let line = &*self.line;
        if line.is_stiff_and_smooth() {
            return;
        }
        for (i, data) in self.structure.wheelsets.iter().enumerate() {
            let state = &self.state.bodies[data.body];
            let offsets = line.irregularity.at(state.position.x);
            let speed = moving * state.velocity.x;
            self.scratch.rails[i] = [0, 1].map(|side| {
                RailMotion::new(&offsets[side], speed, &self.state.deflections[i][side])
            });
        }
    }

    /// Brings the rails' deflections to the end of a step, and accounts for their work and heat.
    pub(crate) fn bend_rails(&mut self, step: f64) {
        if self.line.is_stiff_and_smooth() {
            return;
        }
        let speed = self.velocity();
        let State { deflections, account, .. } = &mut self.state;
        for (i, deflections) in deflections.iter_mut().enumerate() {
            for (side, deflection) in deflections.iter_mut().enumerate() {
                let (wheel, rail) = (&self.wheels[i][side], &self.scratch.rails[i][side]);
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
        let bodies = self.structure.bodies.iter().zip(&self.scratch.frames);
        for (state, (body, frame)) in self.state.bodies.iter_mut().zip(bodies) {
            let mut rates = state.rates(body, frame);
            rates.position.x -= speed;
            state.position += step * rates.position;
            state.rotation += step * rates.rotation;
        }
    }
}
