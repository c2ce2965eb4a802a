//! The FMU's variables.
//!
//! | file | part |
//! |---|---|
//! | `inputs.rs` | forces from outside, and the friction of the rails |
//! | `wheelset.rs` | a wheelset and its wheels |
//! | `contact.rs` | a contact, or all of a wheel together |
//! | `track_forces.rs` | Y, Q and what is formed from them |
//! | `body.rs` | attitudes of the bodies, accelerations of the first one |
//! | `energy.rs` | the energy account |

mod body;
mod contact;
mod energy;
mod inputs;
mod track_forces;
mod wheelset;

use fmu::{Declaration, Real, Text, Values, unit};
use nalgebra::Vector3;
use stock::Multibody;

use crate::dynamics::Dynamics;
use crate::dynamics::inputs::Inputs;
use body::{AccelerationSignals, AttitudeSignals};
use energy::EnergySignals;
use inputs::InputSignals;
use wheelset::WheelsetSignals;

/// Handles of all variables.
#[derive(Debug)]
pub struct Signals {
    pub(crate) vehicle_file: Text,
    pub(crate) track_file: Text,
    pub(crate) initial_position: Real,
    pub(crate) initial_velocity: Real,
    inputs: InputSignals,
    position: Real,
    velocity: Real,
    acceleration: Real,
    wheelsets: Vec<WheelsetSignals>,
    /// Car body, then all others but the wheelsets.
    bodies: Vec<AttitudeSignals>,
    body_acceleration: AccelerationSignals,
    energy: EnergySignals,
}

impl Signals {
    /// Declares the variables of a vehicle with these bodies and wheelsets.
    pub(crate) fn declare(d: &mut Declaration, multibody: &Multibody) -> Self {
        let wheelsets = multibody.wheelset.len();
        declare_terminals(d, wheelsets);
        Self {
            vehicle_file: d.text_parameter(
                "vehicle_file",
                "Vehicle file; empty: vehicle.toml in the FMU's resources",
                "",
            ),
            track_file: d.text_parameter(
                "track_file",
                "Track file; empty: track.toml in the FMU's resources",
                "",
            ),
            initial_position: d
                .real("initial.position", unit::METRE, "Chainage of the vehicle's middle at first")
                .parameter(0.0),
            initial_velocity: d
                .real("initial.velocity", unit::METRE_PER_SECOND, "Speed at first")
                .parameter(0.0),
            inputs: InputSignals::declare(d, multibody.contact.creep.friction),
            position: d.real("position", unit::METRE, "Chainage of the vehicle's middle").output(),
            velocity: d
                .real("velocity", unit::METRE_PER_SECOND, "Speed of the car body along the track")
                .output(),
            acceleration: d
                .real(
                    "acceleration",
                    unit::METRE_PER_SECOND_SQUARED,
                    "Acceleration of the car body along the track in the last step",
                )
                .output(),
            wheelsets: (1..=wheelsets).map(|i| WheelsetSignals::declare(d, i)).collect(),
            bodies: attitudes(d, multibody),
            body_acceleration: AccelerationSignals::declare(d),
            energy: EnergySignals::declare(d),
        }
    }

    /// Number of declared wheelsets, and of the other bodies.
    pub(crate) fn shape(&self) -> [usize; 2] {
        [self.wheelsets.len(), self.bodies.len()]
    }

    /// The inputs of now.
    pub(crate) fn read(&self, values: &Values) -> Inputs {
        self.inputs.read(values)
    }

    /// Shows the vehicle, whose first body has felt `felt` in the last step (eq. 41).
    pub(crate) fn write(&self, dynamics: &Dynamics, felt: &Vector3<f64>, values: &mut Values) {
        values[self.position] = dynamics.position();
        values[self.velocity] = dynamics.velocity();
        values[self.acceleration] = dynamics.acceleration;
        let wheelsets = dynamics.structure.wheelsets.iter().zip(&dynamics.wheels);
        for (handles, (data, wheels)) in self.wheelsets.iter().zip(wheelsets) {
            let state = &dynamics.state.bodies[data.body];
            handles.write(state, wheels, data.static_wheel_load, values);
        }
        for (handles, state) in self.bodies.iter().zip(&dynamics.state.bodies) {
            handles.write(state, values);
        }
        self.body_acceleration.write(felt, values);
        self.energy.write(&dynamics.stored_energy(), &dynamics.state.account, values);
    }
}

/// The first body is `body`; the others are `bogie[i]` in the order of the file, whatever they are:
/// the description has their own names.
fn attitudes(d: &mut Declaration, multibody: &Multibody) -> Vec<AttitudeSignals> {
    let bodies = multibody.body.iter().enumerate();
    let named = bodies.map(|(i, body)| match i {
        0 => AttitudeSignals::declare(d, "body", &body.name),
        _ => AttitudeSignals::declare(d, &format!("bogie[{i}]"), &body.name),
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
