//! The gears between two vehicles in one direction, draft or buff: force and energy over the
//! deflection behind the slack.
//!
//! With the locked stiffness K and the two curves of the gears in series, the force follows (theory,
//! eq. 7)
//!
//! ```text
//! F(d + Δd) = clamp(F(d) + K Δd, F_unloading(d + Δd) − C v², F_loading(d + Δd) + C v²)
//! ```
//!
//! with C of a hydraulic cushion in the direction that it resists. The law does not depend on the
//! rate but for that, so no transition speed has to be chosen: laws that blend the curves by the
//! speed make simulators unstable (international benchmark of longitudinal train dynamics
//! simulators, Wu et al. 2018). Who wants one gives a transition speed v_e (theory, eq. 7a):
//!
//! ```text
//! F = (F_loading + F_unloading)/2 + clamp(v/v_e, −1, 1) (F_loading − F_unloading)/2
//! ```

use numerics::LinearTable;

use crate::coupling::draft_gear::{Curve, Side};

/// What the gears do in one direction.
#[derive(Clone, Debug)]
pub(crate) struct ConnectionSide {
    locked_stiffness: f64,
    locked_flexibility: f64,
    damping: f64,
    transition_speed: f64,
    orifice: Option<LinearTable>,
    loading: Curve,
    pieces: Vec<Piece>,
}

/// A piece of deflection over which both curves are straight.
#[derive(Clone, Copy, Debug)]
struct Piece {
    /// Deflections behind the slack at which the piece begins and ends, m; the last has no end.
    begin: f64,
    end: f64,
    /// Forces at the beginning of the piece, N, and their slopes, N/m.
    loading: f64,
    loading_slope: f64,
    unloading: f64,
    unloading_slope: f64,
    /// Deflections that friction holds at the beginning and at the end of the piece, m.
    ///
    /// They are what is left of the deflection of the unloading curve when its force is taken away.
    held: f64,
    held_end: f64,
    /// Energy that is stored then, J.
    held_energy: f64,
    /// Slope of the unloading curve over the held deflection, N/m.
    held_slope: f64,
    /// Energy under the mean of both curves up to the beginning of the piece, J.
    mean_energy: f64,
}

impl ConnectionSide {
    /// What two gears in series do.
    pub fn new(gear: Side) -> Self {
        let ends = gear.loading.points().iter().chain(gear.unloading.points());
        let mut begins: Vec<f64> = ends.map(|point| point.0).collect();
        begins.sort_by(f64::total_cmp);
        begins.dedup();
        Self {
            locked_stiffness: gear.locked_stiffness,
            locked_flexibility: 1.0 / gear.locked_stiffness,
            damping: gear.damping,
            transition_speed: gear.transition_speed,
            pieces: pieces(&gear, &begins),
            orifice: gear.orifice,
            loading: gear.loading,
        }
    }

    /// Deflection on the loading curve at a force, m.
    pub fn loaded_to(&self, force: f64) -> f64 {
        self.loading.deflection(force)
    }

    /// Force after a change of the deflection by `moved`, m, from the force `before`, N.
    ///
    /// `beyond` is the new deflection behind the slack, m, `speed` that of being pushed in, m/s, and
    /// `index` the piece of the last lookup.
    #[inline]
    pub fn force(
        &self,
        before: f64,
        moved: f64,
        beyond: f64,
        speed: f64,
        index: &mut usize,
    ) -> f64 {
        let (least, most) = self.piece_at(beyond, index).band(beyond);
        if self.transition_speed > 0.0 {
            let share = (speed / self.transition_speed).clamp(-1.0, 1.0);
            return (most + least + share * (most - least)) / 2.0;
        }
        let trial = before + self.locked_stiffness * moved;
        match &self.orifice {
            None if trial < least => least,
            None if trial > most => most,
            None => trial,
            Some(orifice) => {
                let cushion = orifice.value(beyond, &mut 0) * speed * speed;
                match speed > 0.0 {
                    true => trial.max(least).min(most + cushion),
                    false => trial.max((least - cushion).max(0.0)).min(most),
                }
            }
        }
    }

    /// Force of the damping at a speed, m/s, in N.
    pub fn damping_force(&self, speed: f64) -> f64 {
        self.damping * speed
    }

    /// Energy that the gears give back when they are let go, J (theory, eq. 8).
    ///
    /// With a transition speed it is what they give back when they are let go slowly. `index` is the
    /// piece of the last lookup.
    #[inline]
    pub fn stored_energy(&self, force: f64, beyond: f64, mut index: usize) -> f64 {
        if self.transition_speed > 0.0 {
            let piece = self.piece_at(beyond, &mut index);
            let distance = beyond - piece.begin;
            let mean = (piece.loading + piece.unloading) / 2.0;
            let slope = (piece.loading_slope + piece.unloading_slope) / 2.0;
            return piece.mean_energy + distance * (mean + slope * distance / 2.0);
        }
        let elastic = force * self.locked_flexibility;
        let held = beyond - elastic;
        if held <= 0.0 {
            return force * elastic / 2.0;
        }
        let piece = self.piece_held_at(held, index);
        let past = held - piece.held;
        let mean_force = piece.unloading + piece.held_slope * past / 2.0;
        piece.held_energy + past * mean_force + force * elastic / 2.0
    }

    /// Greatest stiffness, N/m, and damping, N s/m, up to a speed of the gears, m/s.
    ///
    /// They limit the step.
    pub fn stiffest(&self, speed: f64) -> (f64, f64) {
        let orifice = self.orifice.iter().flat_map(|orifice| orifice.y());
        let cushion = 2.0 * speed * orifice.fold(0.0, |a: f64, b| a.max(*b));
        if self.transition_speed == 0.0 {
            return (self.locked_stiffness, self.damping + cushion);
        }
        let steepest = self.pieces.iter().fold(0.0, |a: f64, piece| a.max(piece.loading_slope));
        let gap =
            self.pieces.iter().fold(0.0, |a: f64, piece| a.max(piece.loading - piece.unloading));
        (steepest, self.damping + cushion + gap / (2.0 * self.transition_speed))
    }

    /// The piece that holds a deflection behind the slack, searched from the last one.
    #[inline]
    fn piece_at(&self, beyond: f64, index: &mut usize) -> &Piece {
        match self.pieces.get(*index) {
            Some(piece) if beyond >= piece.begin && beyond < piece.end => piece,
            _ => {
                let after = self.pieces.partition_point(|piece| piece.begin <= beyond);
                *index = after.saturating_sub(1);
                &self.pieces[*index]
            }
        }
    }

    /// The piece whose unloading curve is met from a held deflection, searched from the last one.
    #[inline]
    fn piece_held_at(&self, held: f64, index: usize) -> &Piece {
        match self.pieces.get(index) {
            Some(piece) if held >= piece.held && held < piece.held_end => piece,
            _ => {
                let after = self.pieces.partition_point(|piece| piece.held <= held);
                &self.pieces[after.saturating_sub(1)]
            }
        }
    }
}

impl Piece {
    /// Force of the unloading and of the loading curve at a deflection behind the slack.
    #[inline]
    fn band(&self, beyond: f64) -> (f64, f64) {
        let distance = beyond - self.begin;
        (
            self.unloading + distance * self.unloading_slope,
            self.loading + distance * self.loading_slope,
        )
    }
}

/// The pieces between the deflections `begins`, and the one beyond the last.
fn pieces(gear: &Side, begins: &[f64]) -> Vec<Piece> {
    let slope = |curve: &Curve, i: usize| match begins.get(i + 1) {
        Some(end) => (curve.force(*end) - curve.force(begins[i])) / (end - begins[i]),
        None => curve.end_stiffness(),
    };
    let mut pieces: Vec<Piece> = Vec::with_capacity(begins.len());
    for (i, &begin) in begins.iter().enumerate() {
        let (loading, unloading) = (gear.loading.force(begin), gear.unloading.force(begin));
        let held = begin - unloading / gear.locked_stiffness;
        let (held_energy, mean_energy) = match pieces.last() {
            None => (0.0, 0.0),
            Some(before) => {
                let mean = (before.unloading + unloading) / 2.0;
                let both = (mean + (before.loading + loading) / 2.0) / 2.0;
                (
                    before.held_energy + mean * (held - before.held),
                    before.mean_energy + both * (begin - begins[i - 1]),
                )
            }
        };
        if let Some(before) = pieces.last_mut() {
            (before.end, before.held_end) = (begin, held);
        }
        let unloading_slope = slope(&gear.unloading, i);
        pieces.push(Piece {
            begin,
            end: f64::INFINITY,
            loading,
            loading_slope: slope(&gear.loading, i),
            unloading,
            unloading_slope,
            held,
            held_end: f64::INFINITY,
            held_energy,
            held_slope: unloading_slope / (1.0 - unloading_slope / gear.locked_stiffness),
            mean_energy,
        });
    }
    pieces
}
