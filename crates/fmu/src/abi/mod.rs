//! The C interface: functions over a model type.
//!
//! [`export!`](crate::export) gives them their C names. They turn pointers into Rust values and results into statuses; what a call does is in
//! [`Instance`](crate::Instance). No panic leaves them.
//!
//! # Safety
//! All functions ask of their caller what the standard asks of a simulation tool:
//! - a component is one that `instantiate` of the same model gave and that was not freed, and no
//!   other call uses it at the same time;
//! - an FMU state is one that the same FMU gave and that was not freed;
//! - a pointer that is not null points to as many readable or writable elements as the argument
//!   for their number says, and a text ends with a NUL.
//!
//! Null pointers are refused with a message, unless the standard gives them a meaning.
#![allow(unsafe_code, reason = "C passes pointers; this module turns them into safe values")]
#![allow(
    clippy::missing_safety_doc,
    reason = "all functions have the contract stated for the module"
)]

mod callback;
mod component;
mod describe;
mod exchange;
mod export;
mod life_cycle;
mod pointers;
mod resource_location;
mod state;
mod status;

pub use callback::CallbackFunctions;
pub use describe::*;
pub use exchange::*;
pub use life_cycle::*;
pub use state::*;
pub use status::*;
