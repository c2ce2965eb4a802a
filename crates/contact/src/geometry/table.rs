//! Contacts of one wheel over its lateral shift, interpolated.

use super::contact_point::ContactPoint;
use super::pair::ProfilePair;
use super::search::{Search, Touch};
use super::shared;
use crate::hertz::UnitContact;
use crate::kalker::CreepCoefficients;
use crate::{ContactError, STEEL};
use std::sync::Arc;

/// Distance of the rows, in m.
const STEP: f64 = 5e-5;

/// Rows towards the field side: the table begins at a shift of -20 mm.
const ROWS_AWAY: i32 = 400;

/// Rows towards the flange: up to a shift of 30 mm, where the flange has climbed by 23 mm.
const ROWS_TOWARDS: i32 = 600;

/// Number of linearly interpolated values in a row.
const LINEAR: usize = 10;

/// One row of the table.
#[derive(Clone, Copy, Debug)]
struct Row {
    drop: f64,
    slope: f64,
    /// In the order in which [`GeometryTable::at`] takes them out.
    linear: [f64; LINEAR],
}

/// Contact of one wheel with its rail as a function of the lateral shift.
///
/// The shift is the lateral displacement of the wheel relative to its rail at the height of the
/// contact, in m, positive when the flange approaches the rail; 0 is the wheelset in the middle of
/// the track. A wheelset displaced by y to the right and rolled by phi (right side down) shifts its
/// right wheel by y - r phi and its left wheel by -(y - r phi).
///
/// `drop` is a cubic through values and slopes, so that its derivative is continuous and equals the
/// `slope` given; all else is linear between the rows.
#[derive(Debug)]
pub struct GeometryTable {
    pair: ProfilePair,
    begin: f64,
    rows: Vec<Row>,
}

impl GeometryTable {
    /// The table of this pair, made at the first call and shared by all later ones in the process.
    ///
    /// # Errors
    /// When a dimension is out of range or the wheel does not stand on the rail.
    pub fn shared(pair: &ProfilePair) -> Result<Arc<Self>, ContactError> {
        shared::table(pair)
    }

    /// Searches the contact at every row.
    pub(super) fn new(pair: &ProfilePair) -> Result<Self, ContactError> {
        pair.check()?;
        let mut search = Search::new(pair);
        let mut touch = |i: i32| {
            let shift = f64::from(i) * STEP;
            search.shifted(shift).ok_or_else(|| ContactError::NoContact {
                wheel: pair.wheel.name(),
                rail: pair.rail.name().into(),
                shift_mm: 1e3 * shift,
            })
        };
        let level = touch(0)?.drop;
        let mut rows = Vec::with_capacity((ROWS_AWAY + ROWS_TOWARDS + 1) as usize);
        for i in -ROWS_AWAY..=ROWS_TOWARDS {
            rows.push(row(pair, &touch(i)?, level));
        }
        Ok(Self { pair: *pair, begin: -f64::from(ROWS_AWAY) * STEP, rows })
    }

    /// The pair this table was made for.
    pub fn pair(&self) -> &ProfilePair {
        &self.pair
    }

    /// Least and greatest shift of the table, in m.
    pub fn range(&self) -> (f64, f64) {
        (self.begin, self.begin + (self.rows.len() - 1) as f64 * STEP)
    }

    /// The contact at a lateral `shift` in m. A shift that is not a number gives the first row.
    pub fn at(&self, shift: f64) -> ContactPoint {
        let last = (self.rows.len() - 1) as f64;
        let place = (shift - self.begin) / STEP;
        let inside = place.max(0.0).min(last);
        let i = (inside as usize).min(self.rows.len() - 2);
        let t = inside - i as f64;
        let (p, q) = (&self.rows[i], &self.rows[i + 1]);
        let (drop, slope) = cubic(p, q, t);
        let v: [f64; LINEAR] =
            std::array::from_fn(|k| p.linear[k] + t * (q.linear[k] - p.linear[k]));
        let cos_angle = 1.0 / (1.0 + slope * slope).sqrt();
        ContactPoint {
            drop,
            slope,
            sin_angle: -slope * cos_angle,
            cos_angle,
            radius_change: v[0],
            wheel_lateral: v[1],
            rail_lateral: v[2],
            hertz: UnitContact {
                semi_axis_rolling: v[3],
                semi_axis_lateral: v[4],
                stiffness: v[5],
            },
            kalker: CreepCoefficients { c11: v[6], c22: v[7], c23: v[8], c33: v[9] },
            beyond: place != inside,
        }
    }
}

/// The row of one contact; `level` is the drop at shift 0.
fn row(pair: &ProfilePair, touch: &Touch, level: f64) -> Row {
    let cos_angle = 1.0 / (1.0 + touch.slope * touch.slope).sqrt();
    let rolling = 0.5 * cos_angle / (pair.nominal_radius + touch.wheel_height);
    let lateral = 0.5 * touch.relative_curvature;
    let hertz = UnitContact::new(rolling, lateral, &STEEL);
    let a_over_b = hertz.semi_axis_rolling / hertz.semi_axis_lateral;
    let kalker = CreepCoefficients::new(a_over_b, STEEL.poisson_ratio);
    Row {
        drop: touch.drop - level,
        slope: touch.slope,
        linear: [
            touch.wheel_height,
            touch.wheel_lateral,
            touch.rail_lateral,
            hertz.semi_axis_rolling,
            hertz.semi_axis_lateral,
            hertz.stiffness,
            kalker.c11,
            kalker.c22,
            kalker.c23,
            kalker.c33,
        ],
    }
}

/// Drop and its derivative between two rows, `t` of the way, by Hermite's cubic.
fn cubic(p: &Row, q: &Row, t: f64) -> (f64, f64) {
    let rise = q.drop - p.drop;
    let (begin, end) = (STEP * p.slope, STEP * q.slope);
    let c2 = 3.0 * rise - 2.0 * begin - end;
    let c3 = begin + end - 2.0 * rise;
    let drop = p.drop + t * (begin + t * (c2 + t * c3));
    let slope = (begin + t * (2.0 * c2 + t * 3.0 * c3)) / STEP;
    (drop, slope)
}
