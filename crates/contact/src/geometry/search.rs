//! The quasi-elastic search for the contact of one wheel at one placement.
//!
//! A rigid wheel touches a rigid rail where the vertical gap g(y) is least. With S1002 on 60E1 this
//! point jumps by up to 15 mm when the wheel shifts by a hair, and forces would jump with it. A real
//! contact spreads over all points whose gap is no more than the elastic approach. So, after Arnold
//! and Netter (Z. Angew. Math. Mech. 78 (1998) S1) and Arnold and Frischmuth, the least gap is
//! replaced by its smooth minimum, and every other quantity q by its mean with the same weights:
//!
//! ```text
//! drop = -s ln( integral exp(-g/s) dy ),   <q> = integral q exp(-g/s) dy / integral exp(-g/s) dy
//! ```
//!
//! with the softness s. Because d drop / d shift = <d g / d shift> holds exactly, the normal force
//! acts along the normal of the path that the wheel follows and does no spurious work.
//!
//! The curvature that Hertz needs comes from the same weights: a gap k t^2/2 over the arc length t,
//! measured along the normal, has the width Z = integral exp(-g/s) dt = sqrt(2 pi s/k), so
//! k = 2 pi s/Z^2 is the curvature of the parabola that comes as close over the same width. It is
//! always positive, and near a jump it counts both lobes.

use super::lobes::{Lobe, SOFTNESS, lobes, smooth};
use super::pair::ProfilePair;
use crate::hertz::UnitContact;
use crate::material::STEEL;
use crate::profile::point::ProfilePoint;
use crate::profile::rail_head::RailHead;
use std::f64::consts::TAU;

/// Approach in m of a loaded contact: that of a wheel under 110 kN. A contact so pressed covers both
/// points between which the least gap jumps, and its stiffness hardly changes there.
const LOADED: f64 = 100e-6;

/// Distance of the samples of both profiles, in m. It must resolve the weights on the flange, whose
/// standard deviation there is sqrt(s / g'') = 0.03 mm.
const SAMPLE_STEP: f64 = 1e-5;

/// Gaps that exceed the least by more than this many s have no weight worth counting.
const NEGLIGIBLE: f64 = 40.0;

/// Height above its neighbour from which a lobe gradually becomes a spring of its own, in m.
///
/// Whatever the barrier; from twice as much it is wholly one.
const FAR: f64 = 4.0 * SOFTNESS;

/// The rail ends where it gets steeper than this (80 degrees); no wheel is.
const STEEPEST: f64 = 5.67;

/// Wheel and rail as points, ready for a search.
pub(super) struct Search {
    pair: ProfilePair,
    /// Lateral coordinate from the running circle in m, and the profile there.
    wheel: Vec<(f64, ProfilePoint)>,
    /// Profile of the inclined rail at `rail_begin + i * SAMPLE_STEP`.
    rail: Vec<ProfilePoint>,
    rail_begin: f64,
    /// Lateral distance of the wheel's running circle from the rail's top at rest, in m.
    offset: f64,
    /// Gap at each wheel point; infinite beside the rail.
    gaps: Vec<f64>,
}

/// One contact of a wheel at one placement.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touch {
    /// Downward displacement at which the wheel first touches, in m.
    pub drop: f64,
    /// d drop / d shift.
    pub slope: f64,
    /// Descent of the contact with roll about the middle of the running circle, in m/rad.
    ///
    /// The shift stays that at the height of the rail's top.
    pub roll: f64,
    /// Lateral coordinate on the wheel from the running circle, in m.
    pub wheel_lateral: f64,
    /// Height of the wheel's profile there: the rolling radius above the nominal one, in m.
    pub wheel_height: f64,
    /// Lateral coordinate on the rail from its top, in m.
    pub rail_lateral: f64,
    /// Curvature of rail and wheel together across the contact, in 1/m.
    pub relative_curvature: f64,
    /// The same of the parabola with as much elastic energy under load, in 1/m.
    pub loaded_curvature: f64,
    /// Share of its own stiffness that the contact has beside its neighbours, 0 to 1 (`lobes.rs`).
    pub share: f64,
    /// Lateral coordinates on the wheel between which the contact lies, in m.
    pub range: (f64, f64),
}

impl Touch {
    /// Ellipse and stiffness, with its share, of the contact of a wheel of `nominal_radius` (m).
    pub(super) fn hertz(&self, nominal_radius: f64) -> UnitContact {
        self.of_curvature(self.relative_curvature, nominal_radius)
    }

    /// The same of the contact under load.
    pub(super) fn loaded_hertz(&self, nominal_radius: f64) -> UnitContact {
        self.of_curvature(self.loaded_curvature, nominal_radius)
    }

    fn of_curvature(&self, lateral: f64, nominal_radius: f64) -> UnitContact {
        let cos_angle = 1.0 / (1.0 + self.slope * self.slope).sqrt();
        let rolling = 0.5 * cos_angle / (nominal_radius + self.wheel_height);
        UnitContact::new(rolling, 0.5 * lateral, &STEEL).shared(self.share)
    }
}

impl Search {
    /// Samples both profiles.
    pub(super) fn new(pair: &ProfilePair) -> Self {
        let head = pair.rail.head().inclined(pair.rail_inclination);
        let (begin, end) = pair.wheel.range();
        let wheel: Vec<_> =
            steps(begin, end).map(|lateral| (lateral, pair.wheel.at(lateral))).collect();
        let (rail_begin, rail) = sampled(&head);
        Self {
            pair: pair.clone(),
            gaps: vec![0.0; wheel.len()],
            wheel,
            rail,
            rail_begin,
            offset: pair.running_circle() - pair.rail_top(),
        }
    }

    /// The contacts of a wheel shifted towards its flange by `shift` metres, without roll and yaw.
    ///
    /// From the flange to the field side; none if the wheel stands beside the rail.
    pub(super) fn shifted(&mut self, shift: f64) -> Vec<Touch> {
        let offset = self.offset + shift;
        self.touches(|lateral, point| (offset + lateral, point.height))
    }

    /// The contacts of one wheel of a displaced, rolled and yawed wheelset.
    ///
    /// Its centre is displaced by `outward` metres towards this wheel, rolled by `roll` rad so that this
    /// wheel comes lower, and yawed by `yaw` rad.
    ///
    /// Seen along the rail, the outline of a yawed wheel of radius R is that of its points turned
    /// by -yaw dR/dy about its axle: they lie -R dR/dy yaw² further to the field side and
    /// R (dR/dy)² yaw²/2 higher than those below the axle; and the whole axle, seen askew, is
    /// shorter by yaw²/2 of its length.
    pub(super) fn rolled(&mut self, outward: f64, roll: f64, yaw: f64) -> Vec<Touch> {
        let (sine, cosine) = libm::sincos(roll);
        let (arm, radius) = (self.pair.running_circle(), self.pair.nominal_radius);
        let offset = self.offset + outward;
        let turn = yaw * yaw;
        self.touches(|lateral, point| {
            let full = radius + point.height;
            let bend = turn * full * point.slope;
            let askew = (1.0 - 0.5 * turn) * (arm + lateral);
            let (y, z) = (askew - bend, full - 0.5 * bend * point.slope);
            (offset - arm + y * cosine - z * sine, y * sine + z * cosine - radius)
        })
    }

    /// The contacts of a wheel that `position` moves over its rail.
    ///
    /// It carries a point of the wheel's profile to its lateral distance from the rail's top and its
    /// height.
    fn touches(&mut self, position: impl Fn(f64, &ProfilePoint) -> (f64, f64)) -> Vec<Touch> {
        for (gap, (lateral, point)) in self.gaps.iter_mut().zip(&self.wheel) {
            let (y, z) = position(*lateral, point);
            *gap = rail_at(&self.rail, self.rail_begin, y).map_or(f64::INFINITY, |r| r.height - z);
        }
        let lobes = lobes(&self.gaps);
        let mut touches: Vec<Touch> = lobes.iter().map(|lobe| self.mean(lobe, &position)).collect();
        for i in 1..touches.len() {
            let separation = lobes[i].separation;
            let above = touches[i].drop - touches[i - 1].drop;
            // Z/(Z + Z') from the drops, which are -s ln Z; a lobe far above its neighbour takes no part of
            // what that one bears, and is a spring of its own.
            let ratio = libm::exp(above / SOFTNESS);
            let own = |above: f64| separation.max(smooth((above - FAR) / FAR));
            let [here, before] = [own(above), own(-above)];
            touches[i].share *= here + (1.0 - here) / (1.0 + ratio);
            touches[i - 1].share *= before + (1.0 - before) / (1.0 + 1.0 / ratio);
        }
        touches
    }

    /// Means over a lobe.
    fn mean(&self, lobe: &Lobe, position: &impl Fn(f64, &ProfilePoint) -> (f64, f64)) -> Touch {
        let (mut sum, mut width) = (0.0, 0.0);
        let mut mean = Touch {
            drop: lobe.least,
            slope: 0.0,
            roll: 0.0,
            wheel_lateral: 0.0,
            wheel_height: 0.0,
            rail_lateral: 0.0,
            relative_curvature: 0.0,
            loaded_curvature: 0.0,
            share: 1.0,
            range: (self.wheel[lobe.begin].0, self.wheel[lobe.end - 1].0),
        };
        let samples = lobe.begin..lobe.end;
        for (gap, (lateral, point)) in self.gaps[samples.clone()].iter().zip(&self.wheel[samples]) {
            let excess = (gap - lobe.least) / SOFTNESS;
            if excess > NEGLIGIBLE {
                continue;
            }
            let (y, _) = position(*lateral, point);
            let Some(rail) = rail_at(&self.rail, self.rail_begin, y) else {
                continue;
            };
            let weight = libm::exp(-excess);
            sum += weight;
            mean.slope += weight * rail.slope;
            mean.roll += weight * (lateral + point.height * rail.slope);
            mean.wheel_lateral += weight * lateral;
            mean.wheel_height += weight * point.height;
            mean.rail_lateral += weight * y;
            let stretch = (1.0 + rail.slope * rail.slope).sqrt();
            width += stretch * libm::exp(-excess / stretch);
        }
        mean.drop -= SOFTNESS * libm::log(sum * SAMPLE_STEP);
        mean.slope /= sum;
        mean.roll /= sum;
        mean.wheel_lateral /= sum;
        mean.wheel_height /= sum;
        mean.rail_lateral /= sum;
        width *= SAMPLE_STEP;
        mean.relative_curvature = TAU * SOFTNESS / (width * width);
        mean.loaded_curvature = self.loaded_curvature(lobe, mean.slope, position);
        mean
    }

    /// Curvature of the parabola of the gap along the normal that stores as much energy as the lobe when
    /// it is pressed to [`LOADED`]: in strips across the axle energy goes with the square of the overlap,
    /// and for the gap B t² it is (16/15) approach^(5/2)/sqrt(B), as in Hertz's contact.
    fn loaded_curvature(
        &self,
        lobe: &Lobe,
        slope: f64,
        position: &impl Fn(f64, &ProfilePoint) -> (f64, f64),
    ) -> f64 {
        let depth = LOADED * (1.0 + slope * slope).sqrt();
        let samples = lobe.begin..lobe.end;
        let mut energy = 0.0;
        for (gap, (lateral, point)) in self.gaps[samples.clone()].iter().zip(&self.wheel[samples]) {
            let overlap = depth - (gap - lobe.least);
            if overlap <= 0.0 {
                continue;
            }
            let (y, _) = position(*lateral, point);
            if let Some(rail) = rail_at(&self.rail, self.rail_begin, y) {
                energy += overlap * overlap / (1.0 + rail.slope * rail.slope).sqrt();
            }
        }
        let root = 16.0 / 15.0 * libm::pow(LOADED, 2.5) / (energy * SAMPLE_STEP);
        2.0 * root * root
    }
}

/// Coordinates from `begin` to `end` in steps of [`SAMPLE_STEP`].
fn steps(begin: f64, end: f64) -> impl Iterator<Item = f64> {
    let count = ((end - begin) / SAMPLE_STEP) as usize;
    (0..=count).map(move |i| begin + i as f64 * SAMPLE_STEP)
}

/// The part of a rail head that a wheel can touch: its first coordinate and its points.
fn sampled(head: &RailHead) -> (f64, Vec<ProfilePoint>) {
    let (begin, end) = head.range();
    let points: Vec<_> = steps(begin, end)
        .map(|y| (y, head.at(y)))
        .filter(|(_, point)| point.slope.abs() < STEEPEST)
        .collect();
    let first = points.first().map_or(0.0, |(y, _)| *y);
    (first, points.into_iter().map(|(_, point)| point).collect())
}

/// The rail at `y`: its slope is linear between the points and its height the integral of that, so
/// that both belong together; nothing beside the rail.
fn rail_at(rail: &[ProfilePoint], begin: f64, y: f64) -> Option<ProfilePoint> {
    let position = (y - begin) / SAMPLE_STEP;
    if position < 0.0 {
        return None;
    }
    let i = position as usize;
    let (before, after) = (rail.get(i)?, rail.get(i + 1)?);
    let share = position - i as f64;
    let bend = share * (after.slope - before.slope);
    Some(ProfilePoint {
        height: before.height + SAMPLE_STEP * share * (before.slope + 0.5 * bend),
        slope: before.slope + bend,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::{rail::RailProfile, wheel::WheelProfile};

    /// Drop and slope come from different sums; the smooth minimum makes one the derivative of the
    /// other, also in the middle of a jump between two contacts. Tolerance 1e-5: the central
    /// difference over 0.2 um leaves 3e-6 where tread and flange face share the load. Where there
    /// are two lobes, the barrier between them moves with the shift; it cuts off weights of at most
    /// exp(-1) that hardly count by their share, and of exp(-4) once the share is full: 2e-2.
    #[test]
    fn property_search_finds_the_slope_of_its_own_path() {
        let pair = ProfilePair::standard_gauge(
            WheelProfile::S1002,
            RailProfile::Rail60E1,
            1.0 / 40.0,
            0.46,
        );
        let mut search = Search::new(&pair);
        let step = 1e-7;
        for i in -100..200 {
            let shift = f64::from(i) * 5e-5;
            let mut at = |shift| search.shifted(shift);
            let (before, here, after) = (at(shift - step), at(shift), at(shift + step));
            let contacts = here.len();
            for ((before, here), after) in before.iter().zip(&here).zip(&after) {
                let chord = (after.drop - before.drop) / (2.0 * step);
                let tolerance = if contacts > 1 { 2e-2 / here.share } else { 1e-5 };
                assert!(
                    (here.slope - chord).abs() < tolerance,
                    "{chord} instead of {} at {shift}",
                    here.slope
                );
            }
        }
    }
}
