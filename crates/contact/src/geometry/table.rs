//! Contacts of one wheel over its lateral shift, interpolated.

use super::contact_point::ContactPoint;
use super::pair::ProfilePair;
use super::search::{Search, Touch};
use super::{shared, slots};
use crate::hertz::UnitContact;
use crate::kalker::CreepCoefficients;
use crate::{ContactError, STEEL};
use std::sync::Arc;

/// Distance of the rows, in m.
const STEP: f64 = 5e-5;

/// Rows towards the field side: the table begins at a shift of -20 mm, or where the wheel leaves the
/// rail.
const ROWS_AWAY: i32 = 400;

/// Rows towards the flange: up to a shift of 30 mm, where the flange has climbed by 23 mm, or where
/// the wheel leaves the rail.
const ROWS_TOWARDS: i32 = 600;

/// Number of linearly interpolated values in a row.
const LINEAR: usize = 11;

/// One row of a patch.
#[derive(Clone, Copy, Debug)]
struct Row {
    drop: f64,
    slope: f64,
    /// Derivatives of the two above by the square of the yaw.
    yaw: (f64, f64),
    /// In the order in which [`PatchAt`] takes them out.
    linear: [f64; LINEAR],
}

/// Where the stiffness stands in [`Row::linear`].
const STIFFNESS: usize = 5;

/// Contacts of one wheel with its rail as a function of the lateral shift and of the yaw.
///
/// The shift is the lateral displacement of the wheel relative to its rail at the height of the
/// contact, in m, positive when the flange approaches the rail; 0 is the wheelset in the middle of
/// the track. A wheelset displaced by y to the right and rolled by phi (right side down) shifts its
/// right wheel by y - r phi and its left wheel by -(y - r phi).
///
/// A wheel may touch at up to [`Self::MOST_PATCHES`] patches at once. Each is a spring of its own;
/// they share the load as their approaches say.
///
/// `drop` is a cubic through values and slopes, so that its derivative is continuous and equals the
/// `slope` given; all else is linear between the rows. Yaw changes `drop` and `slope` by its square
/// (`search.rs`).
#[derive(Debug)]
pub struct GeometryTable {
    pair: ProfilePair,
    begin: f64,
    /// Number of rows.
    count: usize,
    patches: Vec<Vec<Row>>,
}

impl GeometryTable {
    /// Most patches of a wheel.
    pub const MOST_PATCHES: usize = slots::MOST_PATCHES;

    /// The table of this pair, made at the first call and shared by all later ones in the process.
    ///
    /// # Errors
    /// When a dimension is out of range or the wheel does not stand on the rail.
    pub fn shared(pair: &ProfilePair) -> Result<Arc<Self>, ContactError> {
        shared::table(pair)
    }

    /// Searches the contacts at every row.
    pub(super) fn new(pair: &ProfilePair) -> Result<Self, ContactError> {
        pair.check()?;
        let mut search = Search::new(pair);
        let mut touches = |i: i32| search.shifted(f64::from(i) * STEP);
        let centred = touches(0);
        let level = centred.iter().map(|touch| touch.drop).fold(f64::INFINITY, f64::min);
        if !level.is_finite() {
            return Err(ContactError::NoContact {
                wheel: pair.wheel.name(),
                rail: pair.rail.name(),
                shift_mm: 0.0,
            });
        }
        let on_rail = |touches: &Vec<Touch>| !touches.is_empty();
        let away = (1..=ROWS_AWAY).map(|i| touches(-i)).take_while(on_rail);
        let mut rows: Vec<_> = away.collect();
        let before = rows.len();
        rows.reverse();
        rows.push(centred);
        rows.extend((1..=ROWS_TOWARDS).map(touches).take_while(on_rail));
        let tracks = slots::follow(&rows, STEP);
        let patches = tracks.iter().map(|track| patch_rows(pair, track, level)).collect();
        let begin = -(before as f64) * STEP;
        Ok(Self { pair: pair.clone(), begin, count: rows.len(), patches })
    }

    /// The pair this table was made for.
    pub fn pair(&self) -> &ProfilePair {
        &self.pair
    }

    /// Least and greatest shift of the table, in m.
    pub fn range(&self) -> (f64, f64) {
        (self.begin, self.begin + (self.count - 1) as f64 * STEP)
    }

    /// Number of patches that the pair has at any shift, at most [`Self::MOST_PATCHES`].
    pub fn patches(&self) -> usize {
        self.patches.len()
    }

    /// The contact that touches first at a lateral `shift` in m, without yaw. A shift that is not a
    /// number gives the first row.
    pub fn at(&self, shift: f64) -> ContactPoint {
        let row = self.row(shift);
        let patches = (0..self.patches()).filter_map(|patch| self.patch(patch, row, 0.0));
        let first = patches.reduce(|a, b| if b.drop < a.drop { b } else { a });
        // Every row has a contact, but two rows between which one ends and another begins may not.
        first.unwrap_or_else(|| PatchAt::new(&self.patches[0], row, 0.0)).point()
    }

    /// A patch, counted from 0, at a place of [`Self::row`] and the square of the yaw in rad; nothing
    /// where the pair has no such patch.
    #[inline]
    pub fn patch(&self, patch: usize, row: RowPlace, yaw_squared: f64) -> Option<PatchAt<'_>> {
        let patch = PatchAt::new(&self.patches[patch], row, yaw_squared);
        let [p, q] = patch.rows;
        (p.linear[STIFFNESS] + q.linear[STIFFNESS] > 0.0).then_some(patch)
    }

    /// The place of a lateral `shift` in m among the rows.
    #[inline]
    pub fn row(&self, shift: f64) -> RowPlace {
        let place = (shift - self.begin) * (1.0 / STEP);
        let inside = place.max(0.0).min((self.count - 1) as f64);
        let index = (inside as usize).min(self.count.saturating_sub(2));
        RowPlace { index, part: inside - index as f64, beyond: place != inside }
    }
}

/// A shift between two rows of a table.
#[derive(Clone, Copy, Debug)]
pub struct RowPlace {
    index: usize,
    /// Part of the way to the next row.
    part: f64,
    /// The shift lies outside the table.
    beyond: bool,
}

/// A patch of a table at one shift and yaw; what is not asked for is not interpolated.
#[derive(Clone, Copy, Debug)]
pub struct PatchAt<'a> {
    rows: [&'a Row; 2],
    place: RowPlace,
    /// As [`ContactPoint::drop`].
    pub drop: f64,
    /// As [`ContactPoint::slope`].
    pub slope: f64,
}

impl<'a> PatchAt<'a> {
    #[inline]
    fn new(rows: &'a [Row], place: RowPlace, yaw_squared: f64) -> Self {
        let rows = [&rows[place.index], &rows[place.index + 1]];
        let [p, q] = rows.map(|row| row.yawed(yaw_squared));
        let (drop, slope) = cubic(p, q, place.part);
        Self { rows, place, drop, slope }
    }

    /// As [`ContactPoint::radius_change`].
    #[inline]
    pub fn radius_change(&self) -> f64 {
        self.linear(0)
    }

    /// As [`ContactPoint::wheel_lateral`].
    #[inline]
    pub fn wheel_lateral(&self) -> f64 {
        self.linear(1)
    }

    /// As [`ContactPoint::rail_lateral`].
    #[inline]
    pub fn rail_lateral(&self) -> f64 {
        self.linear(2)
    }

    /// As [`ContactPoint::beyond`].
    #[inline]
    pub fn beyond(&self) -> bool {
        self.place.beyond
    }

    /// All that is known of the contact.
    #[inline]
    pub fn point(&self) -> ContactPoint {
        let v: [f64; LINEAR] = std::array::from_fn(|k| self.linear(k));
        let cos_angle = 1.0 / (1.0 + self.slope * self.slope).sqrt();
        ContactPoint {
            drop: self.drop,
            slope: self.slope,
            sin_angle: -self.slope * cos_angle,
            cos_angle,
            radius_change: v[0],
            wheel_lateral: v[1],
            rail_lateral: v[2],
            hertz: UnitContact {
                semi_axis_rolling: v[3],
                semi_axis_lateral: v[4],
                stiffness: v[STIFFNESS],
                stiffness_root: v[6],
            },
            kalker: CreepCoefficients { c11: v[7], c22: v[8], c23: v[9], c33: v[10] },
            beyond: self.place.beyond,
        }
    }

    #[inline]
    fn linear(&self, k: usize) -> f64 {
        let [p, q] = self.rows;
        p.linear[k] + self.place.part * (q.linear[k] - p.linear[k])
    }
}

impl Row {
    /// Drop and slope of a yawed wheel.
    #[inline]
    fn yawed(&self, yaw_squared: f64) -> (f64, f64) {
        (self.drop + yaw_squared * self.yaw.0, self.slope + yaw_squared * self.yaw.1)
    }
}

/// The rows of one patch; `level` is the drop at shift 0.
fn patch_rows(pair: &ProfilePair, track: &[Touch], level: f64) -> Vec<Row> {
    let mut rows: Vec<Row> = track.iter().map(|touch| row(pair, touch, level)).collect();
    for i in 1..track.len().saturating_sub(1) {
        rows[i].yaw.1 = (track[i + 1].yaw - track[i - 1].yaw) / (2.0 * STEP);
    }
    rows
}

/// The row of one contact, but for the change of its slope with yaw.
fn row(pair: &ProfilePair, touch: &Touch, level: f64) -> Row {
    let hertz = touch.hertz(pair.nominal_radius);
    let a_over_b = hertz.semi_axis_rolling / hertz.semi_axis_lateral;
    let kalker = CreepCoefficients::new(a_over_b, STEEL.poisson_ratio);
    Row {
        drop: touch.drop - level,
        slope: touch.slope,
        yaw: (touch.yaw, 0.0),
        linear: [
            touch.wheel_height,
            touch.wheel_lateral,
            touch.rail_lateral,
            hertz.semi_axis_rolling,
            hertz.semi_axis_lateral,
            hertz.stiffness,
            hertz.stiffness_root,
            kalker.c11,
            kalker.c22,
            kalker.c23,
            kalker.c33,
        ],
    }
}

/// Drop and its derivative between two rows with these drops and slopes, `t` of the way, by
/// Hermite's cubic.
#[inline]
fn cubic(p: (f64, f64), q: (f64, f64), t: f64) -> (f64, f64) {
    let rise = q.0 - p.0;
    let (begin, end) = (STEP * p.1, STEP * q.1);
    let c2 = 3.0 * rise - 2.0 * begin - end;
    let c3 = begin + end - 2.0 * rise;
    let drop = p.0 + t * (begin + t * (c2 + t * c3));
    let slope = (begin + t * (2.0 * c2 + t * 3.0 * c3)) * (1.0 / STEP);
    (drop, slope)
}
