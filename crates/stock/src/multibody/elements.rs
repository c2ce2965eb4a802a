//! The force elements of the `[multibody]` section.
//!
//! An element joins two bodies, the first and the second of `between`. Points are given as in
//! `multibody.rs`; there is one element of the kind at each point. The equations are those of
//! `docs/theory/vehicle/suspension.md`.

use schemars::JsonSchema;
use serde::Deserialize;

/// Springs of one kind between two bodies, one at each point, each with its damping in parallel.
///
/// A spring has no length; it carries its share of the weight when the vehicle stands at its
/// given heights.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
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
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
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
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
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
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
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

/// Springs with a table of force over displacement, one at each point between two bodies.
///
/// Such are progressive bump stops. A table that begins at displacement zero holds for both directions.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct TabulatedSpring {
    /// Name for messages.
    pub name: String,
    /// The two bodies.
    pub between: [String; 2],
    /// Points x, y, height above the rails, m.
    pub points_m: Vec<[f64; 3]>,
    /// Direction in which it acts.
    pub direction: Direction,
    /// Displacements of the second body against the first from rest, mm, rising.
    ///
    /// The last slopes go on outside.
    pub displacement_mm: Vec<f64>,
    /// Forces that push the second body back, N.
    pub force_n: Vec<f64>,
    /// Damping in parallel, N s/m.
    #[serde(default)]
    pub damping_n_s_m: f64,
}

/// A spring against the rotation of two bodies, such as an anti-roll bar (roll alone).
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct RotationalSpring {
    /// Name for messages.
    pub name: String,
    /// The two bodies.
    pub between: [String; 2],
    /// Stiffness in roll, pitch, yaw, N m/rad.
    pub stiffness_n_m_rad: [f64; 3],
    /// Damping in roll, pitch, yaw, N m s/rad.
    #[serde(default)]
    pub damping_n_m_s_rad: [f64; 3],
}

/// A rod with a joint at either end, which acts along the line between them.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Rod {
    /// Name for messages.
    pub name: String,
    /// The two bodies.
    pub between: [String; 2],
    /// Its joint on the first and its joint on the second body: x, y, height above the rails, m.
    pub ends_m: [[f64; 3]; 2],
    /// Stiffness along it, N/m.
    pub stiffness_n_m: f64,
    /// Damping along it, N s/m.
    #[serde(default)]
    pub damping_n_s_m: f64,
}

/// Dry friction between two bodies, one at each point.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Friction {
    /// Name for messages.
    pub name: String,
    /// The two bodies.
    pub between: [String; 2],
    /// Points x, y, height above the rails, m.
    pub points_m: Vec<[f64; 3]>,
    /// Direction in which it acts.
    pub direction: Direction,
    /// Friction force while sliding, N.
    pub force_n: f64,
    /// Stiffness while it sticks, N/m.
    pub stick_stiffness_n_m: f64,
}

/// Friction wedges between a bolster (first) and a side frame (second), one at each point.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Wedge {
    /// Name for messages.
    pub name: String,
    /// The bolster and the side frame.
    pub between: [String; 2],
    /// Points x, y, height above the rails, m.
    pub points_m: Vec<[f64; 3]>,
    /// Angle of the face on the bolster against the vertical, degrees.
    pub angle_deg: f64,
    /// Friction coefficient on the column of the side frame.
    pub friction: f64,
    /// Force of the wedge's spring at rest, N.
    pub spring_force_n: f64,
    /// Stiffness of the wedge's spring, N/m.
    pub spring_stiffness_n_m: f64,
    /// Stiffness along the column while it sticks, N/m.
    pub stick_stiffness_n_m: f64,
}

/// A flat round plate on which a body (first) rests and turns on its bolster (second).
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct CentrePlate {
    /// Name for messages.
    pub name: String,
    /// The body and the bolster.
    pub between: [String; 2],
    /// Its middle: x, y, height above the rails, m.
    pub point_m: [f64; 3],
    /// Radius, m.
    pub radius_m: f64,
    /// Stiffness in x and y, of the ring that holds it, and in z, of the plate, N/m.
    pub stiffness_n_m: [f64; 3],
    /// Damping in x, y, z, N s/m.
    #[serde(default)]
    pub damping_n_s_m: [f64; 3],
    /// Friction coefficient.
    pub friction: f64,
    /// Stiffness against yaw while it sticks, N m/rad.
    pub stick_stiffness_n_m_rad: f64,
}

/// Constant-contact side bearers between a body (first) and its bolster (second), one at each
/// point.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct SideBearer {
    /// Name for messages.
    pub name: String,
    /// The body and the bolster.
    pub between: [String; 2],
    /// Points x, y, height above the rails, m.
    pub points_m: Vec<[f64; 3]>,
    /// Vertical force at rest, N.
    pub preload_n: f64,
    /// Vertical stiffness, N/m.
    pub stiffness_n_m: f64,
    /// Compression from rest at which it is solid, mm.
    pub solid_gap_mm: f64,
    /// Vertical stiffness when solid, N/m.
    pub solid_stiffness_n_m: f64,
    /// Friction coefficient in the plane.
    pub friction: f64,
    /// Stiffness in the plane while it sticks, N/m.
    pub stick_stiffness_n_m: f64,
}
