//! The connection of two vehicles: two draft gears in series with slack.
//!
//! The deflection d (theory, eq. 4) is positive in draft. Within half the slack on either side there is no force;
//! beyond it the gears act as `connection_side.rs` says, in draft and in buff each with curves of
//! its own.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::coupling::connection_side::ConnectionSide;
use crate::coupling::draft_gear::DraftGear;

/// Two draft gears in series; the connections between equal vehicles share it.
#[derive(Clone, Debug)]
pub struct GearPair {
    draft: ConnectionSide,
    buff: ConnectionSide,
    /// Share of the gear of the vehicle in front in the heat of both.
    front_loss_share: f64,
}

impl GearPair {
    /// The gears of the vehicle in front and of the one behind it.
    pub fn new(front: &DraftGear, rear: &DraftGear) -> Self {
        Self {
            draft: ConnectionSide::new(front.draft.in_series(&rear.draft)),
            buff: ConnectionSide::new(front.buff.in_series(&rear.buff)),
            front_loss_share: front.buff.loss_share(&rear.buff),
        }
    }

    /// What is loaded when the deflection or the force has this sign.
    #[inline]
    fn side(&self, sign: f64) -> &ConnectionSide {
        if sign > 0.0 { &self.draft } else { &self.buff }
    }
}

/// A connection between two vehicles.
#[derive(Clone, Debug)]
pub struct Connection {
    /// Distance of the vehicles' middles in the middle of the slack, m.
    rest_distance: f64,
    /// Half of the free play, m.
    half_slack: f64,
    gears: Arc<GearPair>,
    /// Piece of the curves at the last lookup.
    index: usize,
}

/// What changes in a connection.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ConnectionState {
    /// Deflection from the middle of the slack, positive in draft, m.
    pub deflection: f64,
    /// Force of the gears' friction and springs, tension positive, N.
    pub gear_force: f64,
    /// Force of the connection with damping, tension positive, N.
    pub force: f64,
    /// Energy that the connection has taken since it was without stress, J.
    pub taken: f64,
}

impl Connection {
    /// The connection by two gears with `slack` as their whole free play, m.
    ///
    /// `rest_distance` is the distance of the vehicles' middles in the middle of the slack, m.
    pub fn new(gears: Arc<GearPair>, slack: f64, rest_distance: f64) -> Self {
        Self { rest_distance, half_slack: slack / 2.0, gears, index: 0 }
    }

    /// Distance of the vehicles' middles in the middle of the slack, m.
    pub fn rest_distance(&self) -> f64 {
        self.rest_distance
    }

    /// Share of the gear of the vehicle in front in the heat of both.
    pub fn front_loss_share(&self) -> f64 {
        self.gears.front_loss_share
    }

    /// The state in which the gears have come to `force` on the loading curve.
    pub fn loaded_to(&self, force: f64) -> ConnectionState {
        let deflection = match force {
            0.0 => 0.0,
            _ => (self.half_slack + self.gears.side(force).loaded_to(force.abs())).copysign(force),
        };
        let mut state = ConnectionState { deflection, gear_force: force, force, taken: 0.0 };
        state.taken = self.stored_energy(&state);
        state
    }

    /// Moves the connection to a new deflection, m; gives the work done on it, J.
    ///
    /// `velocity` is the rate of the deflection, m/s.
    #[inline]
    pub fn move_to(&mut self, state: &mut ConnectionState, deflection: f64, velocity: f64) -> f64 {
        let beyond = deflection.abs() - self.half_slack;
        let (gear_force, damping) = match beyond > 0.0 {
            false => (0.0, 0.0),
            true => {
                let sign = 1.0_f64.copysign(deflection);
                let side = self.gears.side(deflection);
                let (before, speed) = (sign * state.gear_force, sign * velocity);
                let moved = sign * (deflection - state.deflection);
                let force = side.force(before, moved, beyond, speed, &mut self.index);
                let damping = if force > 0.0 { side.damping_force(speed) } else { 0.0 };
                (sign * force, sign * damping)
            }
        };
        let force = gear_force + damping;
        let work = (state.force + force) / 2.0 * (deflection - state.deflection);
        *state = ConnectionState { deflection, gear_force, force, taken: state.taken + work };
        work
    }

    /// Energy that the gears give back when they are let go, J (theory, eq. 8).
    #[inline]
    pub fn stored_energy(&self, state: &ConnectionState) -> f64 {
        let beyond = state.deflection.abs() - self.half_slack;
        match beyond > 0.0 {
            true => {
                let side = self.gears.side(state.deflection);
                side.stored_energy(state.gear_force.abs(), beyond, self.index)
            }
            false => 0.0,
        }
    }

    /// Greatest stiffness, N/m, and damping, N s/m, at a speed of the gears, m/s.
    pub fn stiffest(&self, speed: f64) -> (f64, f64) {
        let GearPair { draft, buff, .. } = self.gears.as_ref();
        let (draft, buff) = (draft.stiffest(speed), buff.stiffest(speed));
        (draft.0.max(buff.0), draft.1.max(buff.1))
    }
}
