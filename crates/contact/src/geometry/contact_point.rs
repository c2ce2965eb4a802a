//! What is known at a contact before the forces are.

use crate::hertz::UnitContact;
use crate::kalker::CreepCoefficients;

/// Contact of one wheel at one lateral shift.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactPoint {
    /// Downward displacement of the wheel at which it first touches, in m, relative to shift 0.
    /// It falls where the flange lifts the wheel.
    pub drop: f64,
    /// d drop / d shift = -tan(contact angle); exactly the derivative of `drop`.
    pub slope: f64,
    /// Sine of the contact angle, positive as on a tread.
    ///
    /// There the rail pushes this wheel towards the track's middle: on the wheel a normal force N acts
    /// with N sin towards the middle and N cos upwards.
    pub sin_angle: f64,
    /// Cosine of the contact angle.
    pub cos_angle: f64,
    /// Rolling radius less nominal radius, in m.
    pub radius_change: f64,
    /// Contact on the wheel: distance from the running circle, in m, negative towards the flange.
    pub wheel_lateral: f64,
    /// Contact on the rail: distance from its highest point, in m, negative towards the gauge side.
    pub rail_lateral: f64,
    /// Contact ellipse and stiffness for 1 N.
    pub hertz: UnitContact,
    /// Kalker's coefficients of the ellipse.
    pub kalker: CreepCoefficients,
    /// The shift lies beyond the table, and all values are those at its end.
    ///
    /// The flange has climbed over the rail, or the wheel is off its tread.
    pub beyond: bool,
}

impl ContactPoint {
    /// Contact angle in rad, positive as on a tread.
    pub fn angle(&self) -> f64 {
        -libm::atan(self.slope)
    }

    /// The contact under `normal_force` (N); without load, or with tension, its size is zero.
    pub fn patch(&self, normal_force: f64) -> ContactPatch {
        let normal_force = normal_force.max(0.0);
        self.pressed(self.hertz.approach(normal_force), normal_force)
    }

    /// The contact of two bodies nearer by the elastic `approach` (m), which carries `normal_force`
    /// (N). Damping adds to the force, not to the size.
    #[inline]
    pub fn pressed(&self, approach: f64, normal_force: f64) -> ContactPatch {
        let (a, b) = self.hertz.semi_axes(approach);
        ContactPatch { normal_force, a, b, kalker: self.kalker }
    }
}

/// A loaded contact ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactPatch {
    /// Normal force in N, not negative.
    pub normal_force: f64,
    /// Semi-axis in the rolling direction, in m.
    pub a: f64,
    /// Semi-axis across, in m.
    pub b: f64,
    /// Kalker's coefficients of the ellipse.
    pub kalker: CreepCoefficients,
}
