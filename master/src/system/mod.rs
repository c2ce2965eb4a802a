//! Systems of units: what they consist of, how they are connected, and the one loop that steps them.
//! Nothing here knows trains.
//!
//! | file | part |
//! |---|---|
//! | `structure.rs` | what a system consists of: components, connections, start values, schedule |
//! | `unit.rs`, `signals.rs`, `part.rs` | a model, groups of its variables, and both in a system |
//! | `checks.rs`, `motion.rs` | whether values that units give can be |
//! | `compile.rs`, `links.rs` | from a structure and its units to a system |
//! | `start.rs` | the initialisation |
//! | `step.rs`, `clock.rs`, `parallel.rs`, `times.rs` | the step |
//! | `substitute.rs` | a model of the caller's in place of a component's |
//! | `tap.rs` | signals by name |
//! | `drawing.rs` | a structure as a person would draw it |

pub mod checks;
pub mod clock;
pub mod compile;
mod drawing;
pub mod links;
mod motion;
pub mod parallel;
pub mod part;
pub mod signals;
pub mod start;
pub mod step;
pub mod structure;
pub mod substitute;
pub mod tap;
pub mod times;
pub mod unit;

#[cfg(test)]
pub mod mock;
#[cfg(test)]
mod step_tests;
