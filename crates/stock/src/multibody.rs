//! The `[multibody]` section of a vehicle file: bodies, wheelsets, force elements, contact.
//!
//! Points are given in the vehicle at rest on straight level track: x forward from the vehicle's
//! middle, y to the right of the centre line, and the height above the rails.

use serde::Deserialize;

use crate::check::{Check, StockError};
use crate::multibody_check::Checker;

/// A vehicle as rigid bodies with springs, dampers and stops between them.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Multibody {
    /// Where the values come from.
    pub source: String,
    /// Where the couplers pull.
    pub coupler: CouplerAttachment,
    /// Wheel and rail profiles, creep and damping of all contacts.
    pub contact: WheelRailContact,
    /// Car body and bogie frames; the first one carries couplers and train forces.
    pub body: Vec<Body>,
    /// Wheelsets from front to rear.
    pub wheelset: Vec<Wheelset>,
    /// Springs with parallel damping.
    #[serde(default)]
    pub spring: Vec<Spring>,
    /// Hydraulic dampers.
    #[serde(default)]
    pub damper: Vec<Damper>,
    /// Stops with free play.
    #[serde(default)]
    pub stop: Vec<Stop>,
}

/// Height of the couplers; they act on the first body at half the vehicle's length.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct CouplerAttachment {
    /// Height above the rails, m.
    pub height_m: f64,
}

/// What the contacts of all wheels have in common.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct WheelRailContact {
    /// Name of the wheel profile, such as `"S1002"` or `"cone-1-20"`.
    pub wheel: String,
    /// Name of the rail profile, such as `"60E1"`.
    pub rail: String,
    /// Inclination of the rails, 0.025 for 1:40.
    pub rail_inclination: f64,
    /// Track gauge, mm.
    pub gauge_mm: f64,
    /// Distance of the flange backs of a wheelset, mm.
    pub flange_back_distance_mm: f64,
    /// Damping force over normal force for a speed of approach, s/m.
    pub damping_s_m: f64,
    /// Polach's creep law.
    pub creep: CreepLaw,
}

/// Parameters of Polach's creep law and of its falling friction.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct CreepLaw {
    /// Where the values come from.
    pub source: String,
    /// Reduction of the initial slope in the area of adhesion (kA).
    pub adhesion_factor: f64,
    /// Reduction in the area of slip (kS).
    pub slip_factor: f64,
    /// Friction coefficient without slip (mu0).
    pub friction: f64,
    /// Ratio of the friction at infinite slip velocity to `friction` (A).
    pub limit_ratio: f64,
    /// Decay of the friction with the slip velocity (B), s/m.
    pub decay_s_m: f64,
}

/// A car body or a bogie frame.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// Name that elements refer to.
    pub name: String,
    /// Mass, kg.
    pub mass_kg: f64,
    /// Moments of inertia about x, y, z through the centre of mass, kg m².
    pub inertia_kg_m2: [f64; 3],
    /// Centre of mass: x from the vehicle's middle, m.
    pub x_m: f64,
    /// Centre of mass: height above the rails, m.
    pub height_m: f64,
}

/// A wheelset; its centre of mass is at the axle, at the height of the wheel radius.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Wheelset {
    /// Name that elements refer to.
    pub name: String,
    /// Mass, kg.
    pub mass_kg: f64,
    /// Moments of inertia about x, y (with the rotor reflected), z, kg m².
    pub inertia_kg_m2: [f64; 3],
    /// Place along the vehicle: x from its middle, m.
    pub x_m: f64,
    /// Radius of the running circle, m.
    pub wheel_radius_m: f64,
    /// Body on which drive and brake react.
    pub frame: String,
    /// Whether the drive acts on it.
    #[serde(default)]
    pub powered: bool,
}

/// Springs of one kind between two bodies, one at each point, each with its damping in parallel.
///
/// A spring has no length; it carries its share of the weight when the vehicle stands at its
/// given heights.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Spring {
    /// Name for messages.
    pub name: String,
    /// The two bodies.
    pub between: [String; 2],
    /// Points x, y, height above the rails, m.
    pub points_m: Vec<[f64; 3]>,
    /// Stiffness in x, y, z, N/m.
    pub stiffness_n_m: [f64; 3],
    /// Damping in x, y, z, N s/m.
    #[serde(default)]
    pub damping_n_s_m: [f64; 3],
}

/// Direction in which a damper or a stop acts.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub enum Direction {
    /// Along the vehicle (x).
    Longitudinal,
    /// Across it (y).
    Lateral,
    /// Vertical (z).
    Vertical,
}

/// Dampers of one kind between two bodies, one at each point.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Damper {
    /// Name for messages.
    pub name: String,
    /// The two bodies.
    pub between: [String; 2],
    /// Points x, y, height above the rails, m.
    pub points_m: Vec<[f64; 3]>,
    /// Direction in which it acts.
    pub direction: Direction,
    /// Damping, N s/m.
    pub damping_n_s_m: f64,
    /// Stiffness in series (oil, mounts), N/m; left out: rigid.
    pub series_stiffness_n_m: Option<f64>,
    /// Force at which the damper blows off, N; left out: never.
    pub blow_off_n: Option<f64>,
}

/// Stops of one kind between two bodies, one at each point.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Stop {
    /// Name for messages.
    pub name: String,
    /// The two bodies.
    pub between: [String; 2],
    /// Points x, y, height above the rails, m.
    pub points_m: Vec<[f64; 3]>,
    /// Direction in which it acts, to both sides.
    pub direction: Direction,
    /// Free play to each side, mm.
    pub free_play_mm: f64,
    /// Stiffness beyond the free play, N/m.
    pub stiffness_n_m: f64,
}

impl Multibody {
    /// Sum of the masses, kg.
    pub fn mass(&self) -> f64 {
        let bodies: f64 = self.body.iter().map(|body| body.mass_kg).sum();
        let wheelsets: f64 = self.wheelset.iter().map(|wheelset| wheelset.mass_kg).sum();
        bodies + wheelsets
    }

    /// Checks the section of a vehicle that has `mass_kg` by its common data.
    pub(crate) fn check(&self, check: &Check, mass_kg: f64) -> Result<(), StockError> {
        let checker = Checker::new(self, check)?;
        checker.masses(mass_kg)?;
        checker.contact()?;
        checker.elements()
    }
}
