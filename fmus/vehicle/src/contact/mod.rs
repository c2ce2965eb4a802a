//! A wheel on its rail: where it touches, how hard it presses, how it slips.
//!
//! | file | part |
//! |---|---|
//! | `wheel_motion.rs` | how a wheel of a wheelset moves over its rail |
//! | `wheel.rs` | the contacts in which a wheel touches |
//! | `patch.rs` | one contact: approach, normal force, slip |
//! | `rows.rs` | how a contact moves with its wheelset, and how its forces act on it |
//! | `slip_mobility.rs` | how much of creep counts at the end of a step |
//! | `end_forces.rs` | forces of a contact at the end of a step, and their heat |
//! | `contact_output.rs` | what the FMU shows of a contact |
//! | `wheel_output.rs` | what a wheel does to its rail at the end of a step |
//! | `six.rs` | algebra of a wheelset's six velocities |

pub mod contact_output;
pub mod end_forces;
pub mod patch;
pub mod rows;
pub mod six;
pub mod slip_mobility;
pub mod wheel;
pub mod wheel_motion;
pub mod wheel_output;

pub use contact_output::ContactOutput;
pub use patch::Patch;
pub use wheel::{PATCHES, Standing, Wheel};
pub use wheel_motion::{Side, WheelData, WheelMotion};
pub use wheel_output::WheelOutput;
