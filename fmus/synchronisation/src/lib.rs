//! The controller that keeps one vehicle at its place in the train, as a model of its own, so
//! that a system of FMUs is complete without Hotfoot's master.
//!
//! The law stands in the crate `controller`, which the master uses too; here is only the way
//! from the FMU's variables to it and back (`interface.rs`).

mod interface;

pub use interface::{Signals, Synchronisation};
