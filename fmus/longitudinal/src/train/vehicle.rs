//! One mass of the train with all that acts on it.

use numerics::TableError;
use track::{Track, TrackPoint};

use crate::brake::friction_brake::{Brake, BrakeState};
use crate::drive::dynamic_brake::DynamicBrake;
use crate::drive::lever;
use crate::drive::traction::Traction;
use crate::driver::Command;
use crate::line::gravity;
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

    /// Puts drive and brake where `command` leads them in the long run.
    pub fn settle(&self, state: &mut VehicleState, command: &Command) {
        state.lever = self.lever(0.0, command.lever(), f64::INFINITY);
        state.brake = BrakeState::settled(command.train_brake, command.locomotive_brake);
        // The first change in the history of the pipe is what it has been for ever.
        state.brake.heard_count = 1;
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
    pub(crate) fn operate(
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

    /// Finds the forces, but for those of the couplers, where the vehicle is; `wind` is the speed
    /// of the air and the angle that it comes from, against the heading of the track's beginning.
    #[inline]
    pub(crate) fn act(
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
        state.forces.brake = self.brake.force(member, &state.brake, speed);
    }

    /// Force that the line takes from the vehicle at a place, m, and a speed, m/s, in N: what it
    /// needs to keep its speed there. `index` are the places of lookups near by.
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

    /// The line at the vehicle's middle, or its mean over the vehicle's length; `index` are the places
    /// of the last lookups.
    #[inline]
    fn line(&self, position: f64, track: &Track, index: &mut [usize; 2]) -> Line {
        if self.along_its_length {
            return mean_line(position, self.length, track, index);
        }
        let place = track.place(position, &mut index[0]);
        Line {
            gradient: place.gradient(),
            elevation: place.elevation(),
            curvature: place.curvature(),
        }
    }

    /// Heading of the track, as [`Self::line`].
    fn heading(&self, position: f64, track: &Track, index: &mut [usize; 2]) -> f64 {
        match self.along_its_length {
            false => track.place(position, &mut index[0]).heading(),
            true => {
                let [front, rear] = ends(position, self.length, track, index);
                (front.heading_integral - rear.heading_integral) / self.length
            }
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

/// What the track does to a vehicle.
struct Line {
    gradient: f64,
    elevation: f64,
    curvature: f64,
}

/// The means over a length around a place. A vehicle across a change of hand counts the curvature that
/// is left of both.
fn mean_line(position: f64, length: f64, track: &Track, index: &mut [usize; 2]) -> Line {
    let [front, rear] = ends(position, length, track, index);
    Line {
        gradient: (front.elevation - rear.elevation) / length,
        elevation: (front.elevation_integral - rear.elevation_integral) / length,
        curvature: (front.heading - rear.heading) / length,
    }
}

/// The track at the front and at the rear of a length around a place.
fn ends(position: f64, length: f64, track: &Track, index: &mut [usize; 2]) -> [TrackPoint; 2] {
    let [first, second] = index;
    [track.at(position + length / 2.0, first), track.at(position - length / 2.0, second)]
}
