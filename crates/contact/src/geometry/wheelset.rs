//! Contact of both wheels of a rolled wheelset.
//!
//! A wheelset displaced sideways rolls until both wheels touch. Here the profiles are turned with the
//! wheelset, which the table of a single wheel leaves out. This serves for validation and for
//! `hotfoot contact`, not for a step.

use super::pair::ProfilePair;
use super::search::{Search, Touch};
use crate::ContactError;

/// Largest roll that is searched, in rad.
const LARGEST_ROLL: f64 = 0.03;

/// Halvings of the roll interval: to 3e-13 rad.
const HALVINGS: usize = 38;

/// One wheel of a wheelset in contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelContact {
    /// Contact on the rail: distance from its highest point, in m, negative towards the gauge side.
    pub rail_lateral: f64,
    /// Contact on the wheel: distance from the running circle, in m, negative towards the flange.
    pub wheel_lateral: f64,
    /// Rolling radius less nominal radius, in m.
    pub radius_change: f64,
    /// Contact angle against the track plane, in rad, positive as on a tread.
    pub angle: f64,
}

/// A wheelset with both wheels in contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelsetGeometry {
    /// Roll in rad, positive with the right side down.
    pub roll: f64,
    /// The left wheel.
    pub left: WheelContact,
    /// The right wheel.
    pub right: WheelContact,
}

impl WheelsetGeometry {
    /// Rolling radius of the right wheel less that of the left, in m.
    pub fn radius_difference(&self) -> f64 {
        self.right.radius_change - self.left.radius_change
    }
}

/// The wheelset displaced by `lateral` metres to the right at the height of its axle, without yaw,
/// rolled so that both wheels touch.
///
/// # Errors
/// When a dimension of the pair is out of range or a wheel stands beside its rail.
pub fn wheelset_geometry(
    pair: &ProfilePair,
    lateral: f64,
) -> Result<WheelsetGeometry, ContactError> {
    pair.check()?;
    let mut search = Search::new(pair);
    let mut both = |roll: f64| -> Result<(Touch, Touch), ContactError> {
        let missing = || ContactError::NoContact {
            wheel: pair.wheel.name(),
            rail: pair.rail.name().into(),
            shift_mm: 1e3 * lateral,
        };
        let left = search.rolled(-lateral, -roll).ok_or_else(missing)?;
        let right = search.rolled(lateral, roll).ok_or_else(missing)?;
        Ok((left, right))
    };
    // The right wheel touches higher than the left one as long as the wheelset rolls too far right.
    let (mut low, mut high) = (-LARGEST_ROLL, LARGEST_ROLL);
    for _ in 0..HALVINGS {
        let roll = 0.5 * (low + high);
        let (left, right) = both(roll)?;
        if right.drop > left.drop {
            low = roll;
        } else {
            high = roll;
        }
    }
    let roll = 0.5 * (low + high);
    let (left, right) = both(roll)?;
    Ok(WheelsetGeometry { roll, left: contact(&left), right: contact(&right) })
}

/// What is told about one wheel.
fn contact(touch: &Touch) -> WheelContact {
    WheelContact {
        rail_lateral: touch.rail_lateral,
        wheel_lateral: touch.wheel_lateral,
        radius_change: touch.wheel_height,
        angle: -touch.slope.atan(),
    }
}
