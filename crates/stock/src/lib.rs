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
//! | `multibody/` | its section for the three-dimensional model |
//! | `draft_gear/` | the draft-gear file, and the forces over deflections that it comes down to |
//! | `consist.rs` | the consist file: the vehicles of a train in order |

mod brake;
mod consist;
mod curve_resistance;
mod draft_gear;
mod library;
mod multibody;
mod propulsion;
mod resistance;
mod vehicle;

pub use brake::{
    AirBrake, Brake, BrakeControl, FractionByTime, HandBrake, LocomotiveBrake, Reservoir,
};
pub use consist::{Consist, Member};
pub use curve_resistance::{CurveFormula, CurveTable};
pub use draft_gear::{Characteristic, DraftGear, ForceCurve, Orifice, Wedge};
pub use library::Library;
pub use multibody::{
    Body, CentrePlate, CouplerAttachment, CreepLaw, CreepLawKind, Damper, Direction, Friction,
    Multibody, Rod, RotationalSpring, SideBearer, Spring, Stop, TabulatedSpring,
    Wedge as FrictionWedge, WheelRailContact, Wheelset,
};
pub use propulsion::{
    Between, DynamicBrake, EffortByNotch, EffortBySpeed, NOTCHES, Traction, ValueBySpeed,
};
pub use resistance::{Resistance, ResistanceFormula};
pub use vehicle::{Coupler, RearCoupler, Vehicle};
