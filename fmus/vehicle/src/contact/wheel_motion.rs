//! How a wheel of a wheelset moves over its rail.

use contact::WheelPosition;

use super::six::Six;
use crate::body::BodyState;

/// Rail on which a wheel runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Left rail.
    Left,
    /// Right rail.
    Right,
}

impl Side {
    /// Both, in the order of all lists.
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// -1 on the left, +1 on the right.
    pub fn sign(self) -> f64 {
        match self {
            Self::Left => -1.0,
            Self::Right => 1.0,
        }
    }
}

/// Dimensions of a wheel.
#[derive(Clone, Copy, Debug)]
pub struct WheelData {
    /// Radius of the running circle, m.
    pub radius: f64,
    /// Distance of the running circle from the track's middle, m.
    pub half_distance: f64,
    /// Damping force over normal force for a speed of approach, s/m.
    pub damping: f64,
}

/// How a wheel of a wheelset moves over its rail.
pub struct WheelMotion<'a> {
    /// Side on which the wheel is.
    pub side: Side,
    /// Its dimensions.
    pub data: &'a WheelData,
    /// State of the wheelset, seen from the rail.
    pub state: &'a BodyState,
    /// Velocities of the wheelset against the rail.
    pub velocities: &'a Six,
    /// Speed of travel, m/s.
    pub speed: f64,
    /// Rotation of the wheelset's frame about z by distance travelled, rad/m.
    pub turning: f64,
}

impl WheelMotion<'_> {
    /// Where the wheel is over its rail (eq. 16).
    #[inline]
    pub fn position(&self) -> WheelPosition {
        let (sign, data, state) = (self.side.sign(), self.data, self.state);
        let roll = sign * state.rotation.x;
        WheelPosition {
            shift: sign * state.position.y - data.radius * roll,
            descent: state.position.z + data.half_distance * roll,
            roll,
            yaw_squared: state.rotation.z * state.rotation.z,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Equation 16 by hand: a wheelset 3 mm to the right and 1 mm down, rolled by 2 mrad with its right
    /// side down, on wheels of 0.5 m at 0.75 m from the middle.
    #[test]
    fn analytic_position_of_both_wheels() {
        let mut state = BodyState::default();
        (state.position.y, state.position.z) = (3e-3, 1e-3);
        (state.rotation.x, state.rotation.z) = (2e-3, 4e-3);
        let data = WheelData { radius: 0.5, half_distance: 0.75, damping: 0.0 };
        for (side, shift, descent) in [(Side::Left, -2e-3, -0.5e-3), (Side::Right, 2e-3, 2.5e-3)] {
            let motion = WheelMotion {
                side,
                data: &data,
                state: &state,
                velocities: &Six::default(),
                speed: 0.0,
                turning: 0.0,
            };
            let position = motion.position();
            assert!((position.shift - shift).abs() < 1e-15);
            assert!((position.descent - descent).abs() < 1e-15);
            assert!((position.roll - side.sign() * 2e-3).abs() < 1e-15);
            assert!((position.yaw_squared - 16e-6).abs() < 1e-18);
        }
    }
}
