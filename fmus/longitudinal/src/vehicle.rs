//! One mass of the train with all that acts on it.

use numerics::TableError;
use serde::{Deserialize, Serialize};
use track::{Track, TrackPoint};

use crate::brake::{Brake, BrakeState};
use crate::curve_resistance::CurveResistance;
use crate::driver::Command;
use crate::dynamic_brake::DynamicBrake;
use crate::gravity;
use crate::lever;
use crate::pipe::Source;
use crate::resistance::Resistance;
use crate::traction::Traction;
use crate::wind::Wind;

/// What does not change in a vehicle.
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
    /// Group of locomotives whose commands it follows.
    pub(crate) group: usize,
    /// What its brake listens to, if the pipe commands it.
    pub(crate) source: Source,
    /// Whether gradient and curve act over the whole length.
    along_its_length: bool,
    /// Places of the last lookups in the track.
    track_index: [usize; 2],
}

/// What changes in a vehicle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct VehicleState {
    /// Chainage of the vehicle's middle, m.
    pub position: f64,
    /// Velocity in the running direction, m/s.
    pub velocity: f64,
    /// Elevation of the track at the vehicle's middle, or the mean over its length, m.
    pub elevation: f64,
    /// Place of the drive between full dynamic brake (−1) and the highest notch (1).
    pub lever: f64,
    /// Friction brake.
    pub brake: BrakeState,
    /// What acts on the vehicle.
    pub forces: Forces,
}

/// The forces on a vehicle, N.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Forces {
    /// Force of the front coupler, tension positive: pulls forward.
    pub coupler_front: f64,
    /// Force of the rear coupler, tension positive: pulls backward.
    pub coupler_rear: f64,
    /// Force of the drive at the wheel rims: traction positive, dynamic brake negative when
    /// running forward.
    pub traction: f64,
    /// Force of the gradient, forward downhill.
    pub gravity: f64,
    /// What the wind adds to the propulsion resistance, positive forward.
    pub wind: f64,
    /// Greatest propulsion resistance, ≥ 0.
    pub resistance: f64,
    /// Greatest curve resistance, ≥ 0.
    pub curve_resistance: f64,
    /// Greatest friction force of the brake shoes, ≥ 0.
    pub brake: f64,
}

impl Forces {
    /// Sum of the forces that can set the vehicle in motion.
    pub fn driving(&self) -> f64 {
        self.traction + self.gravity + self.wind + self.coupler_front - self.coupler_rear
    }

    /// Sum of the forces that can only stop it.
    pub fn resisting(&self) -> f64 {
        self.resistance + self.curve_resistance + self.brake
    }

    /// The share, from −1 to 1, with which each resisting force acts in the running direction: all
    /// of it against the motion; at standstill as much as holds the vehicle.
    pub fn friction_share(&self, velocity: f64) -> f64 {
        if velocity != 0.0 {
            return -1.0_f64.copysign(velocity);
        }
        match self.resisting() {
            0.0 => 0.0,
            resisting => (-self.driving() / resisting).clamp(-1.0, 1.0),
        }
    }
}

impl VehicleState {
    /// Adds the impulse of the forces over a time `step`, s; resisting forces stop the vehicle but
    /// do not turn it back, so that a braked vehicle comes to exactly zero (theory, eq. 3).
    #[inline]
    pub(crate) fn kick(&mut self, inverse_inertia: f64, step: f64) {
        let free = self.velocity + step * inverse_inertia * self.forces.driving();
        let loss = step * inverse_inertia * self.forces.resisting();
        self.velocity = match free.abs() > loss {
            true => free - loss.copysign(free),
            false => 0.0,
        };
    }
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
            group: 0,
            source: Source::default(),
            along_its_length: file.along_its_length,
            track_index: [0; 2],
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
        (state.forces.driving() + share * state.forces.resisting()) * self.inverse_inertia
    }

    /// Moves drive and brake over a time `step`, s.
    #[inline]
    pub fn operate(&self, state: &mut VehicleState, command: &Command, step: f64) {
        if self.traction.is_some() || self.dynamic_brake.is_some() {
            state.lever = self.lever(state.lever, command.lever(), step);
        }
        let (train, locomotive) = (command.train_brake, command.locomotive_brake);
        self.brake.advance(&mut state.brake, train, locomotive, step);
    }

    /// Finds the forces, but for those of the couplers, where the vehicle is; `wind` is the speed
    /// of the air and the angle that it comes from, against the heading of the track's beginning.
    #[inline]
    pub fn act(&mut self, state: &mut VehicleState, track: &Track, wind: &Wind) {
        let place = self.place(state.position, track);
        let speed = state.velocity.abs();
        state.elevation = place.elevation;
        state.forces.traction = self.drive_force(state);
        state.forces.gravity = gravity::force(self.mass, place.gradient);
        state.forces.resistance = self.resistance.force(speed);
        state.forces.wind = match wind.speed {
            0.0 => 0.0,
            _ => self.resistance.wind(state.velocity, wind.against(place.heading)),
        };
        state.forces.curve_resistance = self.curve_resistance.force(place.curvature);
        state.forces.brake = self.brake.force(&state.brake, speed);
    }

    /// Force that the line takes from the vehicle at a place, m, and a speed, m/s, in N: what it
    /// needs to keep its speed there.
    pub(crate) fn demand(&self, position: f64, speed: f64, track: &Track) -> f64 {
        let [mut first, mut second] = self.track_index;
        let place = match self.along_its_length {
            false => track.at(position, &mut first),
            true => mean_place(position, self.length, track, &mut first, &mut second),
        };
        self.resistance.force(speed) + self.curve_resistance.force(place.curvature)
            - gravity::force(self.mass, place.gradient)
    }

    /// Track at the vehicle's middle, or its mean over the vehicle's length.
    #[inline]
    fn place(&mut self, position: f64, track: &Track) -> TrackPoint {
        let [first, second] = &mut self.track_index;
        match self.along_its_length {
            false => track.at(position, first),
            true => mean_place(position, self.length, track, first, second),
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

/// The means of gradient, curvature, heading and elevation over a length around a place. A vehicle
/// across a change of hand counts the curvature that is left of both.
fn mean_place(
    position: f64,
    length: f64,
    track: &Track,
    first: &mut usize,
    second: &mut usize,
) -> TrackPoint {
    let front = track.at(position + length / 2.0, first);
    let rear = track.at(position - length / 2.0, second);
    TrackPoint {
        gradient: (front.elevation - rear.elevation) / length,
        elevation: (front.elevation_integral - rear.elevation_integral) / length,
        curvature: (front.heading - rear.heading) / length,
        heading: (front.heading_integral - rear.heading_integral) / length,
        ..front
    }
}
