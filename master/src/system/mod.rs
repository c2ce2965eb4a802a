//! Systems of units: models, the signals that they exchange, and what they are connected by.
//!
//! | file | part |
//! |---|---|
//! | `unit.rs`, `port.rs` | a model, and groups of its variables |
//! | `structure.rs` | components and connections |
//! | `links.rs` | connections, compiled |
//! | `step.rs` | initialisation and steps |
//! | `parallel.rs`, `times.rs` | threads and wall time |

pub mod links;
pub mod parallel;
pub mod port;
pub mod step;
pub mod structure;
pub mod times;
pub mod unit;

#[cfg(test)]
pub mod mock;
#[cfg(test)]
mod step_tests;
