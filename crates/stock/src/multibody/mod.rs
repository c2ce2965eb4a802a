//! The `[multibody]` section of a vehicle file: bodies, wheelsets, contact and force elements.
//!
//! | file | part |
//! |---|---|
//! | `elements.rs` | the force elements; `elements_check.rs` checks them |
//! | `creep.rs` | the creep law |
//! | `check.rs` | what bodies, wheelsets and contacts must fulfil |
//! | `profile_files.rs` | profiles that are files of points |
//!
//! Points are given in the vehicle at rest on straight level track: x forward from the vehicle's
//! middle, y to the right of the centre line, and the height above the rails.

mod check;
mod creep;
mod elements;
mod elements_check;
pub(crate) mod profile_files;

use schemars::JsonSchema;
use serde::Deserialize;

pub use creep::{CreepLaw, CreepLawKind};
pub use elements::{
    CentrePlate, Damper, Direction, Friction, Rod, RotationalSpring, SideBearer, Spring, Stop,
    TabulatedSpring, Wedge,
};

/// A vehicle as rigid bodies with springs, dampers and stops between them.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
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
    /// Springs with a table of force over displacement.
    #[serde(default)]
    pub tabulated_spring: Vec<TabulatedSpring>,
    /// Springs against rotation, such as anti-roll bars.
    #[serde(default)]
    pub rotational_spring: Vec<RotationalSpring>,
    /// Rods with a length, such as traction rods.
    #[serde(default)]
    pub rod: Vec<Rod>,
    /// Dry friction with a constant limit.
    #[serde(default)]
    pub friction: Vec<Friction>,
    /// Friction wedges of three-piece bogies.
    #[serde(default)]
    pub wedge: Vec<Wedge>,
    /// Centre plates.
    #[serde(default)]
    pub centre_plate: Vec<CentrePlate>,
    /// Constant-contact side bearers.
    #[serde(default)]
    pub side_bearer: Vec<SideBearer>,
}

/// Height of the couplers; they act on the first body at half the vehicle's length.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct CouplerAttachment {
    /// Height above the rails, m.
    pub height_m: f64,
}

/// What the contacts of all wheels have in common.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct WheelRailContact {
    /// Name of the wheel profile, such as `"S1002"`, or the path of a file of points.
    pub wheel: String,
    /// Name of the rail profile, such as `"60E1"`, or the path of a file of points.
    pub rail: String,
    /// Profile of the left wheels, if it differs from `wheel`.
    #[serde(default)]
    pub left_wheel: Option<String>,
    /// Profile of the left rail, if it differs from `rail`.
    #[serde(default)]
    pub left_rail: Option<String>,
    /// Inclination of the rails, 0.025 for 1:40.
    pub rail_inclination: f64,
    /// Track gauge, mm.
    pub gauge_mm: f64,
    /// Depth below the top of the rail to which the gauge is measured, mm.
    #[serde(default = "gauge_depth_mm")]
    pub gauge_depth_mm: f64,
    /// Distance of the flange backs of a wheelset, mm.
    pub flange_back_distance_mm: f64,
    /// Distance of the running circle from the flange back, mm.
    #[serde(default = "running_circle_mm")]
    pub running_circle_mm: f64,
    /// Wavelength to which profiles from files are made smooth, mm; 0 leaves them as they are.
    #[serde(default = "profile_smoothing_mm")]
    pub profile_smoothing_mm: f64,
    /// Damping force over normal force for a speed of approach, s/m.
    pub damping_s_m: f64,
    /// Creep law with its friction.
    pub creep: CreepLaw,
}

/// EN 13848-1.
fn gauge_depth_mm() -> f64 {
    14.0
}

/// EN 13715.
fn running_circle_mm() -> f64 {
    70.0
}

/// As `hotfoot profile` has it.
fn profile_smoothing_mm() -> f64 {
    4.0
}

/// A car body or a bogie frame.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
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
    /// Centre of mass: y from the centre line, to the right, m.
    #[serde(default)]
    pub y_m: f64,
    /// Centre of mass: height above the rails, m.
    pub height_m: f64,
}

/// A wheelset; its centre of mass is at the axle, at the height of the wheel radius.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Wheelset {
    /// Name that elements refer to.
    pub name: String,
    /// Mass, kg.
    pub mass_kg: f64,
    /// Moments of inertia about x, y (with the rotor reflected), z, kg m².
    pub inertia_kg_m2: [f64; 3],
    /// Position along the vehicle: x from its middle, m.
    pub x_m: f64,
    /// Radius of the running circle, m.
    pub wheel_radius_m: f64,
    /// Body on which drive and brake react.
    pub frame: String,
    /// Whether the drive acts on it.
    #[serde(default)]
    pub powered: bool,
}

impl Multibody {
    /// Sum of the masses, kg.
    pub fn mass(&self) -> f64 {
        let bodies: f64 = self.body.iter().map(|body| body.mass_kg).sum();
        let wheelsets: f64 = self.wheelset.iter().map(|wheelset| wheelset.mass_kg).sum();
        bodies + wheelsets
    }
}
