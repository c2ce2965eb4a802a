//! Contact of both wheels of a rolled wheelset.
//!
//! A wheelset displaced sideways rolls until both wheels touch. Here the profiles are turned with the
//! wheelset, which the table of a single wheel leaves out. This serves for validation and for
//! `hotfoot contact`, not for a step.

use super::pair::ProfilePair;
use super::search::{Search, Touch};
use crate::error::ContactError;
use crate::hertz::UnitContact;

/// Largest roll that is searched, in rad.
const LARGEST_ROLL: f64 = 0.03;

/// Halvings of the roll interval: to 3e-13 rad.
const HALVINGS: usize = 38;

/// One contact of a wheel of a wheelset.
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
    /// How much further down than the first contact of the wheel this one begins to touch, in m.
    pub gap: f64,
    /// Contact ellipse and stiffness for 1 N.
    pub hertz: UnitContact,
}

/// How a wheelset rolls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Roll {
    /// So that both wheels touch their rails, as a rigid wheelset does.
    Free,
    /// By this angle in rad, positive with the right side down, whether both wheels touch or not.
    Fixed(f64),
}

/// The left and the right wheel of a wheelset, each with its rail.
#[derive(Clone, Debug, PartialEq)]
pub struct WheelsetPairs {
    /// Wheel and rail on the left.
    pub left: ProfilePair,
    /// Wheel and rail on the right.
    pub right: ProfilePair,
}

/// A wheelset over its rails.
#[derive(Clone, Debug, PartialEq)]
pub struct WheelsetGeometry {
    /// Roll in rad, positive with the right side down.
    pub roll: f64,
    /// Contacts of the left wheel, the first one to touch first.
    pub left: Vec<WheelContact>,
    /// Contacts of the right wheel, likewise.
    pub right: Vec<WheelContact>,
    /// Nominal radius of the right wheel less that of the left, in m.
    nominal_difference: f64,
}

impl WheelsetGeometry {
    /// Rolling radius of the right wheel less that of the left at their first contacts, in m.
    pub fn radius_difference(&self) -> f64 {
        self.nominal_difference + self.right[0].radius_change - self.left[0].radius_change
    }
}

/// The displaced and yawed wheelset of equal wheels, rolled so that both touch.
///
/// It is displaced by `lateral` metres to the right at the height of its axle and yawed by `yaw` rad.
///
/// # Errors
/// When a dimension of the pair is out of range or a wheel stands beside its rail.
pub fn wheelset_geometry(
    pair: &ProfilePair,
    lateral: f64,
    yaw: f64,
) -> Result<WheelsetGeometry, ContactError> {
    WheelsetPairs::alike(pair).geometry(lateral, yaw, Roll::Free)
}

impl WheelsetPairs {
    /// The same pair on both sides.
    pub fn alike(pair: &ProfilePair) -> Self {
        Self { left: pair.clone(), right: pair.clone() }
    }

    /// Refuses dimensions that no railway has.
    pub(super) fn check(&self) -> Result<(), ContactError> {
        self.left.check()?;
        self.right.check()
    }

    /// The wheelset displaced by `lateral` metres to the right at the height of its axle, yawed by `yaw`
    /// rad, and rolled.
    ///
    /// # Errors
    /// When a dimension of a pair is out of range or a wheel stands beside its rail.
    pub fn geometry(
        &self,
        lateral: f64,
        yaw: f64,
        roll: Roll,
    ) -> Result<WheelsetGeometry, ContactError> {
        self.check()?;
        let Self { left, right } = self;
        let (mut left_search, mut right_search) = (Search::new(left), Search::new(right));
        let mut both = |roll: f64| -> Result<[Vec<Touch>; 2], ContactError> {
            let both =
                [left_search.rolled(-lateral, -roll, yaw), right_search.rolled(lateral, roll, yaw)];
            match both.iter().zip([left, right]).find(|(touches, _)| touches.is_empty()) {
                Some((_, pair)) => Err(pair.no_contact(lateral)),
                None => Ok(both),
            }
        };
        let roll = match roll {
            Roll::Fixed(roll) => roll,
            Roll::Free => {
                // The right wheel touches higher than the left one as long as the wheelset rolls too far
                // to the right; the axle of a smaller wheel comes lower.
                let smaller = right.nominal_radius - left.nominal_radius;
                let (mut low, mut high) = (-LARGEST_ROLL, LARGEST_ROLL);
                for _ in 0..HALVINGS {
                    let roll = 0.5 * (low + high);
                    let [left, right] = both(roll)?;
                    if drop(&right) - smaller > drop(&left) {
                        low = roll;
                    } else {
                        high = roll;
                    }
                }
                0.5 * (low + high)
            }
        };
        let [on_left, on_right] = both(roll)?;
        Ok(WheelsetGeometry {
            roll,
            left: contacts(left, &on_left),
            right: contacts(right, &on_right),
            nominal_difference: right.nominal_radius - left.nominal_radius,
        })
    }
}

/// Where the first contact touches.
fn drop(touches: &[Touch]) -> f64 {
    touches.iter().map(|touch| touch.drop).fold(f64::INFINITY, f64::min)
}

/// The contacts of a wheel, the first one to touch first.
fn contacts(pair: &ProfilePair, touches: &[Touch]) -> Vec<WheelContact> {
    let first = drop(touches);
    let contact = |touch: &Touch| WheelContact {
        rail_lateral: touch.rail_lateral,
        wheel_lateral: touch.wheel_lateral,
        radius_change: touch.wheel_height,
        angle: -libm::atan(touch.slope),
        gap: touch.drop - first,
        hertz: touch.hertz(pair.nominal_radius),
    };
    let mut contacts: Vec<_> = touches.iter().map(contact).collect();
    contacts.sort_by(|a, b| a.gap.total_cmp(&b.gap));
    contacts
}
