//! A train as a system: from a scenario to a structure.
//!
//! | file | part |
//! |---|---|
//! | `roles/` | what an FMU must or may have to be a train, a vehicle or a rail |
//! | `wiring.rs` | the table of what flows between them |
//! | `structure.rs`, `vehicles.rs`, `rails.rs`, `layout.rs` | the components of a scenario, and who is what |
//! | `fmus.rs`, `resources.rs`, `parameters.rs` | FMUs packed for the scenario, and their parameters |
//! | `controller.rs` | the controller of a vehicle |
//! | `follow.rs`, `following.rs` | vehicles whose FMUs have failed and which follow the train |
//! | `limits.rs` | the physical bounds of the roles, told to the parts that fill them |
//! | `locomotives.rs` | which vehicles are locomotives |
//! | `signals.rs` | signals of the train by name |
//! | `wheels_outside.rs` | what is wrong with the run before its first step |
//! | `traffic.rs`, `tape.rs` | what the rails go through after the run |

pub mod controller;
pub mod error;
pub mod fmus;
mod follow;
mod following;

pub mod layout;
mod limits;
pub mod locomotives;
mod parameters;
pub mod rails;
pub mod resources;
pub mod roles;
mod signals;
pub mod structure;
pub mod tape;
pub mod traffic;
mod vehicles;
pub mod wheels_outside;
mod wiring;

#[cfg(test)]
mod wiring_tests;
