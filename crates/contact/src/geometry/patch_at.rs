//! A patch of the table under a wheel: where it would touch, and where it presses.
//!
//! Unloaded, a wheel moves on the path drop(shift). Pressed beyond it, it touches where it is nearest
//! to the path: at the foot of the perpendicular, whose length is the elastic approach. So the energy
//!
//! ```text
//! U = 2/5 k(foot) approach^(5/2)
//! ```
//!
//! is a function of the wheel's place alone and its gradient is the force: N = k approach^(3/2) along
//! the perpendicular, as the derivative of the distance to a curve is the unit normal at the foot, and
//! where the stiffness changes along the path a small force along it, 2/5 dk/dfoot approach^(5/2).

use super::contact_point::ContactPoint;
use super::row::{Cubic, LINEAR, Node, Row, STEP, TablePatch, YawArms};
use crate::hertz::UnitContact;
use crate::kalker::CreepCoefficients;

/// After a step as short as this, in m of shift, the foot is exact: the error falls with the square.
const LAST_STEP: f64 = 2e-6;

/// Steps of the search, far more than any contact takes (two on the tread).
const MOST_STEPS: usize = 30;

/// Approach from which a contact counts as loaded, in m: that of a wheel under 40 kN.
const LOADED_FROM: f64 = 50e-6;

/// A wheel that is further above its path does not touch it, whatever its yaw, in m.
const REACH: f64 = 5e-4;

/// Where a wheel is over its rail.
#[derive(Clone, Copy, Debug, Default)]
pub struct WheelPlace {
    /// Lateral shift at the height of the rail's top, in m, positive when the flange approaches.
    pub shift: f64,
    /// How far its running circle has come down from where it touches at shift 0, in m.
    pub descent: f64,
    /// Roll that lowers this wheel of the wheelset, in rad.
    pub roll: f64,
    /// Square of the yaw in rad.
    pub yaw_squared: f64,
}

/// A shift between two rows of a table.
#[derive(Clone, Copy, Debug)]
pub struct RowPlace {
    pub(super) index: usize,
    /// Part of the way to the next row.
    pub(super) part: f64,
    /// The shift lies outside the table.
    pub(super) beyond: bool,
}

impl RowPlace {
    /// As [`ContactPoint::beyond`].
    #[inline]
    pub fn beyond(&self) -> bool {
        self.beyond
    }

    /// Where `shift` lies among `count` rows of which the first stands at `begin`.
    #[inline]
    pub(super) fn new(shift: f64, begin: f64, count: usize) -> Self {
        let place = (shift - begin) * (1.0 / STEP);
        let inside = place.max(0.0).min((count - 1) as f64);
        let index = (inside as usize).min(count.saturating_sub(2));
        Self { index, part: inside - index as f64, beyond: place != inside }
    }
}

/// A patch of a table under a wheel; what is not asked for is not interpolated.
#[derive(Clone, Copy, Debug)]
pub struct PatchAt<'a> {
    rows: &'a [Row],
    begin: f64,
    yaw: YawArms,
    place: RowPlace,
    path: Cubic,
    /// Shift of the unyawed wheel with the same contact.
    shift: f64,
    /// Drop and slope there.
    node: Node,
}

/// A patch that presses.
#[derive(Clone, Copy, Debug)]
pub struct PressedPatch {
    /// The contact, at the foot.
    pub point: ContactPoint,
    /// Elastic approach along the normal, in m.
    pub approach: f64,
    /// Elastic energy, in J.
    pub energy: f64,
    /// How the approach changes with the wheel's shift. With it changes the elastic energy: so much
    /// times the normal force.
    pub by_shift: f64,
    /// The same for the descent.
    pub by_descent: f64,
    /// Descent of the contact for a roll that lowers the wheel, without that of the running circle, in m.
    pub roll_arm: f64,
    /// Descent of the contact for the square of the yaw, in m.
    pub yaw_arm: f64,
}

impl<'a> PatchAt<'a> {
    #[inline]
    pub(super) fn new(
        patch: &'a TablePatch,
        begin: f64,
        place: RowPlace,
        wheel: &WheelPlace,
    ) -> Self {
        let rows = &patch.rows;
        let path = path(rows, place.index, wheel);
        let node = path.at(place.part);
        Self { rows, begin, yaw: patch.yaw, place, path, shift: wheel.shift, node }
    }

    /// As [`ContactPoint::drop`].
    #[inline]
    pub fn drop(&self) -> f64 {
        self.node.0
    }

    /// As [`ContactPoint::rail_lateral`].
    #[inline]
    pub fn rail_lateral(&self) -> f64 {
        self.linear(2)
    }

    /// How far the `wheel` is pressed below the tangent to its path, in m.
    #[inline]
    pub fn sunk(&mut self, wheel: &WheelPlace) -> f64 {
        let here = self.below_tangent(wheel);
        if here > -REACH && wheel.yaw_squared > 0.0 {
            let aside = self.aside(wheel);
            self.go_to(wheel.shift - aside, wheel);
            return self.below_tangent(wheel);
        }
        here
    }

    /// How the patch presses when the `wheel` has [sunk](Self::sunk).
    #[inline]
    pub fn pressed(mut self, wheel: &WheelPlace) -> PressedPatch {
        let change = self.go_to_foot(wheel);
        let mut point = self.point();
        let slope = point.slope;
        let approach = self.below_tangent(wheel) * point.cos_angle;

        let [light, loaded] = [0, 1].map(|load| self.cubic(|row| row.stiffness[load]));
        let square = (approach / LOADED_FROM).powi(2);
        let part = square * square / (1.0 + square * square);
        let mix = |light: f64, loaded: f64, part: f64| light + part * (loaded - light);
        // Part of the loaded stiffness in the derivative of the energy by the approach.
        let in_force = part * (1.0 + 1.6 * (1.0 - part));
        let energy = 0.4 * mix(light.0, loaded.0, part) * approach * approach * approach.sqrt();
        let hertz = &mut point.hertz;
        hertz.stiffness = mix(light.0, loaded.0, in_force);
        hertz.stiffness_root = mix(hertz.stiffness_root, self.linear(6), in_force);
        let along = match hertz.stiffness > 0.0 {
            true => 0.4 * approach * mix(light.1, loaded.1, part) / (hertz.stiffness * change),
            false => 0.0,
        };
        PressedPatch {
            by_shift: point.sin_angle + along,
            by_descent: point.cos_angle + along * slope,
            roll_arm: self.cubic(|row| row.roll).0,
            yaw_arm: slope * (0.5 * self.yaw.radius * slope + self.yaw.half),
            approach,
            energy,
            point,
        }
    }

    /// Shift of the yawed wheel less that of the unyawed one for this contact.
    #[inline]
    fn aside(&self, wheel: &WheelPlace) -> f64 {
        wheel.yaw_squared * (self.yaw.radius * self.node.1 + self.yaw.half)
    }

    /// How far the wheel is below the tangent to its path at this contact.
    #[inline]
    fn below_tangent(&self, wheel: &WheelPlace) -> f64 {
        let (drop, slope) = self.node;
        let lifted = 0.5 * wheel.yaw_squared * self.yaw.radius * slope * slope;
        let off = self.shift + self.aside(wheel) - wheel.shift;
        wheel.descent - drop - lifted + slope * off
    }

    /// Moves to the foot of the perpendicular from the wheel's place, by Newton's method between bounds;
    /// gives the derivative of the equation that is zero there.
    #[inline]
    fn go_to_foot(&mut self, wheel: &WheelPlace) -> f64 {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let stretch = wheel.yaw_squared * self.yaw.radius;
        let mut change = 1.0;
        for _ in 0..MOST_STEPS {
            let (drop, slope) = self.node;
            let flat = 1.0 + slope * slope;
            let above = drop + 0.5 * stretch * slope * slope - wheel.descent;
            let error = self.shift + self.aside(wheel) - wheel.shift + above * slope;
            let bend = self.path.bend(self.place.part);
            change = (flat * (1.0 + stretch * bend) + above * bend).max(0.25 * flat);
            if error > 0.0 {
                high = self.shift;
            } else {
                low = self.shift;
            }
            let step = -error / change;
            let mut foot = self.shift + step;
            if foot < low || foot > high {
                foot = 0.5 * (low + high);
            }
            self.go_to(foot, wheel);
            if step.abs() < LAST_STEP || self.place.beyond {
                break;
            }
        }
        change
    }

    /// Moves to another shift of the unyawed wheel.
    #[inline]
    fn go_to(&mut self, shift: f64, wheel: &WheelPlace) {
        let place = RowPlace::new(shift, self.begin, self.rows.len());
        if place.index != self.place.index {
            self.path = path(self.rows, place.index, wheel);
        }
        (self.place, self.shift) = (place, shift);
        self.node = self.path.at(place.part);
    }

    /// All that is known of the contact.
    #[inline]
    pub fn point(&self) -> ContactPoint {
        let v: [f64; LINEAR] = std::array::from_fn(|k| self.linear(k));
        let (drop, slope) = self.node;
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
                stiffness: self.cubic(|row| row.stiffness[0]).0,
                stiffness_root: v[5],
            },
            kalker: CreepCoefficients { c11: v[7], c22: v[8], c23: v[9], c33: v[10] },
            beyond: self.place.beyond,
        }
    }

    #[inline]
    fn cubic(&self, node: impl Fn(&Row) -> Node) -> Node {
        let [p, q] = self.pair();
        Cubic::new(node(p), node(q)).at(self.place.part)
    }

    #[inline]
    fn linear(&self, k: usize) -> f64 {
        let [p, q] = self.pair();
        p.linear[k] + self.place.part * (q.linear[k] - p.linear[k])
    }

    #[inline]
    fn pair(&self) -> [&Row; 2] {
        [&self.rows[self.place.index], &self.rows[self.place.index + 1]]
    }
}

/// The path of the wheel between a row and the next.
#[inline]
fn path(rows: &[Row], index: usize, wheel: &WheelPlace) -> Cubic {
    let [p, q] = [index, index + 1].map(|i| rows[i].drop(wheel.roll));
    Cubic::new(p, q)
}
