//! Rigid bodies and the frames that follow the track.
//!
//! | file | part |
//! |---|---|
//! | `frame.rs` | the frame at one chainage, and how two frames lie to each other |
//! | `rigid_body.rs` | a body in its frame, with the frame's inertia forces |

pub mod frame;
pub mod rigid_body;

pub use frame::{Frame, Placement};
pub use rigid_body::{BodyState, RigidBody, Seen, Wrench};
