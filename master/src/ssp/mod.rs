//! Systems of FMUs in packages of SSP 1.0 (System Structure and Parameterization): here is only how a
//! structure is read and written.
//!
//! | file | part |
//! |---|---|
//! | `package.rs`, `xml.rs` | the files of a package, and their elements |
//! | `read.rs`, `connect.rs`, `parameters.rs`, `values.rs`, `units.rs` | from them to a structure |
//! | `write.rs`, `elements.rs` | from it to a file that other tools accept |
//! | `schedule.rs` | Hotfoot's annotations: rates, stages and means, which other tools ignore |
//! | `open.rs` | the FMUs of a package, ready to run |
//! | `error.rs` | what can be wrong |

mod connect;
mod elements;
mod error;
mod open;
mod package;
mod parameters;
mod read;
mod schedule;
mod units;
mod values;
mod write;
mod xml;

#[cfg(test)]
mod structure_tests;

pub use error::SspError;
pub use open::{Imports, imports, leave_out_unmatched, open};
pub use read::{STRUCTURE_FILE, read};
pub use write::write;
