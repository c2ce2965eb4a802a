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
