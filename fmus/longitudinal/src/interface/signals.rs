//! The variables of the longitudinal FMU.
//!
//! The number of vehicles comes from `consist.toml` in the resources. The variables of the train
//! stand before those of the vehicles, so that their value references do not depend on it.

use std::path::Path;

use fmu::{Declaration, Integer, ModelError, Real, Text, unit};
use stock::Consist;

use crate::command::{EMERGENCY, HIGHEST_NOTCH};

/// Value of a driver input that leaves the schedule in force.
pub(crate) const SCHEDULE: f64 = -1.0;

/// Handles of the FMU's variables.
#[derive(Debug)]
pub struct Signals {
    pub(crate) consist_file: Text,
    pub(crate) track_file: Text,
    pub(crate) driver_file: Text,
    pub(crate) couplers: Integer,
    /// Parameter `initial.position`.
    pub position: Real,
    /// Parameter `initial.velocity`.
    pub velocity: Real,
    /// Inputs that override the schedule, and outputs of what is in force.
    pub(crate) driver: [DriverSignals; 2],
    pub(crate) control: ControlSignals,
    pub(crate) wind_speed: Real,
    pub(crate) wind_direction: Real,
    pub(crate) train: TrainSignals,
    pub(crate) energy: EnergySignals,
    /// Each vehicle's outputs, from the head of the train.
    pub vehicles: Vec<VehicleSignals>,
}

#[derive(Debug)]
pub(crate) struct DriverSignals {
    pub(crate) notch: Real,
    pub(crate) dynamic_brake: Real,
    pub(crate) train_brake: Real,
    pub(crate) locomotive_brake: Real,
}

#[derive(Debug)]
pub(crate) struct ControlSignals {
    pub(crate) target_speed: Real,
    pub(crate) measured_speed: Real,
    pub(crate) speed_rms: Real,
}

#[derive(Debug)]
pub(crate) struct TrainSignals {
    pub(crate) mass: Real,
    pub(crate) length: Real,
    pub(crate) velocity: Real,
    pub(crate) traction: Real,
    pub(crate) brake: Real,
    pub(crate) resistance: Real,
    pub(crate) curve_resistance: Real,
    pub(crate) gravity: Real,
    pub(crate) greatest_tension: Real,
    pub(crate) greatest_buff: Real,
}

#[derive(Debug)]
pub(crate) struct EnergySignals {
    pub(crate) traction: Real,
    pub(crate) dynamic_brake: Real,
    pub(crate) brake: Real,
    pub(crate) resistance: Real,
    pub(crate) curve_resistance: Real,
    pub(crate) gears: Real,
    pub(crate) kinetic: Real,
    pub(crate) potential: Real,
    pub(crate) stored: Real,
    pub(crate) residual: Real,
}

/// Handles of one vehicle's outputs.
#[derive(Debug)]
pub struct VehicleSignals {
    /// Chainage of its middle.
    pub position: Real,
    /// Velocity.
    pub velocity: Real,
    /// Acceleration.
    pub acceleration: Real,
    /// Force of the front coupler, tension positive.
    pub coupler_front: Real,
    /// Force of the rear coupler, tension positive.
    pub coupler_rear: Real,
    /// Propulsion resistance in the running direction.
    pub resistance: Real,
    /// Curve resistance in the running direction.
    pub curve_resistance: Real,
    /// Force of the drive.
    pub traction: Real,
    /// Friction force of the brake shoes.
    pub brake: Real,
    /// Heat of the friction brake into each wheel.
    pub wheel_brake_power: Real,
    /// Heat of the draft gears at the front and at the rear since the start.
    pub gear_heat: [Real; 2],
}

/// Declares the variables for the consist in the resources.
///
/// # Errors
/// When the consist file cannot be used.
pub(crate) fn declare(
    resources: &Path,
    declaration: &mut Declaration,
) -> Result<Signals, ModelError> {
    let consist =
        Consist::from_file(&resources.join("consist.toml")).map_err(ModelError::from_error)?;
    let mut file = |name: &str, what: &str| {
        let description = format!("{what}; empty: {}.toml in the resources", what.to_lowercase());
        declaration.text_parameter(name, description, "")
    };
    Ok(Signals {
        consist_file: file("consist_file", "Consist"),
        track_file: file("track_file", "Track"),
        driver_file: file("driver_file", "Driver"),
        couplers: declaration.integer_parameter(
            "initial.couplers",
            "Couplers at the start: 0 unstressed, 1 in balance",
            1,
            (0, 1),
        ),
        position: declaration
            .real("initial.position", unit::METRE, "Chainage of the leading vehicle's middle")
            .parameter(0.0),
        velocity: declaration
            .real("initial.velocity", unit::METRE_PER_SECOND, "Velocity of the train")
            .parameter(0.0),
        driver: [declare_overrides(declaration), declare_in_force(declaration)],
        control: declare_control(declaration),
        wind_speed: declaration
            .real("wind.speed", unit::METRE_PER_SECOND, "Speed of the wind")
            .min(0.0)
            .input(0.0),
        wind_direction: declaration
            .real(
                "wind.direction",
                unit::RADIAN,
                "Angle the wind comes from, to the right of the heading at the track's beginning; \
                 0 is a head wind there",
            )
            .input(0.0),
        train: declare_train(declaration),
        energy: declare_energy(declaration),
        vehicles: (1..=consist.types.len())
            .map(|number| declare_vehicle(declaration, number))
            .collect(),
    })
}

fn declare_overrides(declaration: &mut Declaration) -> DriverSignals {
    let mut input = |name: &str, greatest: f64, what: &str| {
        let description = format!("{what}; {SCHEDULE} follows the driver file");
        declaration
            .real(format!("driver.{name}"), unit::ONE, description)
            .min(SCHEDULE)
            .max(greatest)
            .input(SCHEDULE)
    };
    DriverSignals {
        notch: input("notch", HIGHEST_NOTCH, "Notch, 0 to 8"),
        dynamic_brake: input("dynamic_brake", 1.0, "Dynamic brake, share of full effort"),
        train_brake: input("train_brake", EMERGENCY, "Train brake, 1 full service, 1.2 emergency"),
        locomotive_brake: input("locomotive_brake", 1.0, "Locomotive brake, 1 full"),
    }
}

fn declare_in_force(declaration: &mut Declaration) -> DriverSignals {
    let mut output = |name: &str, what: &str| {
        let name = format!("driver.in_force.{name}");
        declaration.real(name, unit::ONE, what).output()
    };
    DriverSignals {
        notch: output("notch", "Notch in force"),
        dynamic_brake: output("dynamic_brake", "Dynamic brake in force"),
        train_brake: output("train_brake", "Train brake in force"),
        locomotive_brake: output("locomotive_brake", "Locomotive brake in force"),
    }
}

fn declare_control(declaration: &mut Declaration) -> ControlSignals {
    let mut output = |name: &str, what: &str| {
        let name = format!("driver.{name}");
        declaration.real(name, unit::METRE_PER_SECOND, what).output()
    };
    ControlSignals {
        target_speed: output("target_speed", "Speed the driver keeps to; 0 without one"),
        measured_speed: output("measured_speed", "Speed in the logger's file; 0 without one"),
        speed_rms: output(
            "speed_rms",
            "Root mean square of the difference from the measured speed since the start",
        ),
    }
}

fn declare_train(declaration: &mut Declaration) -> TrainSignals {
    let mut output = |name: &str, unit, what: &str| {
        declaration.real(format!("train.{name}"), unit, what).output()
    };
    TrainSignals {
        mass: output("mass", unit::KILOGRAM, "Mass of the train"),
        length: output("length", unit::METRE, "Length over the outer couplers, without slack"),
        velocity: output("velocity", unit::METRE_PER_SECOND, "Velocity of the centre of mass"),
        traction: output("traction.force", unit::NEWTON, "All drives, dynamic brake negative"),
        brake: output("brake.force", unit::NEWTON, "All friction brakes, not negative"),
        resistance: output("resistance.force", unit::NEWTON, "All propulsion resistance"),
        curve_resistance: output("curve_resistance.force", unit::NEWTON, "All curve resistance"),
        gravity: output("gravity.force", unit::NEWTON, "All gradients, positive downhill"),
        greatest_tension: output("coupler.tension", unit::NEWTON, "Greatest tension in a coupler"),
        greatest_buff: output("coupler.buff", unit::NEWTON, "Greatest buff force in a coupler"),
    }
}

fn declare_energy(declaration: &mut Declaration) -> EnergySignals {
    let mut output = |name: &str, what: &str| {
        declaration.real(format!("energy.{name}"), unit::JOULE, what).output()
    };
    EnergySignals {
        traction: output("traction", "Work of traction since the start"),
        dynamic_brake: output("dynamic_brake", "Work against the dynamic brakes"),
        brake: output("brake", "Work against the friction brakes"),
        resistance: output("resistance", "Work against the propulsion resistance"),
        curve_resistance: output("curve_resistance", "Work against the curve resistance"),
        gears: output("draft_gears", "Energy that the draft gears have turned into heat"),
        kinetic: output("kinetic", "Kinetic energy"),
        potential: output("potential", "Potential energy, from the zero of the elevation"),
        stored: output("stored", "Energy in the springs of the draft gears"),
        residual: output("residual", "Error of the energy balance since the start"),
    }
}

fn declare_vehicle(declaration: &mut Declaration, number: usize) -> VehicleSignals {
    for end in ["front", "rear"] {
        let description = format!("The {end} coupler of vehicle {number}");
        declaration.terminal(format!("vehicle[{number}].coupler.{end}"), "coupler", description);
    }
    let mut output = |name: &str, unit, what: &str| {
        declaration.real(format!("vehicle[{number}].{name}"), unit, what).output()
    };
    VehicleSignals {
        position: output("position", unit::METRE, "Chainage of the vehicle's middle"),
        velocity: output("velocity", unit::METRE_PER_SECOND, "Velocity"),
        acceleration: output("acceleration", unit::METRE_PER_SECOND_SQUARED, "Acceleration"),
        coupler_front: output(
            "coupler.front.force",
            unit::NEWTON,
            "Front coupler, tension positive",
        ),
        coupler_rear: output("coupler.rear.force", unit::NEWTON, "Rear coupler, tension positive"),
        resistance: output(
            "resistance.force",
            unit::NEWTON,
            "Propulsion resistance without that of curves; negative when moving forward",
        ),
        curve_resistance: output(
            "curve_resistance.force",
            unit::NEWTON,
            "Curve resistance; negative when moving forward",
        ),
        traction: output(
            "traction.force",
            unit::NEWTON,
            "Drive at the wheel rims; dynamic brake negative",
        ),
        brake: output("brake.force", unit::NEWTON, "Friction of the brake shoes, not negative"),
        wheel_brake_power: output(
            "wheel.brake_power",
            unit::WATT,
            "Heat of the friction brake into each wheel",
        ),
        gear_heat: [
            output(
                "draft_gear.front.energy",
                unit::JOULE,
                "Heat of the front gear since the start",
            ),
            output("draft_gear.rear.energy", unit::JOULE, "Heat of the rear gear since the start"),
        ],
    }
}
