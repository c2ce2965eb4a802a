//! One contact at one lateral shift as the table keeps it, and what lies between two such rows.

use super::pair::ProfilePair;
use super::search::Touch;
use crate::STEEL;
use crate::kalker::CreepCoefficients;

/// Distance of the rows, in m.
pub(super) const STEP: f64 = 5e-5;

/// Number of linearly interpolated values in a row.
pub(super) const LINEAR: usize = 11;

/// Rows on either side among which a loaded contact may lie: 0.2 mm of shift.
const WITHIN: usize = 4;

/// A value and its derivative by the shift.
pub(super) type Node = (f64, f64);

/// One row of a patch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    /// Drop; its derivative is the slope.
    drop: Node,
    /// Derivative of the drop by the roll that lowers this wheel, negative and without the distance of the
    /// running circle from the middle, in m.
    pub roll: Node,
    /// Stiffness of Hertz's contact with its share, light and loaded, in N/m^(3/2).
    pub stiffness: [Node; 2],
    /// In the order in which [`super::patch_at::PatchAt`] takes them out.
    pub linear: [f64; LINEAR],
    /// There is a contact here or close by.
    pub near: bool,
}

impl Row {
    /// Drop and slope of a rolled wheel.
    #[inline]
    pub fn drop(&self, roll: f64) -> Node {
        (self.drop.0 - roll * self.roll.0, self.drop.1 - roll * self.roll.1)
    }
}

/// Hermite's cubic between two rows, in powers of the part of the way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cubic([f64; 4]);

impl Cubic {
    #[inline]
    pub fn new(p: Node, q: Node) -> Self {
        let rise = q.0 - p.0;
        let (begin, end) = (STEP * p.1, STEP * q.1);
        Self([p.0, begin, 3.0 * rise - 2.0 * begin - end, begin + end - 2.0 * rise])
    }

    /// Value and first derivative by the shift.
    #[inline]
    pub fn at(&self, t: f64) -> Node {
        let Self([c0, c1, c2, c3]) = self;
        let value = c0 + t * (c1 + t * (c2 + t * c3));
        (value, (c1 + t * (2.0 * c2 + t * 3.0 * c3)) * (1.0 / STEP))
    }

    /// Second derivative by the shift.
    #[inline]
    pub fn bend(&self, t: f64) -> f64 {
        (2.0 * self.0[2] + t * 6.0 * self.0[3]) * (1.0 / (STEP * STEP))
    }
}

/// What yaw does to the path (`docs/theory/vehicle/contact-geometry.md`), in m.
#[derive(Clone, Copy, Debug)]
pub(super) struct YawArms {
    /// Radius of the wheel.
    pub radius: f64,
    /// Half the distance of the contact from the middle of the axle.
    pub half: f64,
}

/// A patch of the table.
#[derive(Debug)]
pub(super) struct TablePatch {
    pub rows: Vec<Row>,
    pub yaw: YawArms,
}

impl TablePatch {
    /// The patch of this track; `level` is the drop at shift 0.
    pub fn new(pair: &ProfilePair, track: &[Touch], level: f64) -> Self {
        Self { rows: rows(pair, track, level), yaw: YawArms::new(pair, track) }
    }
}

impl YawArms {
    /// Means over the contacts, by the square of their slopes: yaw hardly moves a flat contact.
    fn new(pair: &ProfilePair, track: &[Touch]) -> Self {
        let (mut sum, mut lateral, mut height) = (0.0, 0.0, 0.0);
        for touch in track.iter().filter(|touch| touch.share > 0.0) {
            let weight = touch.slope * touch.slope;
            sum += weight;
            lateral += weight * touch.wheel_lateral;
            height += weight * touch.wheel_height;
        }
        Self {
            radius: pair.nominal_radius + height / sum.max(f64::MIN_POSITIVE),
            half: 0.5 * (pair.running_circle() + lateral / sum.max(f64::MIN_POSITIVE)),
        }
    }
}

/// The rows of one patch.
fn rows(pair: &ProfilePair, track: &[Touch], level: f64) -> Vec<Row> {
    let mut rows: Vec<Row> = track.iter().map(|touch| row(pair, touch, level)).collect();
    for i in 1..track.len().saturating_sub(1) {
        let central =
            |value: fn(&Touch) -> f64| (value(&track[i + 1]) - value(&track[i - 1])) / (2.0 * STEP);
        rows[i].roll.1 = central(|touch| touch.roll);
        for load in [0, 1] {
            let stiffness = [i - 1, i, i + 1].map(|k| rows[k].stiffness[load].0);
            rows[i].stiffness[load].1 = monotone(stiffness);
        }
    }
    let exists: Vec<bool> = rows.iter().map(|row| row.stiffness[0].0 > 0.0).collect();
    for (i, row) in rows.iter_mut().enumerate() {
        let last = (i + WITHIN).min(exists.len() - 1);
        row.near = exists[i.saturating_sub(WITHIN)..=last].contains(&true);
    }
    rows
}

/// Derivative at the middle of three values with which a cubic stays between them (Fritsch and
/// Butland 1984: harmonic mean of both differences).
fn monotone([before, here, after]: [f64; 3]) -> f64 {
    let (left, right) = (here - before, after - here);
    if left * right > 0.0 { 2.0 * left * right / ((left + right) * STEP) } else { 0.0 }
}

/// The row of one contact, without the derivatives that take its neighbours.
fn row(pair: &ProfilePair, touch: &Touch, level: f64) -> Row {
    let hertz = touch.hertz(pair.nominal_radius);
    let loaded = touch.loaded_hertz(pair.nominal_radius);
    let a_over_b = hertz.semi_axis_rolling / hertz.semi_axis_lateral;
    let kalker = CreepCoefficients::new(a_over_b, STEEL.poisson_ratio);
    Row {
        drop: (touch.drop - level, touch.slope),
        roll: (touch.roll, 0.0),
        stiffness: [(hertz.stiffness, 0.0), (loaded.stiffness, 0.0)],
        linear: [
            touch.wheel_height,
            touch.wheel_lateral,
            touch.rail_lateral,
            hertz.semi_axis_rolling,
            hertz.semi_axis_lateral,
            hertz.stiffness_root,
            loaded.stiffness_root,
            kalker.c11,
            kalker.c22,
            kalker.c23,
            kalker.c33,
        ],
        near: false,
    }
}
