//! The master of Hotfoot: runs a train, its vehicles and a rail as FMI 2.0 co-simulation FMUs in
//! lockstep. It knows FMUs only by their interface. The program is the package `cli`.
//!
//! | room | part |
//! |---|---|
//! | `scenario/` | the scenario file |
//! | `train/` | from a scenario to wired units, and their steps |
//! | `system/` | models, the signals they exchange, structures of them |
//! | `run/` | a run and what is kept of it |
//! | `ssp/` | systems of FMUs in SSP packages: export of a train, and runs of any system |
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

pub use files::archive;
pub use fmi::{FmuInstance, Import, pack, watch_crashes};
pub use interface::Interface;
pub use run::error::RunError;
pub use system::parallel::pool;
pub use system::port::{Port, Signal};
pub use system::unit::{Unit, UnitError};
pub use train::lockstep::{Clock, Lockstep, Train, Vehicle};
pub use train::prepare::{Folders, prepare};
pub use train::rail::Rail;
pub use train::roles;
pub use train::roles::Role;
