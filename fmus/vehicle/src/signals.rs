//! The FMU's variables.

use fmu::{Declaration, Real, Text, Values, unit};

use crate::inputs::Inputs;
use crate::patch_signals::PatchSignals;
use crate::track_forces::TrackForceSignals;
use crate::wheel::PATCHES;

/// Handles of all variables.
#[derive(Debug)]
pub struct Signals {
    pub(crate) vehicle_file: Text,
    pub(crate) track_file: Text,
    pub(crate) initial_position: Real,
    pub(crate) initial_velocity: Real,
    inputs: InputSignals,
    pub(crate) position: Real,
    pub(crate) velocity: Real,
    pub(crate) acceleration: Real,
    pub(crate) wheelsets: Vec<WheelsetSignals>,
    /// Car body, then bogie frames.
    pub(crate) bodies: Vec<AttitudeSignals>,
    pub(crate) energy: EnergySignals,
}

#[derive(Debug)]
struct InputSignals {
    front_coupler: Real,
    rear_coupler: Real,
    resistance: Real,
    traction: Real,
    brake: Real,
    synchronisation: Real,
    friction: Real,
}

/// Handles of a wheelset.
#[derive(Debug)]
pub(crate) struct WheelsetSignals {
    pub(crate) position: Real,
    pub(crate) speed: Real,
    /// Left, right.
    pub(crate) wheels: [WheelSignals; 2],
    pub(crate) track_forces: TrackForceSignals,
}

/// Handles of a wheel.
#[derive(Debug)]
pub(crate) struct WheelSignals {
    pub(crate) creepage: [Real; 3],
    pub(crate) longitudinal: Real,
    pub(crate) lateral: Real,
    pub(crate) normal: Real,
    pub(crate) friction_power: Real,
    pub(crate) a: Real,
    pub(crate) b: Real,
    pub(crate) rail_lateral: Real,
    pub(crate) standing: Real,
    pub(crate) patches: [PatchSignals; PATCHES],
}

/// Handles of the attitude of a body.
#[derive(Debug)]
pub(crate) struct AttitudeSignals {
    pub(crate) lateral: Real,
    pub(crate) vertical: Real,
    pub(crate) roll: Real,
    pub(crate) pitch: Real,
    pub(crate) yaw: Real,
}

/// Handles of the energy account.
#[derive(Debug)]
pub(crate) struct EnergySignals {
    pub(crate) kinetic: Real,
    pub(crate) elastic: Real,
    pub(crate) gravity: Real,
    pub(crate) couplers: Real,
    pub(crate) traction: Real,
    pub(crate) resistance: Real,
    pub(crate) synchronisation: Real,
    pub(crate) brake_heat: Real,
    pub(crate) suspension_heat: Real,
    pub(crate) friction_heat: Real,
    pub(crate) contact_heat: Real,
    pub(crate) track_heat: Real,
    pub(crate) irregularities: Real,
}

impl Signals {
    /// Declares the variables of a vehicle with so many wheelsets and bogie frames, whose creep
    /// law has the coefficient of friction `friction`.
    pub(crate) fn declare(
        d: &mut Declaration,
        wheelsets: usize,
        bogies: usize,
        friction: f64,
    ) -> Self {
        let car = std::iter::once(("body".to_owned(), "Car body".to_owned()));
        let frames = (1..=bogies).map(|i| (format!("bogie[{i}]"), format!("Bogie frame {i}")));
        let bodies: Vec<_> = car.chain(frames).collect();
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
            inputs: InputSignals::declare(d, friction),
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
            bodies: bodies
                .iter()
                .map(|(name, title)| AttitudeSignals::declare(d, name, title))
                .collect(),
            energy: EnergySignals::declare(d),
        }
    }

    /// The inputs of now.
    pub(crate) fn read(&self, values: &Values) -> Inputs {
        let inputs = &self.inputs;
        Inputs {
            front_coupler: values[inputs.front_coupler],
            rear_coupler: values[inputs.rear_coupler],
            resistance: values[inputs.resistance],
            traction: values[inputs.traction],
            brake: values[inputs.brake],
            synchronisation: values[inputs.synchronisation],
            friction: values[inputs.friction],
        }
    }
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

impl InputSignals {
    fn declare(d: &mut Declaration, friction: f64) -> Self {
        let mut force = |name, description| d.real(name, unit::NEWTON, description).input(0.0);
        Self {
            front_coupler: force(
                "coupler.front.force",
                "Force of the front coupler, tension positive",
            ),
            rear_coupler: force(
                "coupler.rear.force",
                "Force of the rear coupler, tension positive",
            ),
            resistance: force(
                "resistance.force",
                "Propulsion resistance along the track, negative when running forward; curve and \
                 gradient resistance are not part of it, as the model has both itself",
            ),
            traction: force(
                "traction.force",
                "Traction at the wheel rims, sum of all axles; negative: dynamic brake",
            ),
            synchronisation: force(
                "sync.force",
                "Force on the car body that keeps the vehicle in step with the train",
            ),
            brake: d
                .real(
                    "brake.force",
                    unit::NEWTON,
                    "Friction brake at the treads, sum of all wheels; opposes rotation",
                )
                .min(0.0)
                .input(0.0),
            friction: d
                .real(
                    "friction.coefficient",
                    unit::ONE,
                    "Friction coefficient of wheel and rail without slip",
                )
                .min(0.01)
                .max(1.0)
                .input(friction),
        }
    }
}

impl WheelsetSignals {
    fn declare(d: &mut Declaration, number: usize) -> Self {
        let name = format!("wheelset[{number}]");
        Self {
            position: d
                .real(format!("{name}.position"), unit::METRE, "Chainage of the wheelset")
                .output(),
            speed: d
                .real(
                    format!("{name}.speed"),
                    unit::METRE_PER_SECOND,
                    "Speed of the wheelset along the track",
                )
                .output(),
            wheels: ["left", "right"].map(|side| WheelSignals::declare(d, &name, side)),
            track_forces: TrackForceSignals::declare(d, &name),
        }
    }
}

impl WheelSignals {
    fn declare(d: &mut Declaration, wheelset: &str, side: &str) -> Self {
        let mut output = |name: &str, unit, description: &str| {
            d.real(
                format!("{wheelset}.{side}.{name}"),
                unit,
                format!("{description}, {side} wheel"),
            )
            .output()
        };
        Self {
            creepage: [
                output(
                    "creepage.longitudinal",
                    unit::ONE,
                    "Longitudinal creepage, traction positive",
                ),
                output(
                    "creepage.lateral",
                    unit::ONE,
                    "Lateral creepage, wheel slipping right positive",
                ),
                output("creepage.spin", unit::PER_METRE, "Spin creepage, positive about z down"),
            ],
            longitudinal: output(
                "force.longitudinal",
                unit::NEWTON,
                "Creep force on the wheel along the track, traction positive",
            ),
            lateral: output(
                "force.lateral",
                unit::NEWTON,
                "Creep force on the wheel in the contact plane, positive to the right",
            ),
            normal: output("force.normal", unit::NEWTON, "Normal force"),
            friction_power: output("friction_power", unit::WATT, "Power turned into heat by creep"),
            a: output("contact.a", unit::METRE, "Semi-axis of the contact in rolling direction"),
            b: output("contact.b", unit::METRE, "Semi-axis of the contact across"),
            rail_lateral: output(
                "contact.lateral_position",
                unit::METRE,
                "Contact on the rail head from its top, negative towards the gauge side",
            ),
            standing: output(
                "contact.state",
                unit::ONE,
                "0: on its rail, 1: lifted off it, 2: climbed over it or fallen off it",
            ),
            patches: std::array::from_fn(|i| {
                PatchSignals::declare(d, &format!("{wheelset}.{side}"), i + 1)
            }),
        }
    }
}

impl AttitudeSignals {
    fn declare(d: &mut Declaration, name: &str, title: &str) -> Self {
        let mut output = |what: &str, unit, description: &str| {
            d.real(format!("{name}.{what}"), unit, format!("{title}: {description}")).output()
        };
        Self {
            lateral: output(
                "lateral",
                unit::METRE,
                "displacement of the centre of mass to the right",
            ),
            vertical: output(
                "vertical",
                unit::METRE,
                "displacement of the centre of mass downwards",
            ),
            roll: output("roll", unit::RADIAN, "roll against the track, right side down positive"),
            pitch: output("pitch", unit::RADIAN, "pitch against the track, front up positive"),
            yaw: output("yaw", unit::RADIAN, "yaw against the track, front to the right positive"),
        }
    }
}

impl EnergySignals {
    fn declare(d: &mut Declaration) -> Self {
        let mut output = |name: &str, description: &str| {
            d.real(format!("energy.{name}"), unit::JOULE, description).output()
        };
        Self {
            kinetic: output("kinetic", "Kinetic energy"),
            elastic: output("elastic", "Elastic energy of suspension and contacts"),
            gravity: output("gravity", "Energy of height"),
            couplers: output("work.couplers", "Work of both couplers since the start"),
            traction: output("work.traction", "Work of the drives since the start"),
            resistance: output("work.resistance", "Work of the resistance since the start"),
            synchronisation: output("work.sync", "Work of the synchronising force since the start"),
            brake_heat: output("heat.brake", "Heat in the friction brake since the start"),
            suspension_heat: output("heat.suspension", "Heat in the suspension since the start"),
            friction_heat: output("heat.friction", "Heat by creep since the start"),
            contact_heat: output("heat.contact", "Heat in the contacts' damping since the start"),
            track_heat: output("heat.track", "Heat in the support of the rails since the start"),
            irregularities: output(
                "work.irregularities",
                "Work of the irregularities, which move the rails, since the start",
            ),
        }
    }
}
