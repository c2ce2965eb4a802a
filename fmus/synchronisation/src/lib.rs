//! The controller that keeps a vehicle model in step with the train model, as a model of its own.
//!
//! With it a system of FMUs is complete without Hotfoot's master.
//!
//! The law stands in the crate `controller`, which the master uses too. Here are the FMU's variables
//! (`signals.rs`), and how a step takes and gives them (`interface.rs`).

mod interface;
mod signals;

pub use interface::Synchronisation;
pub use signals::{Force, Gains, Motion, Signals};
