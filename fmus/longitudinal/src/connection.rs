//! The connection of two vehicles: two draft gears in series with slack.
//!
//! With the deflection d positive in draft, the locked stiffness K and the two curves of the gears
//! in series behind half the slack, the gear force follows (theory, eq. 7)
//!
//! ```text
//! F(d + Δd) = clamp(F(d) + K Δd, F_unloading(d + Δd), F_loading(d + Δd))
//! ```
//!
//! and in buff the mirror image of it. The law does not depend on the rate, so no transition speed
//! has to be chosen: laws that blend the curves by the speed make simulators unstable
//! (international benchmark of longitudinal train dynamics simulators, Wu et al. 2018).

use serde::{Deserialize, Serialize};

use crate::draft_gear::{Curve, DraftGear};

/// A connection between two vehicles.
#[derive(Clone, Debug)]
pub struct Connection {
    /// Distance of the vehicles' middles in the middle of the slack, m.
    rest_distance: f64,
    /// Half of the free play, m.
    half_slack: f64,
    locked_stiffness: f64,
    locked_flexibility: f64,
    damping: f64,
    loading: Curve,
    /// Deflections behind the slack at which the pieces begin.
    begins: Vec<f64>,
    pieces: Vec<Piece>,
    /// Piece of the last lookup.
    index: usize,
}

/// A piece of deflection over which both curves are straight.
#[derive(Clone, Copy, Debug)]
struct Piece {
    /// Forces at the beginning of the piece, N, and their slopes, N/m.
    loading: f64,
    loading_slope: f64,
    unloading: f64,
    unloading_slope: f64,
    /// Deflection that friction holds when the force is taken away from the unloading curve at
    /// the beginning of the piece, m.
    held: f64,
    /// Energy that is stored then, J.
    held_energy: f64,
    /// Slope of the unloading curve over the held deflection, N/m.
    held_slope: f64,
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
}

impl Connection {
    /// The connection of two gears with `slack` as their whole free play, between vehicles whose
    /// middles are `rest_distance` apart in the middle of the slack, m.
    pub fn new(front: &DraftGear, rear: &DraftGear, slack: f64, rest_distance: f64) -> Self {
        let gear = front.in_series(rear);
        let ends = gear.loading.points().iter().chain(gear.unloading.points());
        let mut begins: Vec<f64> = ends.map(|point| point.0).collect();
        begins.sort_by(f64::total_cmp);
        begins.dedup();
        Self {
            rest_distance,
            half_slack: slack / 2.0,
            locked_stiffness: gear.locked_stiffness,
            locked_flexibility: 1.0 / gear.locked_stiffness,
            damping: gear.damping,
            pieces: pieces(&gear, &begins),
            begins,
            loading: gear.loading,
            index: 0,
        }
    }

    /// Distance of the vehicles' middles in the middle of the slack, m.
    pub fn rest_distance(&self) -> f64 {
        self.rest_distance
    }

    /// The state in which the gears have come to `force` on the loading curve.
    pub fn loaded_to(&self, force: f64) -> ConnectionState {
        let deflection = match force {
            0.0 => 0.0,
            _ => (self.half_slack + self.loading.deflection(force.abs())).copysign(force),
        };
        ConnectionState { deflection, gear_force: force, force }
    }

    /// Moves the connection to a new deflection, m, with `velocity` as its rate, m/s; gives the
    /// work done on it, J.
    pub fn move_to(&mut self, state: &mut ConnectionState, deflection: f64, velocity: f64) -> f64 {
        let before = *state;
        let gear_force = match deflection.abs() - self.half_slack {
            beyond if beyond > 0.0 => {
                let moved = deflection - before.deflection;
                let trial = before.gear_force + self.locked_stiffness * moved;
                let (least, most) = self.band(beyond);
                let side = 1.0_f64.copysign(deflection);
                side * (side * trial).max(least).min(most)
            }
            _ => 0.0,
        };
        let damping = match gear_force {
            0.0 => 0.0,
            _ => self.damping * velocity,
        };
        *state = ConnectionState { deflection, gear_force, force: gear_force + damping };
        (before.force + state.force) / 2.0 * (deflection - before.deflection)
    }

    /// Energy that the gears give back when they are let go, J (theory, eq. 8).
    pub fn stored_energy(&self, state: &ConnectionState) -> f64 {
        let force = state.gear_force.abs();
        let elastic = force * self.locked_flexibility;
        let held = state.deflection.abs() - self.half_slack - elastic;
        if held <= 0.0 {
            return force * elastic / 2.0;
        }
        let piece = self.piece_held_at(held);
        let beyond = held - piece.held;
        let mean_force = piece.unloading + piece.held_slope * beyond / 2.0;
        piece.held_energy + beyond * mean_force + force * elastic / 2.0
    }

    /// The piece whose unloading curve is met from a held deflection, searched from the piece of
    /// the last lookup.
    fn piece_held_at(&self, held: f64) -> &Piece {
        let mut i = self.index;
        while i > 0 && held < self.pieces[i].held {
            i -= 1;
        }
        while i + 1 < self.pieces.len() && held >= self.pieces[i + 1].held {
            i += 1;
        }
        &self.pieces[i]
    }

    /// Force of the unloading and of the loading curve at a deflection behind the slack.
    fn band(&mut self, beyond: f64) -> (f64, f64) {
        let last = self.begins.len() - 1;
        self.index = match beyond >= self.begins[last] {
            true => last,
            false => numerics::interval(&self.begins, beyond, self.index),
        };
        let piece = &self.pieces[self.index];
        let distance = beyond - self.begins[self.index];
        (
            piece.unloading + distance * piece.unloading_slope,
            piece.loading + distance * piece.loading_slope,
        )
    }
}

/// The pieces between the deflections `begins`, and the one beyond the last.
fn pieces(gear: &DraftGear, begins: &[f64]) -> Vec<Piece> {
    let slope = |curve: &Curve, i: usize| match begins.get(i + 1) {
        Some(end) => (curve.force(*end) - curve.force(begins[i])) / (end - begins[i]),
        None => curve.end_stiffness(),
    };
    let mut pieces: Vec<Piece> = Vec::with_capacity(begins.len());
    for (i, &begin) in begins.iter().enumerate() {
        let unloading = gear.unloading.force(begin);
        let held = begin - unloading / gear.locked_stiffness;
        let held_energy = match pieces.last() {
            None => 0.0,
            Some(before) => {
                let mean = (before.unloading + unloading) / 2.0;
                before.held_energy + mean * (held - before.held)
            }
        };
        let unloading_slope = slope(&gear.unloading, i);
        pieces.push(Piece {
            loading: gear.loading.force(begin),
            loading_slope: slope(&gear.loading, i),
            unloading,
            unloading_slope,
            held,
            held_energy,
            held_slope: unloading_slope / (1.0 - unloading_slope / gear.locked_stiffness),
        });
    }
    pieces
}
