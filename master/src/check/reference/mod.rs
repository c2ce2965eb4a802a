//! The reference result that an FMU carries: a short run whose result tells whether the FMU does
//! on another machine what it did where it was made.
//!
//! | file | part |
//! |---|---|
//! | `experiment.rs` | how the run is made |
//! | `table.rs` | inputs and results: CSV with the time in the first column |
//! | `files.rs` | the files inside of an FMU, listed by a manifest |
//! | `run.rs` | the run |
//! | `compare.rs` | a run against the result of an earlier one |
//!
//! The files lie in the FMU's folder `extra`, where the layered standard FMI-LS-REF puts them, as
//! the Reference FMUs of the Modelica Association have it. Their results have no experiment
//! beside them and stand for the default experiment.

mod compare;
mod experiment;
mod files;
mod run;
mod table;

use std::path::{Path, PathBuf};

use crate::files::file_error::FileError;
use crate::fmi::ImportError;
use crate::system::unit::UnitError;

pub use compare::{Verdict, compare};
pub use experiment::Experiment;
pub use files::pack;

/// Why a reference result cannot be made or replayed.
#[derive(Debug, thiserror::Error)]
pub enum ReferenceError {
    /// The FMU has no reference result.
    #[error("{0} carries no reference result (extra/org.fmi-standard.fmi-ls-ref)")]
    None(PathBuf),
    /// A file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// The experiment cannot be read, or makes no sense.
    #[error(transparent)]
    Experiment(#[from] ::files::Mistake),
    /// A file does not hold what it should.
    #[error("{file}: {problem}")]
    Content {
        /// File.
        file: PathBuf,
        /// What is wrong, and what would be right.
        problem: String,
    },
    /// The FMU has no such variable.
    #[error("{file}: the FMU has no {causality} `{name}`")]
    Variable {
        /// FMU.
        file: String,
        /// `input` or `output`.
        causality: &'static str,
        /// Name.
        name: String,
    },
    /// The FMU cannot be loaded.
    #[error(transparent)]
    Import(#[from] ImportError),
    /// The FMU fails.
    #[error(transparent)]
    Unit(#[from] UnitError),
}

impl ReferenceError {
    fn content(file: &Path, problem: impl ToString) -> Self {
        Self::Content { file: file.to_owned(), problem: problem.to_string() }
    }
}
