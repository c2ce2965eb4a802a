//! The FMU's variables.
//!
//! | file | part |
//! |---|---|
//! | `wheelset.rs` | a wheelset and its wheels |
//! | `track_forces.rs` | Y, Q and what is formed from them |
//! | `body.rs` | attitudes of the bodies, accelerations of the first one |
//!
//! Inputs, energy and contacts have their tables where the physics has them: `dynamics/inputs.rs`,
//! `energy.rs`, `contact/contact_output.rs`.

mod body;
mod track_forces;
mod wheelset;

use fmu::{Declaration, Handles, Scope, Values, Variables};
use nalgebra::Vector3;
use stock::Multibody;

use crate::dynamics::Dynamics;
use crate::dynamics::inputs::Inputs;
use crate::energy::{Account, Stored};
use body::{Attitude, BodyAcceleration};
use wheelset::WheelsetSignals;

/// The vehicle file in the resources.
pub(crate) const VEHICLE_FILE: &str = "vehicle.toml";

fmu::variables! {
    /// Files, and the start.
    pub struct Start: parameter {
        /// Vehicle file; empty: vehicle.toml in the FMU's resources
        vehicle_file: "vehicle_file", file(VEHICLE_FILE);
        /// Track file; empty: track.toml in the FMU's resources
        track_file: "track_file", file("track.toml");
        /// Chainage of the vehicle's middle at first
        position: "initial.position", METRE = 0.0;
        /// Speed at first
        velocity: "initial.velocity", METRE_PER_SECOND = 0.0;
    }

    /// Motion along the track.
    #[derive(Copy)]
    pub struct Motion: output {
        /// Chainage of the vehicle's middle
        position: "position", METRE;
        /// Speed of the car body along the track
        velocity: "velocity", METRE_PER_SECOND;
        /// Acceleration of the car body along the track in the last step
        acceleration: "acceleration", METRE_PER_SECOND_SQUARED;
    }
}

/// Handles of all variables.
#[derive(Debug)]
pub struct Signals {
    pub(crate) start: Handles<Start>,
    inputs: Handles<Inputs>,
    motion: Handles<Motion>,
    wheelsets: Vec<Handles<WheelsetSignals>>,
    /// Car body, then all others but the wheelsets.
    bodies: Vec<Handles<Attitude>>,
    body_acceleration: Handles<BodyAcceleration>,
    stored: Handles<Stored>,
    account: Handles<Account>,
}

impl Signals {
    /// Declares the variables of a vehicle with these bodies and wheelsets.
    pub(crate) fn declare(d: &mut Declaration, multibody: &Multibody) -> Self {
        let wheelsets = multibody.wheelset.len();
        declare_terminals(d, wheelsets);
        let start = Start::declare(d, "");
        let inputs = Inputs::declare(d, "");
        d.set_start(inputs.friction, multibody.contact.creep.friction);
        Self {
            start,
            inputs,
            motion: Motion::declare(d, ""),
            wheelsets: (1..=wheelsets)
                .map(|number| WheelsetSignals::declare(d, format!("wheelset[{number}]")))
                .collect(),
            bodies: attitudes(d, multibody),
            body_acceleration: BodyAcceleration::declare(d, "body.acceleration"),
            stored: Stored::declare(d, "energy"),
            account: Account::declare(d, "energy"),
        }
    }

    /// Number of declared wheelsets, and of the other bodies.
    pub(crate) fn shape(&self) -> [usize; 2] {
        [self.wheelsets.len(), self.bodies.len()]
    }

    /// The inputs of now.
    pub(crate) fn read(&self, values: &Values) -> Inputs {
        Inputs::read(&self.inputs, values)
    }

    /// Shows the vehicle, whose first body had this acceleration less gravity in the last step.
    pub(crate) fn write(
        &self,
        dynamics: &Dynamics,
        acceleration: Vector3<f64>,
        values: &mut Values,
    ) {
        let motion = Motion {
            position: dynamics.position(),
            velocity: dynamics.velocity(),
            acceleration: dynamics.acceleration,
        };
        motion.write(&self.motion, values);
        let wheelsets = dynamics.structure.wheelsets.iter().zip(&dynamics.wheels);
        for (handles, (data, wheels)) in self.wheelsets.iter().zip(wheelsets) {
            let state = &dynamics.state.bodies[data.body];
            wheelset::write(handles, state, wheels, data.static_wheel_load, values);
        }
        for (handles, state) in self.bodies.iter().zip(&dynamics.state.bodies) {
            Attitude::from(state).write(handles, values);
        }
        BodyAcceleration::from(acceleration).write(&self.body_acceleration, values);
        dynamics.stored_energy().write(&self.stored, values);
        dynamics.state.account.write(&self.account, values);
    }
}

/// The first body is `body`; the others are `bogie[i]` in the order of the file, whatever they are:
/// the description has their own names.
fn attitudes(d: &mut Declaration, multibody: &Multibody) -> Vec<Handles<Attitude>> {
    let bodies = multibody.body.iter().enumerate();
    let named = bodies.map(|(i, body)| {
        let scope = match i {
            0 => Scope::from("body"),
            _ => Scope::from(format!("bogie[{i}]")),
        };
        Attitude::declare(d, scope.about(&body.name))
    });
    named.collect()
}

/// What is connected together: the couplers with the train, the wheels with the rail.
fn declare_terminals(d: &mut Declaration, wheelsets: usize) {
    for end in ["front", "rear"] {
        d.terminal(format!("coupler.{end}"), "coupler", format!("The {end} coupler"));
    }
    for number in 1..=wheelsets {
        for side in ["left", "right"] {
            let description = format!("The {side} wheel of wheelset {number} on its rail");
            d.terminal(format!("wheelset[{number}].{side}"), "wheel", description);
        }
    }
}
