//! The frame that follows the track, and how frames at two chainages lie to each other.
//!
//! Each body has a frame of its own: origin on the track's centre line at the body's chainage s,
//! x along the track, y to the right in the plane of the rails, z down. Positions in it are small;
//! velocities are absolute, only their components are taken in it. So the inertia forces of the
//! moving frame reduce to one cross product (eq. 4), which does no work.

use nalgebra::Vector3;
use numerics::constants::STANDARD_GRAVITY;
use track::TrackPoint;

/// The frame at one chainage.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// The track there.
    pub track: TrackPoint,
    /// Sine and cosine of the cant angle.
    pub cant: (f64, f64),
    /// Rotation of the frame by distance travelled, rad/m (eq. 1).
    pub rotation: Vector3<f64>,
    /// Gravity in the frame, m/s² (eq. 5).
    pub gravity: Vector3<f64>,
}

impl Default for Frame {
    fn default() -> Self {
        Self::new(TrackPoint::default())
    }
}

impl Frame {
    /// The frame where the track is as `track` says.
    #[inline]
    pub fn new(track: TrackPoint) -> Self {
        let (sin, cos) = sin_cos(track.cant_angle);
        let rotation = Vector3::new(
            track.cant_angle_slope,
            track.gradient_slope * cos + track.curvature * sin,
            track.curvature * cos - track.gradient_slope * sin,
        );
        let upright = STANDARD_GRAVITY * (1.0 - 0.5 * track.gradient * track.gradient);
        let gravity =
            Vector3::new(-STANDARD_GRAVITY * track.gradient, upright * sin, upright * cos);
        Self { track, cant: (sin, cos), rotation, gravity }
    }

    /// Where another frame, `distance` metres ahead of this one, lies in this one (eq. 6, 7).
    #[inline]
    pub fn placement(&self, other: &Self, distance: f64) -> Placement {
        let (here, there) = (&self.track, &other.track);
        let (sin, cos) = self.cant;
        let right = there.heading_integral - here.heading_integral - distance * here.heading;
        let down = here.elevation - there.elevation + distance * here.gradient;
        let heading = there.heading - here.heading;
        let gradient = there.gradient - here.gradient;
        Placement {
            offset: Vector3::new(distance, right * cos + down * sin, down * cos - right * sin),
            turn: Vector3::new(
                there.cant_angle - here.cant_angle,
                gradient * cos + heading * sin,
                heading * cos - gradient * sin,
            ),
        }
    }
}

/// A frame's origin and small rotation in another frame.
#[derive(Clone, Copy, Debug, Default)]
pub struct Placement {
    /// Origin, m.
    pub offset: Vector3<f64>,
    /// Rotation vector, rad.
    pub turn: Vector3<f64>,
}

impl Placement {
    /// Components in the other frame of a vector given in the placed one.
    #[inline]
    pub fn out(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        vector + self.turn.cross(vector)
    }

    /// Components in the placed frame of a vector given in the other one.
    ///
    /// The transpose of [`Self::out`], so that a moment has the same power in both.
    #[inline]
    pub fn back(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        vector - self.turn.cross(vector)
    }

    /// As [`Self::out`] to second order in the turn, for a velocity: across the frames even a small part
    /// of the speed of travel is much for a damper.
    #[inline]
    pub fn velocity_out(&self, velocity: &Vector3<f64>) -> Vector3<f64> {
        velocity + self.turn.cross(&(velocity + 0.5 * self.turn.cross(velocity)))
    }

    /// The transpose of [`Self::velocity_out`], for a force.
    #[inline]
    pub fn force_back(&self, force: &Vector3<f64>) -> Vector3<f64> {
        force - self.turn.cross(&(force - 0.5 * self.turn.cross(force)))
    }
}

/// Sine and cosine of a cant angle: series, with an error below 3e-6 up to 0.2 rad (300 mm).
fn sin_cos(angle: f64) -> (f64, f64) {
    let square = angle * angle;
    (angle * (1.0 - square * (1.0 / 6.0)), 1.0 - square * (0.5 - square * (1.0 / 24.0)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use track::Track;

    /// Two frames 10 m apart in a level curve of 500 m: offset s²/2R, turn s/R.
    #[test]
    fn analytic_placement_in_a_circle() {
        let track =
            Track::from_toml("alignment = [{ length_m = 1000.0, radius_m = 500.0 }]", "curve")
                .unwrap();
        let at = |chainage| Frame::new(track.at(chainage, &mut 0));
        let placement = at(100.0).placement(&at(110.0), 10.0);
        assert!((placement.offset - Vector3::new(10.0, 0.1, 0.0)).norm() < 1e-12);
        assert!((placement.turn - Vector3::new(0.0, 0.0, 0.02)).norm() < 1e-12);
    }

    /// Centrifugal and gravity forces in the plane of the rails vanish at the balance speed.
    #[test]
    fn analytic_balance_speed_of_a_canted_curve() {
        let text = "alignment = [{ length_m = 1000.0, radius_m = 800.0, cant_mm = 90.0 }]";
        let track = Track::from_toml(text, "curve").unwrap();
        let frame = Frame::new(track.at(500.0, &mut 0));
        let speed = (STANDARD_GRAVITY * 800.0 * 0.06_f64.asin().tan()).sqrt();
        let velocity = Vector3::new(speed, 0.0, 0.0);
        let centripetal = (frame.rotation * speed).cross(&velocity);
        assert!((centripetal.y - frame.gravity.y).abs() < 1e-6);
    }
}
