//! A train: from a scenario to wired units, and their steps.
//!
//! | file | part |
//! |---|---|
//! | `prepare.rs`, `prepare_vehicles.rs`, `prepare_rail.rs`, `parameters.rs`, `resources.rs` | from a scenario to wired units |
//! | `roles/` | what an FMU must or may have to fill a role |
//! | `start.rs`, `lockstep.rs`, `rail.rs` | initialisation and the step loop |
//! | `foresee.rs` | what is wrong with the run before its first step |
//! | `traffic.rs`, `tape.rs` | what the rails go through after the run |
//! | `synchronisation.rs` | gains of the controllers |

pub mod foresee;
pub mod lockstep;
pub mod parameters;
pub mod prepare;
pub mod prepare_rail;
mod prepare_vehicles;
pub mod rail;
pub mod resources;
pub mod roles;
pub mod start;
mod synchronisation;
pub mod tape;
pub mod traffic;

#[cfg(test)]
mod lockstep_tests;
