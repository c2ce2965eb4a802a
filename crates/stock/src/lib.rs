//! Rolling-stock files: what people write about vehicles, draft gears and trains.
//!
//! A [`Library`] is a folder with one file a vehicle type in `vehicles/` and one file a draft gear
//! in `draft_gears/`. A vehicle file holds the longitudinal and the multibody data of its type, so
//! that masses and lengths cannot disagree between the models. Numbers keep the units of the
//! file, which stand at the end of each key; the models convert them once.
//!
//! | file | part |
//! |---|---|
//! | `library.rs` | the folder of files; a vehicle that extends another |
//! | `vehicle.rs` | the vehicle file |
//! | `resistance.rs`, `curve_resistance.rs` | its section on propulsion and curve resistance |
//! | `propulsion.rs` | its sections on traction and dynamic brake |
//! | `brake.rs` | its sections on friction brakes |
//! | `multibody.rs` | its section for the three-dimensional model; `multibody_check.rs` checks it |
//! | `creep.rs` | the creep law of that section |
//! | `profile_files.rs` | its profiles that are files of points |
//! | `elements.rs` | the force elements of that section; `elements_check.rs` checks them |
//! | `gear_file.rs`, `wedge.rs` | the draft-gear file |
//! | `draft_gear.rs`, `force_curve.rs` | what it comes down to: forces over deflections |
//! | `consist.rs` | the consist file: the vehicles of a train in order |
//! | `check.rs` | what a value must be, and the error that says so |

mod brake;
mod check;
mod consist;
mod creep;
mod curve_resistance;
mod draft_gear;
mod elements;
mod elements_check;
mod force_curve;
mod gear_file;
mod library;
mod multibody;
mod multibody_check;
mod profile_files;
mod propulsion;
mod resistance;
mod vehicle;
mod wedge;

pub use brake::{
    AirBrake, Brake, BrakeControl, FractionByTime, HandBrake, LocomotiveBrake, Reservoir,
};
pub use check::{Check, StockError};
pub use consist::{Consist, Member};
pub use creep::{CreepLaw, CreepLawKind};
pub use curve_resistance::{CurveFormula, CurveTable};
pub use draft_gear::{Characteristic, DraftGear, Orifice};
pub use elements::{
    CentrePlate, Damper, Direction, Friction, Rod, RotationalSpring, SideBearer, Spring, Stop,
    TabulatedSpring, Wedge as FrictionWedge,
};
pub use force_curve::ForceCurve;
pub use library::{Library, read_toml};
pub use multibody::{Body, CouplerAttachment, Multibody, WheelRailContact, Wheelset};
pub use propulsion::{
    Between, DynamicBrake, EffortByNotch, EffortBySpeed, NOTCHES, Traction, ValueBySpeed,
};
pub use resistance::{Resistance, ResistanceFormula};
pub use vehicle::{Coupler, RearCoupler, Vehicle};
pub use wedge::Wedge;
