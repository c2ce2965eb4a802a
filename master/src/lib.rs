//! The master of Hotfoot: runs a train, its vehicles and a rail as FMI 2.0 co-simulation FMUs in
//! lockstep. It knows FMUs only by their interface.
//!
//! | place | part |
//! |---|---|
//! | `scenario/` | the scenario file |
//! | `prepare.rs`, `resources.rs`, `pack.rs` | from a scenario to wired units |
//! | `fmi/`, `interface.rs`, `archive.rs` | import of FMUs |
//! | `unit.rs`, `port.rs`, `roles.rs`, `si.rs` | models, the signals they exchange, their roles, and units of measurement |
//! | `start.rs`, `lockstep.rs`, `rail.rs`, `parallel.rs` | initialisation and the step loop |
//! | `synchronisation.rs` | gains of the controllers that keep vehicles at their place |
//! | `run.rs`, `observe.rs`, `progress.rs`, `times.rs`, `manifest.rs` | a run and what is kept of it |
//! | `recording/`, `report/` | series files and the report |
//! | `ssp/` | systems of FMUs in SSP packages: export of a train, and runs of any system |
//! | `commands.rs` | the commands of the program |

mod archive;
pub mod commands;
mod fmi;
mod interface;
mod lockstep;
mod manifest;
mod observe;
mod pack;
mod parallel;
mod port;
mod prepare;
mod progress;
mod rail;
pub mod recording;
mod report;
mod resources;
pub mod roles;
mod run;
pub mod scenario;
mod si;
pub mod ssp;
mod start;
mod synchronisation;
mod times;
mod unit;

#[cfg(test)]
mod lockstep_tests;
#[cfg(test)]
mod mock;

pub use fmi::{FmuInstance, Import};
pub use interface::Interface;
pub use lockstep::{Clock, Lockstep, Train, Vehicle};
pub use parallel::pool;
pub use port::{Port, Signal};
pub use prepare::{Folders, prepare};
pub use rail::Rail;
pub use roles::Role;
pub use run::{Options, RunError, run};
pub use unit::{Unit, UnitError};
