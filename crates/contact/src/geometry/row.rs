//! One contact at one lateral shift as the table keeps it, and what lies between two such rows.

use super::pair::ProfilePair;
use super::search::Touch;
use crate::hertz::UnitContact;
use crate::kalker::CreepCoefficients;
use crate::material::STEEL;

/// Distance of the rows, in m.
pub(super) const STEP: f64 = 5e-5;

/// Number of linearly interpolated values in a row.
pub(super) const LINEAR: usize = 11;

/// Rows on either side among which a loaded contact may lie: 0.2 mm of shift.
const WITHIN: usize = 4;

/// A value and its derivative by the shift.
pub(super) type Node = (f64, f64);

/// One row of a patch, and the curves to the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    /// Drop; its derivative is the slope.
    drop: Cubic,
    /// Descent of the contact with roll about the middle of the running circle, in m/rad.
    pub roll: Cubic,
    /// Stiffness of Hertz's contact with its share, light and loaded, in N/m^(3/2).
    pub stiffness: [Cubic; 2],
    /// In the order in which [`super::patch_at::PatchAt`] takes them out.
    pub linear: [f64; LINEAR],
    /// There is a contact here or close by.
    pub near: bool,
}

impl Row {
    /// The path of a rolled wheel to the next row.
    #[inline]
    pub fn path(&self, roll: f64) -> Cubic {
        Cubic(std::array::from_fn(|k| self.drop.0[k] - roll * self.roll.0[k]))
    }
}

/// Hermite's cubic between two rows, in powers of the share of the distance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cubic([f64; 4]);

impl Cubic {
    /// The cubic with these values and derivatives at both ends.
    fn new(p: Node, q: Node) -> Self {
        let rise = q.0 - p.0;
        let (begin, end) = (STEP * p.1, STEP * q.1);
        Self([p.0, begin, 3.0 * rise - 2.0 * begin - end, begin + end - 2.0 * rise])
    }

    /// Value at the share `t` of the distance.
    #[inline]
    pub fn value(&self, t: f64) -> f64 {
        let Self([c0, c1, c2, c3]) = self;
        c0 + t * (c1 + t * (c2 + t * c3))
    }

    /// Value and derivative by the shift.
    #[inline]
    pub fn at(&self, t: f64) -> Node {
        let Self([_, c1, c2, c3]) = self;
        (self.value(t), (c1 + t * (2.0 * c2 + t * 3.0 * c3)) * (1.0 / STEP))
    }

    /// Second and third derivative by the shift.
    #[inline]
    pub fn bends(&self, t: f64) -> [f64; 2] {
        let [_, _, c2, c3] = self.0;
        let scale = 1.0 / (STEP * STEP);
        [(2.0 * c2 + t * 6.0 * c3) * scale, 6.0 * c3 * (scale / STEP)]
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
    let light: Vec<_> = track.iter().map(|touch| touch.hertz(pair.nominal_radius)).collect();
    let loaded: Vec<_> =
        track.iter().map(|touch| touch.loaded_hertz(pair.nominal_radius)).collect();
    let drop: Vec<Node> = track.iter().map(|touch| (touch.drop - level, touch.slope)).collect();
    let roll = nodes(track.iter().map(|touch| touch.roll), central);
    let stiffness = [&light, &loaded]
        .map(|contacts| nodes(contacts.iter().map(|contact| contact.stiffness), monotone));
    let row = |i: usize| {
        // The last row leads to no other.
        let next = (i + 1).min(track.len() - 1);
        let cubic = |nodes: &[Node]| Cubic::new(nodes[i], nodes[next]);
        let (first, last) = (i.saturating_sub(WITHIN), (i + WITHIN).min(track.len() - 1));
        Row {
            drop: cubic(&drop),
            roll: cubic(&roll),
            stiffness: stiffness.each_ref().map(|nodes| cubic(nodes)),
            linear: linear(&track[i], &light[i], loaded[i].stiffness_root),
            near: track[first..=last].iter().any(|touch| touch.share > 0.0),
        }
    };
    (0..track.len()).map(row).collect()
}

/// Values with derivatives that a `rule` makes of each and its neighbours; none at both ends.
fn nodes(values: impl Iterator<Item = f64>, rule: fn([f64; 3]) -> f64) -> Vec<Node> {
    let values: Vec<f64> = values.collect();
    let mut nodes: Vec<Node> = values.iter().map(|value| (*value, 0.0)).collect();
    for (i, three) in values.windows(3).enumerate() {
        nodes[i + 1].1 = rule([three[0], three[1], three[2]]);
    }
    nodes
}

/// Derivative at the middle of three values by the outer ones.
fn central([before, _, after]: [f64; 3]) -> f64 {
    (after - before) / (2.0 * STEP)
}

/// Derivative at the middle of three values with which a cubic stays between them.
///
/// The harmonic mean of both differences (Fritsch and Butland 1984).
fn monotone([before, here, after]: [f64; 3]) -> f64 {
    let (left, right) = (here - before, after - here);
    if left * right > 0.0 { 2.0 * left * right / ((left + right) * STEP) } else { 0.0 }
}

/// The values of a row between which the table is linear.
fn linear(touch: &Touch, light: &UnitContact, loaded_root: f64) -> [f64; LINEAR] {
    let a_over_b = light.semi_axis_rolling / light.semi_axis_lateral;
    let kalker = CreepCoefficients::new(a_over_b, STEEL.poisson_ratio);
    [
        touch.wheel_height,
        touch.wheel_lateral,
        touch.rail_lateral,
        light.semi_axis_rolling,
        light.semi_axis_lateral,
        light.stiffness_root,
        loaded_root,
        kalker.c11,
        kalker.c22,
        kalker.c23,
        kalker.c33,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cubic with the values and slopes of x³ at both ends of a row is x³ between them.
    #[test]
    fn analytic_a_cubic_is_met_exactly() {
        let (p, q) = (2.0 * STEP, 3.0 * STEP);
        let cubic = Cubic::new((p.powi(3), 3.0 * p * p), (q.powi(3), 3.0 * q * q));
        for t in [0.0, 0.3, 0.5, 1.0] {
            let x = p + t * STEP;
            let (value, slope) = cubic.at(t);
            assert!((value / x.powi(3) - 1.0).abs() < 1e-12);
            assert!((slope / (3.0 * x * x) - 1.0).abs() < 1e-12);
            let [second, third] = cubic.bends(t);
            assert!((second / (6.0 * x) - 1.0).abs() < 1e-9 && (third / 6.0 - 1.0).abs() < 1e-9);
        }
    }

    /// With slopes by Fritsch and Butland the curve through a step stays between its values.
    #[test]
    fn property_monotone_values_stay_monotone() {
        let values = [0.0, 0.0, 1.0, 1.2, 1.2, 0.4];
        let nodes = nodes(values.into_iter(), monotone);
        for pair in nodes.windows(2) {
            let cubic = Cubic::new(pair[0], pair[1]);
            let (low, high) = (pair[0].0.min(pair[1].0), pair[0].0.max(pair[1].0));
            for i in 0..=20 {
                let value = cubic.value(f64::from(i) / 20.0);
                assert!((low - 1e-12..=high + 1e-12).contains(&value), "{value} in {pair:?}");
            }
        }
    }
}
