//! Friction brakes of a vehicle: train brake by cable or pipe, locomotive brake, hand brake.
//!
//! All press the same shoes, so that the strongest counts (theory, eq. 16):
//!
//! ```text
//! F = max(c β, c_L β_L, h β_H) m g μ(v)      c = 1 full service, 1.2 emergency
//! ```
//!
//! with the cylinder fraction c of the train brake (`ecp.rs`, `air.rs`), that of the
//! locomotive brake c_L, the share h of the hand brake that the consist file applies, the net
//! braking ratios β and the friction μ of the shoes. The share of the power F v that goes into a
//! wheel is an output for the heat of wheels and rails.

use numerics::constants::{KILOMETRES_PER_HOUR, STANDARD_GRAVITY};
use numerics::{LinearTable, TableError};
use stock::BrakeControl;

use crate::brake::air::AirBrake;
use crate::brake::ecp::EcpBrake;
use crate::brake::state::BrakeState;

/// Friction brakes of one vehicle.
#[derive(Clone, Debug, PartialEq)]
pub struct Brake {
    control: Control,
    /// Force of all shoes on the wheels at full service, N.
    shoe_force: f64,
    /// Friction coefficient of the shoes over m/s.
    friction: LinearTable,
    locomotive: Option<LocomotiveBrake>,
    /// Force of the shoes by the hand brake when fully applied, N, if there is one.
    hand_brake: Option<f64>,
    /// Share of the friction power that goes into one wheel.
    wheel_share: f64,
}

#[derive(Clone, Debug, PartialEq)]
enum Control {
    Ecp(EcpBrake),
    Air(Box<AirBrake>),
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct LocomotiveBrake {
    shoe_force: f64,
    build_up_rate: f64,
    release_rate: f64,
}

impl Brake {
    /// The brakes of a vehicle.
    ///
    /// # Errors
    /// When a table cannot be used.
    pub fn new(vehicle: &stock::Vehicle) -> Result<Self, TableError> {
        let (file, weight) = (&vehicle.brake, vehicle.mass_kg * STANDARD_GRAVITY);
        let speeds = file.shoe_friction.speed_kmh.iter().map(|v| v / KILOMETRES_PER_HOUR).collect();
        let control = match (file.control, &file.air) {
            (BrakeControl::Air, Some(air)) => Control::Air(Box::new(AirBrake::new(air))),
            _ => Control::Ecp(EcpBrake::new(file)),
        };
        Ok(Self {
            control,
            shoe_force: file.net_braking_ratio * weight,
            friction: LinearTable::new(speeds, file.shoe_friction.value.clone())?,
            locomotive: vehicle.locomotive_brake.as_ref().map(|brake| LocomotiveBrake {
                shoe_force: brake.net_braking_ratio * weight,
                build_up_rate: 1.0 / brake.build_up_s,
                release_rate: 1.0 / brake.release_s,
            }),
            hand_brake: vehicle.hand_brake.as_ref().map(|brake| brake.net_braking_ratio * weight),
            wheel_share: file.wheel_heat_share / (2.0 * f64::from(vehicle.axles)),
        })
    }

    /// Force of the shoes by a share of the hand brake, N; nothing without a hand brake.
    pub(crate) fn hand_force(&self, share: f64) -> Option<f64> {
        match share {
            0.0 => Some(0.0),
            share => self.hand_brake.map(|full| share * full),
        }
    }

    /// The air brake, if the pipe commands this vehicle.
    pub(crate) fn air(&self) -> Option<&AirBrake> {
        match &self.control {
            Control::Air(air) => Some(air),
            Control::Ecp(_) => None,
        }
    }

    /// Advances the brakes by a time `step`, s.
    ///
    /// The commands are those by cable and of the locomotive brake; an air brake follows what has
    /// arrived along the pipe, `distance`, m, from the source of its air.
    #[inline]
    pub(crate) fn advance(
        &self,
        state: &mut BrakeState,
        [train, locomotive]: [f64; 2],
        distance: f64,
        step: f64,
    ) {
        match &self.control {
            Control::Ecp(ecp) => ecp.advance(&mut state.ecp, &mut state.cylinder, train, step),
            Control::Air(air) => air.advance(state, distance, step),
        }
        if let Some(brake) = &self.locomotive {
            let missing = locomotive - state.locomotive_cylinder;
            let change = missing.max(-brake.release_rate * step).min(brake.build_up_rate * step);
            state.locomotive_cylinder += change;
        }
    }

    /// Greatest force against the motion at a speed, m/s, in N.
    ///
    /// `hand_force` is the force of the shoes by the hand brake, N, and `index` that of the last
    /// lookup in their friction.
    #[inline]
    pub(crate) fn force(
        &self,
        state: &BrakeState,
        hand_force: f64,
        speed: f64,
        index: &mut usize,
    ) -> f64 {
        let train = state.cylinder * self.shoe_force;
        let locomotive = match &self.locomotive {
            Some(brake) => state.locomotive_cylinder * brake.shoe_force,
            None => 0.0,
        };
        let greater = |a: f64, b: f64| if a > b { a } else { b };
        match greater(greater(train, locomotive), hand_force) {
            0.0 => 0.0,
            shoes => shoes * self.friction.value(speed, index),
        }
    }

    /// Force of the train brake at full service and a speed, m/s, in N.
    pub fn full_service(&self, speed: f64) -> f64 {
        self.shoe_force * self.friction.value(speed, &mut 0)
    }

    /// Share of the friction power that goes into one wheel.
    pub fn wheel_share(&self) -> f64 {
        self.wheel_share
    }
}
