//! Contact of one wheel with one rail: where they touch, how hard, and what friction does.
//!
//! | part | what it answers | source |
//! |---|---|---|
//! | [`WheelProfile`], [`RailProfile`] | the shape of wheel and rail | EN 13715, EN 13674-1 |
//! | [`ProfileFile`] | what was understood of a file of points | ISO 16610-31 for smoothing |
//! | [`GeometryTable`] | where a wheel touches at a lateral shift, made once for a [`ProfilePair`] | quasi-elastic search |
//! | [`wheelset_geometry`] | both wheels of a rolled wheelset at once, for validation | rigid wheelset |
//! | [`EquivalentConicity`] | the cone with the same wavelength | EN 15302 |
//! | [`hertz`] | size and stiffness of the contact ellipse | Hertz, exact |
//! | [`kalker`] | creep coefficients | Kalker 1990 |
//! | [`CreepLaw`] | creep forces and friction power | Kalker 1990, Spiryagin 2013, Polach 2005 |
//! | [`rolling`] | the theory behind it, solved to make its table | Kalker 1990 |
//! | [`flash`] | temperature of the surface | Carslaw and Jaeger |
//!
//! One wheel is seen in the plane across the track. `lateral` is positive towards the field side
//! (away from the track's middle) on wheel and rail alike, heights are positive downwards. So the
//! same table serves the left and the right wheel, and a mirrored pair of wheels gives mirrored
//! numbers bit by bit.
//!
//! A step needs only [`GeometryTable::patch`], [`PatchAt::pressed`], [`ContactPoint::pressed`] and
//! [`CreepLaw::force`]; none of them allocates, locks or fails.

mod creep;
mod error;
pub mod flash;
mod geometry;
pub mod hertz;
pub mod kalker;
mod material;
mod profile;
pub mod rolling;

pub use creep::exact_rolling::ExactRolling;
pub use creep::flexibility::Reduction;
pub use creep::friction::{FallingFriction, Friction};
pub use creep::friction_by_temperature::FrictionByTemperature;
pub use creep::law::CreepLaw;
pub use creep::modified_fastsim::ModifiedFastsim;
pub use creep::polach::Polach;
pub use creep::{
    CreepDamping, CreepForces, Creepages, REFERENCE_SPEED_MIN, SlipVelocity, TangentialForce,
};
pub use error::ContactError;
pub use geometry::conicity::EquivalentConicity;
pub use geometry::contact_point::{ContactPatch, ContactPoint};
pub use geometry::pair::ProfilePair;
pub use geometry::patch_at::{PatchAt, PressedPatch, RowPosition, WheelPosition};
pub use geometry::table::GeometryTable;
pub use geometry::wheelset::{
    Roll, WheelContact, WheelsetGeometry, WheelsetPairs, wheelset_geometry,
};
pub use material::{Material, STEEL};
pub use profile::cone::Cone;
pub use profile::file::{ProfileFile, ProfileFormat, Reading, Roughness};
pub use profile::kind::ProfileKind;
pub use profile::point::ProfilePoint;
pub use profile::points::PointProfile;
pub use profile::rail::RailProfile;
pub use profile::wheel::WheelProfile;
