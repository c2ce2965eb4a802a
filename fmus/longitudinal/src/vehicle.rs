//! One mass of the train with all that acts on it.

use numerics::TableError;
use serde::{Deserialize, Serialize};
use track::Track;

use crate::brake::{Brake, BrakeState};
use crate::curve_resistance::CurveResistance;
use crate::driver::Command;
use crate::dynamic_brake::DynamicBrake;
use crate::gravity;
use crate::lever;
use crate::resistance::Resistance;
use crate::traction::Traction;

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
    brake: Brake,
    traction: Option<Traction>,
    dynamic_brake: Option<DynamicBrake>,
    /// Place of the last lookup in the track.
    track_index: usize,
}

/// What changes in a vehicle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct VehicleState {
    /// Chainage of the vehicle's middle, m.
    pub position: f64,
    /// Velocity in the running direction, m/s.
    pub velocity: f64,
    /// Elevation of the track at the vehicle's middle, m.
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
        self.traction + self.gravity + self.coupler_front - self.coupler_rear
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
            resistance: Resistance::new(file),
            curve_resistance: CurveResistance::new(file),
            brake: Brake::new(file)?,
            traction: traction.map(|t| Traction::new(t, file.mass_kg)).transpose()?,
            dynamic_brake: dynamic_brake.map(DynamicBrake::new).transpose()?,
            track_index: 0,
        })
    }

    /// Puts drive and brake where `command` leads them in the long run.
    pub fn settle(&self, state: &mut VehicleState, command: &Command) {
        state.lever = self.lever(0.0, command.lever(), f64::INFINITY);
        state.brake = BrakeState::settled(command.train_brake);
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
        self.brake.advance(&mut state.brake, command.train_brake, step);
    }

    /// Finds the forces, but for those of the couplers, where the vehicle is.
    #[inline]
    pub fn act(&mut self, state: &mut VehicleState, track: &Track) {
        let place = track.at(state.position, &mut self.track_index);
        let speed = state.velocity.abs();
        state.elevation = place.elevation;
        state.forces.traction = self.drive_force(state);
        state.forces.gravity = gravity::force(self.mass, place.gradient);
        state.forces.resistance = self.resistance.force(speed);
        state.forces.curve_resistance = self.curve_resistance.force(place.curvature);
        state.forces.brake = self.brake.force(&state.brake, speed);
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
