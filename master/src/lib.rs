//! The master of Hotfoot: runs a train, its vehicles and a rail as FMI 2.0 co-simulation FMUs in
//! lockstep. It knows FMUs only by their interface. The program is the package `cli`.
//!
//! | place | part |
//! |---|---|
//! | `scenario/` | the scenario file |
//! | `prepare.rs`, `prepare_vehicles.rs`, `prepare_rail.rs`, `parameters.rs`, `resources.rs` | from a scenario to wired units |
//! | `pack.rs`, `documentation.rs` | FMUs are packed |
//! | `fmi/`, `interface.rs`, `archive.rs` | import of FMUs |
//! | `check/` | the rules of FMI 2.0 for an FMU |
//! | `reference/` | the reference result that an FMU carries as a self-test |
//! | `unit.rs`, `port.rs`, `roles.rs`, `si.rs` | models, the signals they exchange, their roles, and units of measurement |
//! | `start.rs`, `lockstep.rs`, `rail.rs`, `parallel.rs` | initialisation and the step loop |
//! | `foresee.rs` | what is wrong with the run before its first step |
//! | `traffic.rs`, `tape.rs` | what the rails go through after the run |
//! | `synchronisation.rs` | gains of the controllers that keep vehicles at their place |
//! | `run.rs`, `stepping.rs`, `finished.rs`, `observe.rs`, `observe_rail.rs`, `observe_outputs.rs`, `name_pattern.rs`, `progress.rs`, `times.rs`, `manifest.rs` | a run and what is kept of it |
//! | `workplace.rs`, `error.rs`, `file_error.rs` | threads and the folder of a run, and why it failed |
//! | `recording/`, `report/` | series files and the report |
//! | `expected.rs` | the figures of a run against those expected of its scenario |
//! | `ssp/` | systems of FMUs in SSP packages: export of a train, and runs of any system |

pub mod archive;
pub mod check;
mod documentation;
mod error;
pub mod expected;
mod file_error;
mod finished;
mod fmi;
mod foresee;
mod interface;
mod lockstep;
mod manifest;
mod name_pattern;
mod observe;
mod observe_outputs;
mod observe_rail;
pub mod pack;
mod parallel;
mod parameters;
mod port;
mod prepare;
mod prepare_rail;
mod prepare_vehicles;
mod progress;
mod rail;
pub mod recording;
pub mod reference;
pub mod report;
mod resources;
pub mod roles;
pub mod run;
pub mod scenario;
mod si;
pub mod ssp;
mod start;
mod stepping;
mod synchronisation;
mod tape;
mod times;
mod traffic;
mod unit;
pub mod workplace;

#[cfg(test)]
mod lockstep_tests;
#[cfg(test)]
mod mock;

pub use error::RunError;
pub use fmi::{FmuInstance, Import, watch_crashes};
pub use interface::Interface;
pub use lockstep::{Clock, Lockstep, Train, Vehicle};
pub use parallel::pool;
pub use port::{Port, Signal};
pub use prepare::{Folders, prepare};
pub use rail::Rail;
pub use roles::Role;
pub use unit::{Unit, UnitError};
