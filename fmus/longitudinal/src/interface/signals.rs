//! The variables of the longitudinal FMU.
//!
//! The number of vehicles comes from `consist.toml` in the resources. The variables of the train
//! stand before those of the vehicles, so that their value references do not depend on it.

use std::path::Path;

use fmu::{Declaration, Handles, ModelError};
use stock::Consist;

use crate::command::{Command, EMERGENCY, HIGHEST_NOTCH};
use crate::line::wind::Wind;

/// Value of a driver input that leaves the driver file in force.
pub(crate) const SCHEDULE: f64 = -1.0;

/// Handles of the FMU's variables.
#[derive(Debug)]
pub struct Signals {
    /// Variables that do not depend on the number of vehicles.
    pub train: Handles<TrainSignals>,
    /// Each vehicle's outputs, from the head of the train.
    pub vehicles: Vec<Handles<VehicleSignals>>,
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
    let train = TrainSignals::declare(declaration, "");
    let vehicles = (1..=consist.types.len()).map(|number| {
        for end in ["front", "rear"] {
            let name = format!("vehicle[{number}].coupler.{end}");
            let description = format!("The {end} coupler of vehicle {number}");
            declaration.terminal(name, "coupler", description);
        }
        VehicleSignals::declare(declaration, format!("vehicle[{number}]"))
    });
    Ok(Signals { train, vehicles: vehicles.collect() })
}

fmu::variables! {
    /// Variables that do not depend on the number of vehicles.
    pub struct TrainSignals {
        /// Files of the run.
        files: "", group(Files);
        /// How the run begins.
        initial: "initial", group(Initial);
        /// Commands and speed of the driver.
        driver: "driver", group(DriverSignals);
        /// Wind over the line.
        wind: "wind", group(WindInputs);
        /// Mass and length of the train.
        size: "train", group(TrainSize);
        /// Sums and extremes over the train.
        totals: "train", group(TrainOutputs);
        /// Energy audit since the start.
        energy: "energy", group(EnergyOutputs);
    }

    /// Files of the run.
    pub struct Files: parameter {
        /// Consist; empty: consist.toml in the resources
        consist: "consist_file", file("consist.toml");
        /// Track; empty: track.toml in the resources
        track: "track_file", file("track.toml");
        /// Driver; empty: driver.toml in the resources
        driver: "driver_file", file("driver.toml");
    }

    /// How the run begins.
    #[derive(Copy)]
    pub struct Initial: parameter {
        /// Couplers at the start: 0 unstressed, 1 in balance
        couplers: "couplers", i32 = 1, 0..=1;
        /// Chainage of the leading vehicle's middle
        position: "position", METRE = 0.0;
        /// Velocity of the train
        velocity: "velocity", METRE_PER_SECOND = 0.0;
    }

    /// Commands and speed of the driver.
    #[derive(Copy)]
    pub struct DriverSignals {
        /// Inputs that override the driver file.
        overrides: "", group(Overrides);
        /// Commands in force.
        in_force: "in_force", group(InForce);
        /// Speeds that the driver keeps to or compares.
        speed: "", group(DriverSpeeds);
    }

    /// Inputs that override the driver file.
    #[derive(Copy)]
    pub struct Overrides: input {
        /// Notch, 0 to 8; -1 follows the driver file
        notch: "notch", ONE = SCHEDULE, SCHEDULE..=HIGHEST_NOTCH;
        /// Dynamic brake, share of full effort; -1 follows the driver file
        dynamic_brake: "dynamic_brake", ONE = SCHEDULE, SCHEDULE..=1.0;
        /// Train brake, 1 full service, 1.2 emergency; -1 follows the driver file
        train_brake: "train_brake", ONE = SCHEDULE, SCHEDULE..=EMERGENCY;
        /// Locomotive brake, 1 full; -1 follows the driver file
        locomotive_brake: "locomotive_brake", ONE = SCHEDULE, SCHEDULE..=1.0;
    }

    /// Commands in force.
    #[derive(Copy)]
    pub struct InForce: output {
        /// Notch in force
        notch: "notch", ONE;
        /// Dynamic brake in force
        dynamic_brake: "dynamic_brake", ONE;
        /// Train brake in force
        train_brake: "train_brake", ONE;
        /// Locomotive brake in force
        locomotive_brake: "locomotive_brake", ONE;
    }

    /// Speeds that the driver keeps to or compares.
    #[derive(Copy)]
    pub struct DriverSpeeds: output {
        /// Speed the driver keeps to; 0 without one
        target: "target_speed", METRE_PER_SECOND;
        /// Speed in the logger's file; 0 without one
        measured: "measured_speed", METRE_PER_SECOND;
        /// Root mean square of the difference from the measured speed since the start
        rms_difference: "speed_rms", METRE_PER_SECOND;
    }

    /// Wind over the line.
    #[derive(Copy)]
    pub struct WindInputs: input {
        /// Speed of the wind
        speed: "speed", METRE_PER_SECOND = 0.0, 0.0..;
        /// Angle the wind comes from, to the right of the heading at the track's beginning;
        /// 0 is a head wind there
        direction: "direction", RADIAN = 0.0;
    }

    /// Mass and length of the train, which do not change.
    #[derive(Copy)]
    pub struct TrainSize: output {
        /// Mass of the train
        mass: "mass", KILOGRAM;
        /// Length over the outer couplers, without slack
        length: "length", METRE;
    }

    /// Sums and extremes over the train.
    #[derive(Copy)]
    pub struct TrainOutputs: output {
        /// Velocity of the centre of mass
        velocity: "velocity", METRE_PER_SECOND;
        /// All drives, dynamic brake negative
        traction: "traction.force", NEWTON;
        /// All friction brakes, not negative
        brake: "brake.force", NEWTON;
        /// All propulsion resistance
        resistance: "resistance.force", NEWTON;
        /// All curve resistance
        curve_resistance: "curve_resistance.force", NEWTON;
        /// All gradients, positive downhill
        gravity: "gravity.force", NEWTON;
        /// Greatest tension in a coupler
        greatest_tension: "coupler.tension", NEWTON;
        /// Greatest buff force in a coupler
        greatest_buff: "coupler.buff", NEWTON;
    }

    /// Energy audit since the start.
    #[derive(Copy)]
    pub struct EnergyOutputs: output {
        /// Work of traction since the start
        traction: "traction", JOULE;
        /// Work against the dynamic brakes
        dynamic_brake: "dynamic_brake", JOULE;
        /// Work against the friction brakes
        brake: "brake", JOULE;
        /// Work against the propulsion resistance
        resistance: "resistance", JOULE;
        /// Work against the curve resistance
        curve_resistance: "curve_resistance", JOULE;
        /// Energy that the draft gears have turned into heat
        draft_gears: "draft_gears", JOULE;
        /// Kinetic energy
        kinetic: "kinetic", JOULE;
        /// Potential energy, from the zero of the elevation
        potential: "potential", JOULE;
        /// Energy in the springs of the draft gears
        stored: "stored", JOULE;
        /// Error of the energy balance since the start
        residual: "residual", JOULE;
    }

    /// Outputs of one vehicle.
    #[derive(Copy)]
    pub struct VehicleSignals {
        /// Motion and forces of the vehicle.
        motion_and_forces: "", group(VehicleOutputs);
        /// Its draft gears.
        gears: ["draft_gear.front", "draft_gear.rear"], group(GearOutputs) = ["front gear", "rear gear"];
    }

    /// Motion and forces of one vehicle.
    #[derive(Copy)]
    pub struct VehicleOutputs: output {
        /// Chainage of the vehicle's middle
        position: "position", METRE;
        /// Velocity
        velocity: "velocity", METRE_PER_SECOND;
        /// Acceleration
        acceleration: "acceleration", METRE_PER_SECOND_SQUARED;
        /// Front coupler, tension positive
        coupler_front: "coupler.front.force", NEWTON;
        /// Rear coupler, tension positive
        coupler_rear: "coupler.rear.force", NEWTON;
        /// Propulsion resistance without that of curves; negative when moving forward
        resistance: "resistance.force", NEWTON;
        /// Curve resistance; negative when moving forward
        curve_resistance: "curve_resistance.force", NEWTON;
        /// Drive at the wheel rims; dynamic brake negative
        traction: "traction.force", NEWTON;
        /// Friction of the brake shoes, not negative
        brake: "brake.force", NEWTON;
        /// Heat of the friction brake into each wheel
        wheel_brake_power: "wheel.brake_power", WATT;
    }

    /// What one draft gear does.
    #[derive(Copy)]
    pub struct GearOutputs: output {
        /// Heat of the {} since the start
        heat: "energy", JOULE;
    }
}

impl From<WindInputs> for Wind {
    fn from(WindInputs { speed, direction }: WindInputs) -> Self {
        Self { speed, direction }
    }
}

impl From<Command> for InForce {
    fn from(command: Command) -> Self {
        let Command { notch, dynamic_brake, train_brake, locomotive_brake } = command;
        Self { notch, dynamic_brake, train_brake, locomotive_brake }
    }
}

impl Overrides {
    /// Replaces what the driver asks for by the inputs that are set.
    ///
    /// # Errors
    /// When an input lies between [`SCHEDULE`] and 0, the one gap that a bound cannot exclude.
    pub(crate) fn apply(&self, command: &mut Command) -> Result<(), ModelError> {
        let inputs = [
            ("notch", self.notch, HIGHEST_NOTCH, &mut command.notch),
            ("dynamic_brake", self.dynamic_brake, 1.0, &mut command.dynamic_brake),
            ("train_brake", self.train_brake, EMERGENCY, &mut command.train_brake),
            ("locomotive_brake", self.locomotive_brake, 1.0, &mut command.locomotive_brake),
        ];
        for (name, value, greatest, asked) in inputs {
            if value >= 0.0 {
                *asked = value;
            } else if value != SCHEDULE {
                return Err(ModelError::new(format!(
                    "driver.{name} = {value}: must lie between 0 and {greatest}, \
                     or be {SCHEDULE} to follow the driver file"
                )));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNSET: Overrides = Overrides {
        notch: SCHEDULE,
        dynamic_brake: SCHEDULE,
        train_brake: SCHEDULE,
        locomotive_brake: SCHEDULE,
    };

    #[test]
    fn inputs_that_are_set_replace_what_the_driver_asks_for() {
        let asked = Command { notch: 8.0, train_brake: 0.3, ..Command::default() };
        let mut command = asked;
        UNSET.apply(&mut command).unwrap();
        assert_eq!(command, asked);
        let overrides = Overrides { notch: 0.0, locomotive_brake: 1.0, ..UNSET };
        overrides.apply(&mut command).unwrap();
        assert_eq!(command, Command { notch: 0.0, locomotive_brake: 1.0, ..asked });
    }

    #[test]
    fn an_input_in_the_gap_below_zero_is_refused_with_its_bounds() {
        let overrides = Overrides { train_brake: -0.5, ..UNSET };
        let message = overrides.apply(&mut Command::default()).unwrap_err().to_string();
        assert!(
            message.contains("driver.train_brake = -0.5: must lie between 0 and 1.2, or be -1"),
            "{message}"
        );
    }
}
