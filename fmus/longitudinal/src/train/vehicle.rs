//! One mass of the train with all that acts on it.

use numerics::TableError;
use track::Track;

use crate::brake::friction_brake::Brake;
use crate::brake::state::BrakeState;
use crate::command::Command;
use crate::drive::dynamic_brake::DynamicBrake;
use crate::drive::lever;
use crate::drive::traction::Traction;
use crate::line::gravity;
use crate::line::local_line::{LocalLine, mean_heading};
use crate::line::wind::Wind;
use crate::resistance::curve::CurveResistance;
use crate::resistance::propulsion::Resistance;
use crate::train::member::Member;
use crate::train::vehicle_state::{Forces, VehicleState};

/// What does not change in a vehicle; vehicles of a type share it.
#[derive(Clone, Debug)]
pub struct Vehicle {
    /// Mass, kg.
    pub mass: f64,
    /// Mass with that of the rotating parts' inertia, kg.
    pub inertia: f64,
    /// One over the inertia, 1/kg.
    pub(crate) inverse_inertia: f64,
    /// Length over the couplers, m.
    pub length: f64,
    resistance: Resistance,
    curve_resistance: CurveResistance,
    pub(crate) brake: Brake,
    traction: Option<Traction>,
    dynamic_brake: Option<DynamicBrake>,
    /// Whether gradient and curve act over the whole length.
    along_its_length: bool,
}

impl Vehicle {
    /// A vehicle of a type.
    ///
    /// # Errors
    /// When one of its tables cannot be used.
    pub fn new(file: &stock::Vehicle) -> Result<Self, TableError> {
        let traction = file.traction.as_ref();
        let dynamic_brake = file.dynamic_brake.as_ref();
        Ok(Self {
            mass: file.mass_kg,
            inertia: file.mass_kg + file.rotating_mass_kg,
            inverse_inertia: 1.0 / (file.mass_kg + file.rotating_mass_kg),
            length: file.length_m,
            resistance: Resistance::new(file)?,
            curve_resistance: CurveResistance::new(file)?,
            brake: Brake::new(file)?,
            traction: traction.map(|t| Traction::new(t, file.mass_kg)).transpose()?,
            dynamic_brake: dynamic_brake.map(DynamicBrake::new).transpose()?,
            along_its_length: file.along_its_length,
        })
    }

    /// Sets drive and brake to what they have after a long time of `command`.
    pub fn settle(&self, state: &mut VehicleState, command: &Command) {
        state.lever = self.lever(0.0, command.lever(), f64::INFINITY);
        state.brake = BrakeState::settled(command.train_brake, command.locomotive_brake);
        // The first change in the history of the pipe is what it has been for ever.
        state.brake.arrivals = 1;
    }

    /// Whether the vehicle is a locomotive.
    pub fn has_traction(&self) -> bool {
        self.traction.is_some()
    }

    /// Greatest effort of the drive at a lever from 0 to 1 and a speed, m/s, in N.
    pub fn tractive_effort(&self, lever: f64, speed: f64) -> f64 {
        self.traction.as_ref().map_or(0.0, |traction| traction.force(lever, speed))
    }

    /// Effort of the full dynamic brake at a speed, m/s, in N.
    pub fn dynamic_brake_effort(&self, speed: f64) -> f64 {
        self.dynamic_brake.as_ref().map_or(0.0, |brake| -brake.force(1.0, speed))
    }

    /// Force of the train brake at full service and a speed, m/s, in N.
    pub fn full_service(&self, speed: f64) -> f64 {
        self.brake.full_service(speed)
    }

    /// Friction power that goes into each wheel, W.
    pub fn wheel_brake_power(&self, state: &VehicleState) -> f64 {
        state.forces.brake * state.velocity.abs() * self.brake.wheel_share()
    }

    /// Acceleration that the forces on the vehicle give it, m/s².
    pub fn acceleration(&self, state: &VehicleState) -> f64 {
        let share = state.forces.friction_share(state.velocity);
        self.acceleration_by(&state.forces, share)
    }

    /// The same with the share of the resisting forces that acts.
    #[inline]
    pub(crate) fn acceleration_by(&self, forces: &Forces, friction_share: f64) -> f64 {
        (forces.driving() + friction_share * forces.resisting()) * self.inverse_inertia
    }

    /// Moves drive and brake over a time `step`, s.
    #[inline]
    pub(crate) fn update_drive_and_brakes(
        &self,
        member: &Member,
        state: &mut VehicleState,
        command: &Command,
        step: f64,
    ) {
        if self.traction.is_some() || self.dynamic_brake.is_some() {
            state.lever = self.lever(state.lever, command.lever(), step);
        }
        let commands = [command.train_brake, command.locomotive_brake];
        self.brake.advance(&mut state.brake, commands, member.source.distance, step);
    }

    /// Finds the forces on the vehicle where it is, but for those of its couplers.
    #[inline]
    pub(crate) fn apply_forces(
        &self,
        member: &mut Member,
        state: &mut VehicleState,
        track: &Track,
        wind: &Wind,
    ) {
        let line = self.line(state.position, track, &mut member.track_index);
        let speed = state.velocity.abs();
        state.elevation = line.elevation;
        state.forces.traction = self.drive_force(state);
        state.forces.gravity = gravity::force(self.mass, line.gradient);
        state.forces.resistance = self.resistance.force(speed);
        state.forces.wind = match wind.speed {
            0.0 => 0.0,
            _ => {
                let heading = self.heading(state.position, track, &mut member.track_index);
                self.resistance.wind(state.velocity, wind.against(heading))
            }
        };
        state.forces.curve_resistance = self.curve_resistance.force(line.curvature);
        state.forces.brake =
            self.brake.force(&state.brake, member.hand_force, speed, &mut member.friction_index);
    }

    /// Force that the vehicle needs to keep a speed, m/s, at a chainage, m, in N.
    ///
    /// `index` holds lookups near by.
    pub(crate) fn demand(
        &self,
        position: f64,
        speed: f64,
        track: &Track,
        mut index: [usize; 2],
    ) -> f64 {
        let line = self.line(position, track, &mut index);
        self.resistance.force(speed) + self.curve_resistance.force(line.curvature)
            - gravity::force(self.mass, line.gradient)
    }

    /// The line at the vehicle's middle, or its mean over the vehicle's length.
    ///
    /// `index` holds the last lookups.
    #[inline]
    fn line(&self, position: f64, track: &Track, index: &mut [usize; 2]) -> LocalLine {
        match self.along_its_length {
            true => LocalLine::mean(position, self.length, track, index),
            false => LocalLine::at(position, track, index),
        }
    }

    /// Heading of the track, as [`Self::line`].
    fn heading(&self, position: f64, track: &Track, index: &mut [usize; 2]) -> f64 {
        match self.along_its_length {
            false => track.locate(position, &mut index[0]).heading(),
            true => mean_heading(position, self.length, track, index),
        }
    }

    fn lever(&self, lever: f64, target: f64, step: f64) -> f64 {
        let target = match target > 0.0 {
            true if self.traction.is_none() => 0.0,
            false if self.dynamic_brake.is_none() => 0.0,
            _ => target,
        };
        let traction_ramp = self.traction.as_ref().map_or(0.0, |t| t.ramp);
        let dynamic_brake_ramp = self.dynamic_brake.as_ref().map_or(0.0, |b| b.ramp);
        lever::moved(lever, target, step, traction_ramp, dynamic_brake_ramp)
    }

    fn drive_force(&self, state: &VehicleState) -> f64 {
        match (&self.traction, &self.dynamic_brake) {
            (Some(traction), _) if state.lever > 0.0 => {
                traction.force(state.lever, state.velocity.abs())
            }
            (_, Some(brake)) if state.lever < 0.0 => brake.force(-state.lever, state.velocity),
            _ => 0.0,
        }
    }
}
