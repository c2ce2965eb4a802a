//! Systems of FMUs in packages of SSP 1.0 (System Structure and Parameterization).
//!
//! | file | part |
//! |---|---|
//! | `read.rs`, `connect.rs`, `parameters.rs`, `xml.rs` | from the files of a package to it |
//! | `write.rs`, `elements.rs` | from it to a file that other tools accept |
//! | `export.rs`, `export_wiring.rs`, `export_parameters.rs`, `sources.rs` | a scenario's train as a package |
//! | `wire.rs` | from a structure to instances of FMUs with what flows between them |
//! | `record.rs`, `run.rs` | a run from a package to the results folder |
//! | `error.rs` | what can be wrong |

mod connect;
mod elements;
mod error;
mod export;
mod export_parameters;
mod export_wiring;
mod parameters;
mod read;
pub mod record;
mod run;
mod sources;
mod wire;
mod write;
mod xml;

#[cfg(test)]
mod structure_tests;

pub use error::SspError;
pub use export::export;
pub use run::{SystemOptions, run};
