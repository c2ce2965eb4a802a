//! The master of Hotfoot: runs a train, its vehicles and a rail as FMI 2.0 co-simulation FMUs in
//! lockstep. It knows FMUs only by their interface. The program is the package `cli`.
//!
//! A scenario and an SSP package both become a [`Structure`]: components and what flows between them.
//! One loop steps it (`system/step.rs`), and one run records it (`run/mod.rs`).
//!
//! | room | part |
//! |---|---|
//! | `scenario/` | the scenario file |
//! | `train/` | a train as a system: from a scenario to a structure, with one table of its wiring |
//! | `ssp/` | structures in SSP packages: read, written, and exported from a scenario |
//! | `system/` | structures, and the one loop that steps them |
//! | `run/` | a run and what is kept of it |
//! | `fmi/` | import and packing of FMUs |
//! | `interface/` | what an FMU's model description says, and units of measurement |
//! | `check/` | the rules of FMI 2.0 for an FMU, and the reference result that it carries |
//! | `recording/`, `report/` | series files and the report |
//! | `files/` | archives, and errors of files |

pub mod check;
mod files;
mod fmi;
mod interface;
pub mod recording;
pub mod report;
pub mod run;
pub mod scenario;
pub mod ssp;
mod system;
mod train;

pub use files::printable::printable;
pub use files::{archive, shipped, xml_text};
pub use fmi::{FmuInstance, Import, Manner, UNLOADING, note_unloading, pack, unit, watched};
#[cfg(target_os = "linux")]
pub use fmi::{WAITING, serve};
pub use interface::{Interface, Variable};
pub use run::error::RunError;
pub use run::{Finished, Options, run};
pub use system::checks::Checks;
pub use system::structure::{Home, Structure};
pub use system::substitute::{Substitute, Substitutes, Variables};
pub use system::unit::{Unit, UnitError};
pub use train::fmus::Folders;
pub use train::roles::{self, Role};
