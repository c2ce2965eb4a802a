//! Why a system cannot be read, written or run.

use crate::files::archive::ArchiveError;
use crate::files::file_error::FileError;
use crate::files::xml_depth::TooDeep;
use crate::fmi::ImportError;
use crate::fmi::pack::PackError;
use crate::system::unit::UnitError;

/// Why a system cannot be read, written or run.
#[derive(Debug, thiserror::Error)]
pub enum SspError {
    /// The package is damaged or unsafe.
    #[error(transparent)]
    Archive(#[from] ArchiveError),
    /// A file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A file of the package is not XML.
    #[error("{file} is not XML: {source}")]
    Syntax {
        /// File in the package.
        file: String,
        /// Reason, with line and column.
        source: roxmltree::Error,
    },
    /// The elements of a file lie too deep in each other.
    #[error("{file}, {source}")]
    Depth {
        /// File in the package.
        file: String,
        /// Where.
        source: TooDeep,
    },
    /// An element or attribute is missing or wrong.
    #[error("{file}, line {line}: {message}")]
    Wrong {
        /// File in the package.
        file: String,
        /// Line of the element.
        line: u32,
        /// What is wrong and what would be right.
        message: String,
    },
    /// The structure does not fit the FMUs, a sentence for each problem.
    #[error("{file} cannot be run: {}", problems.join("; "))]
    Unfit {
        /// Package.
        file: String,
        /// What does not fit.
        problems: Vec<String>,
    },
    /// Files for the package cannot be put together.
    #[error(transparent)]
    Pack(#[from] PackError),
    /// An FMU cannot be imported.
    #[error(transparent)]
    Import(#[from] ImportError),
    /// A component refuses.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// The XML cannot be written.
    #[error("SystemStructure.ssd: {0}")]
    Xml(#[from] serde_xml_rs::Error),
}
