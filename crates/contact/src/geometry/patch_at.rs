//! A patch of the table under a wheel: where it would touch, and where it presses.
//!
//! Unloaded, a wheel moves on the path drop(shift). Pressed beyond it, it touches where it is nearest
//! to the path: at the foot of the perpendicular, whose length is the elastic approach. So the energy
//!
//! ```text
//! U = 2/5 k(foot) approach^(5/2)
//! ```
//!
//! is a function of the wheel's position alone and its gradient is the force: N = k approach^(3/2) along
//! the perpendicular, as the derivative of the distance to a curve is the unit normal at the foot, and
//! where the stiffness changes along the path a small force along it, 2/5 dk/dfoot approach^(5/2).

use super::contact_point::ContactPoint;
use super::row::{Cubic, Node, Row, STEP, TablePatch, YawArms};
use crate::hertz::UnitContact;
use crate::kalker::CreepCoefficients;

/// After a step as short as this, in m of shift, the foot is exact: the error falls with the square.
const LAST_STEP: f64 = 5e-6;

/// A step as long as this, in m of shift, reaches the foot if no row lies between.
const ONE_STEP: f64 = 1.5e-5;

/// Steps after which a foot is searched between bounds.
const CHEBYSHEV_STEPS: usize = 3;

/// Steps of the search, far more than any contact takes.
const MOST_STEPS: usize = 30;

/// Approach from which a contact counts as loaded, in m: that of a wheel under 40 kN.
const LOADED_FROM: f64 = 50e-6;

/// A wheel that is further above its path does not touch it, whatever its yaw, in m.
const REACH: f64 = 5e-4;

/// Where a wheel is over its rail.
#[derive(Clone, Copy, Debug, Default)]
pub struct WheelPosition {
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
pub struct RowPosition {
    pub(super) index: usize,
    /// Share of the distance to the next row.
    pub(super) part: f64,
    /// The shift lies outside the table.
    pub(super) beyond: bool,
}

impl RowPosition {
    /// As [`ContactPoint::beyond`].
    #[inline]
    pub fn beyond(&self) -> bool {
        self.beyond
    }

    /// Where `shift` lies among `count` rows of which the first stands at `begin`.
    #[inline]
    pub(super) fn new(shift: f64, begin: f64, count: usize) -> Self {
        let row = (shift - begin) * (1.0 / STEP);
        let inside = row.max(0.0).min((count - 1) as f64);
        let index = (inside as u32 as usize).min(count.saturating_sub(2));
        Self { index, part: inside - index as f64, beyond: row != inside }
    }
}

/// A patch of a table under a wheel; each value is interpolated only when it is read.
#[derive(Clone, Copy, Debug)]
pub struct PatchAt<'a> {
    rows: &'a [Row],
    begin: f64,
    yaw: YawArms,
    at: RowPosition,
    path: Cubic,
    /// Shift of the unyawed wheel with the same contact.
    shift: f64,
    /// Drop and slope there.
    node: Node,
}

/// Error of the equation (foot - shift) + (drop - descent) slope = 0, and its derivatives.
///
/// First and second, by the shift of the unyawed wheel.
struct OffFoot {
    error: f64,
    change: f64,
    bend: f64,
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
    /// The same for the square of the yaw, in m.
    pub by_yaw_squared: f64,
    /// Descent of the contact for a roll that lowers the wheel, without that of the running circle, in m.
    pub roll_arm: f64,
}

impl<'a> PatchAt<'a> {
    #[inline]
    pub(super) fn new(
        patch: &'a TablePatch,
        begin: f64,
        at: RowPosition,
        wheel: &WheelPosition,
    ) -> Self {
        let rows = &patch.rows;
        let path = rows[at.index].path(wheel.roll);
        let node = path.at(at.part);
        Self { rows, begin, yaw: patch.yaw, at, path, shift: wheel.shift, node }
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
    ///
    /// The path is hollow, so that no tangent shows a contact where there is none.
    #[inline]
    pub fn sunk(&mut self, wheel: &WheelPosition) -> f64 {
        let here = self.below_tangent(wheel);
        if (-REACH..=0.0).contains(&here) {
            self.go_by(-self.aside(wheel), wheel);
            return self.below_tangent(wheel);
        }
        here
    }

    /// How the patch presses when the `wheel` has [sunk](Self::sunk).
    #[inline]
    pub fn pressed(mut self, wheel: &WheelPosition) -> PressedPatch {
        let change = self.go_to_foot(wheel);
        let t = self.at.part;
        let slope = self.node.1;
        let cos_angle = 1.0 / (1.0 + slope * slope).sqrt();
        // To the tangent, as its error is of second order in that of the foot.
        let approach = (self.below_tangent(wheel) * cos_angle).max(0.0);
        let lift = 0.5 * self.yaw.radius * slope;

        let row = &self.rows[self.at.index];
        let [light, loaded] = row.stiffness.each_ref().map(|stiffness| stiffness.at(t));
        let square = (approach * (1.0 / LOADED_FROM)).powi(2);
        let part = square * square / (1.0 + square * square);
        let mix = |light: f64, loaded: f64, part: f64| light + part * (loaded - light);
        // Part of the loaded stiffness in the derivative of the energy by the approach.
        let in_force = part * (1.0 + 1.6 * (1.0 - part));
        let force = mix(light.0, loaded.0, in_force);
        let root = mix(self.linear(5), self.linear(6), in_force);
        let along = match force > 0.0 {
            true => 0.4 * approach * mix(light.1, loaded.1, part) / (force * change),
            false => 0.0,
        };
        let point = self.contact(cos_angle, force, root);
        PressedPatch {
            by_shift: point.sin_angle + along,
            by_descent: cos_angle + along * slope,
            roll_arm: row.roll.value(t),
            by_yaw_squared: cos_angle * slope * (lift + self.yaw.half)
                - along * (2.0 * lift + self.yaw.half + lift * slope * slope),
            approach,
            energy: 0.4 * mix(light.0, loaded.0, part) * approach * approach * approach.sqrt(),
            point,
        }
    }

    /// Shift of the yawed wheel less that of the unyawed one for this contact.
    #[inline]
    fn aside(&self, wheel: &WheelPosition) -> f64 {
        wheel.yaw_squared * (self.yaw.radius * self.node.1 + self.yaw.half)
    }

    /// How far the wheel is below the tangent to its path at this contact.
    #[inline]
    fn below_tangent(&self, wheel: &WheelPosition) -> f64 {
        let (drop, slope) = self.node;
        let lifted = 0.5 * wheel.yaw_squared * self.yaw.radius * slope * slope;
        let off = self.shift + self.aside(wheel) - wheel.shift;
        wheel.descent - drop - lifted + slope * off
    }

    /// Moves to the foot of the perpendicular; gives the derivative of the equation that is zero there.
    ///
    /// By Chebyshev's method: Newton's with the second derivative.
    #[inline]
    fn go_to_foot(&mut self, wheel: &WheelPosition) -> f64 {
        for _ in 0..CHEBYSHEV_STEPS {
            let OffFoot { error, change, bend } = self.off_foot(wheel);
            let newton = -error / change;
            let step = newton - 0.5 * bend * newton * newton / change;
            let index = self.at.index;
            self.go_by(step, wheel);
            if newton.abs() < ONE_STEP && self.at.index == index {
                return change + bend * step;
            }
        }
        self.search_foot(wheel)
    }

    /// Newton's method between bounds, where one step does not suffice.
    fn search_foot(&mut self, wheel: &WheelPosition) -> f64 {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for _ in 0..MOST_STEPS {
            let OffFoot { error, change, .. } = self.off_foot(wheel);
            if error > 0.0 {
                high = self.shift;
            } else {
                low = self.shift;
            }
            let mut step = -error / change;
            if self.shift + step < low || self.shift + step > high {
                step = 0.5 * (low + high) - self.shift;
            }
            self.go_by(step, wheel);
            if step.abs() < LAST_STEP || self.at.beyond {
                return change;
            }
        }
        self.off_foot(wheel).change
    }

    /// The equation of the foot at this shift of the unyawed wheel.
    #[inline]
    fn off_foot(&self, wheel: &WheelPosition) -> OffFoot {
        let (drop, slope) = self.node;
        let stretch = wheel.yaw_squared * self.yaw.radius;
        let flat = 1.0 + slope * slope;
        let above = drop + 0.5 * stretch * slope * slope - wheel.descent;
        let [turn, turn_change] = self.path.bends(self.at.part);
        let stretched = 1.0 + stretch * turn;
        OffFoot {
            error: self.shift + self.aside(wheel) - wheel.shift + above * slope,
            change: (flat * stretched + above * turn).max(0.25 * flat),
            bend: 3.0 * slope * turn * stretched + turn_change * (stretch * flat + above),
        }
    }

    /// Changes the shift of the unyawed wheel.
    #[inline]
    fn go_by(&mut self, step: f64, wheel: &WheelPosition) {
        self.shift += step;
        let part = self.at.part + step * (1.0 / STEP);
        if (0.0..=1.0).contains(&part) {
            self.at.part = part;
        } else {
            self.at = RowPosition::new(self.shift, self.begin, self.rows.len());
            self.path = self.rows[self.at.index].path(wheel.roll);
        }
        self.node = self.path.at(self.at.part);
    }

    /// The contact with a light load.
    pub fn point(&self) -> ContactPoint {
        let slope = self.node.1;
        let stiffness = self.rows[self.at.index].stiffness[0].value(self.at.part);
        self.contact(1.0 / (1.0 + slope * slope).sqrt(), stiffness, self.linear(5))
    }

    #[inline]
    fn contact(&self, cos_angle: f64, stiffness: f64, stiffness_root: f64) -> ContactPoint {
        let (drop, slope) = self.node;
        ContactPoint {
            drop,
            slope,
            sin_angle: -slope * cos_angle,
            cos_angle,
            radius_change: self.linear(0),
            wheel_lateral: self.linear(1),
            rail_lateral: self.linear(2),
            hertz: UnitContact {
                semi_axis_rolling: self.linear(3),
                semi_axis_lateral: self.linear(4),
                stiffness,
                stiffness_root,
            },
            kalker: CreepCoefficients {
                c11: self.linear(7),
                c22: self.linear(8),
                c23: self.linear(9),
                c33: self.linear(10),
            },
            beyond: self.at.beyond,
        }
    }

    #[inline]
    fn linear(&self, k: usize) -> f64 {
        let [p, q] = [0, 1].map(|next| &self.rows[self.at.index + next]);
        p.linear[k] + self.at.part * (q.linear[k] - p.linear[k])
    }
}
