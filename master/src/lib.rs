//! The master of Hotfoot: runs a train, its vehicles and a rail as FMI 2.0 co-simulation FMUs in
//! lockstep. It knows FMUs only by their interface.
//!
//! | place | part |
//! |---|---|
//! | `scenario/` | the scenario file |
//! | `prepare.rs`, `resources.rs`, `pack.rs`, `documentation.rs` | from a scenario to wired units |
//! | `fmi/`, `interface.rs`, `archive.rs` | import of FMUs |
//! | `check/` | the rules of FMI 2.0 for an FMU |
//! | `reference/` | the reference result that an FMU carries as a self-test |
//! | `unit.rs`, `port.rs`, `roles.rs`, `si.rs` | models, the signals they exchange, their roles, and units of measurement |
//! | `start.rs`, `lockstep.rs`, `rail.rs`, `parallel.rs` | initialisation and the step loop |
//! | `synchronisation.rs` | gains of the controllers that keep vehicles at their place |
//! | `run.rs`, `observe.rs`, `progress.rs`, `times.rs`, `manifest.rs` | a run and what is kept of it |
//! | `recording/`, `report/` | series files and the report |
//! | `supervise.rs` | a run in a child process, which an FMU may crash |
//! | `commands.rs` | the commands of the program |

mod archive;
pub mod check;
pub mod commands;
mod documentation;
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
mod reference;
mod report;
mod resources;
pub mod roles;
mod run;
pub mod scenario;
mod si;
mod start;
mod supervise;
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
