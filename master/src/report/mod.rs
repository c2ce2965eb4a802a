//! The report of a run: one self-contained page with the main figures and the paper's figures
//! 8 to 12 (Bosomworth et al. 2018), or of a system's run with what its components gave.
//!
//! | file | part |
//! |---|---|
//! | `data.rs` | what the report shows |
//! | `facts.rs` | what the run itself adds to the results: the part `[run]` of the manifest |
//! | `collect.rs` | reads it from the folder of a run |
//! | `main_figures.rs` | the table of main figures |
//! | `output_figures.rs` | what the run says of further outputs that were recorded |
//! | `rail_figures.rs` | what the run says of each rail |
//! | `quantity.rs` | numbers with SI prefixes |
//! | `figures.rs` | the figures with curves |
//! | `palette.rs` | colours of lines and of heat |
//! | `line_chart.rs` | curves over time or chainage, as SVG |
//! | `heat_by_source.rs` | heat per metre by source, as bars |
//! | `heat_map.rs` | temperature rise over chainage and depth, as a picture with axes |
//! | `page.rs` | the page, from `templates/report.html` |
//! | `system.rs` | the page of a system of which nothing is known but its variables |
//! | `write.rs` | all of it: from a results folder to `report.html` |
//!
//! The page refers to nothing outside itself: drawings are inline SVG, pictures are data URIs.

mod collect;
mod data;
mod facts;
mod figures;
mod heat_by_source;
mod heat_map;
mod line_chart;
mod main_figures;
mod output_figures;
mod page;
mod palette;
mod quantity;
mod rail_figures;
mod system;
mod write;

#[cfg(test)]
mod invented;
#[cfg(test)]
mod system_tests;
#[cfg(test)]
mod tests;

use crate::files::file_error::FileError;
use crate::recording::RecordingError;

use collect::collect;
pub use data::MainFigure;
pub use facts::{EnergyLine, RailFacts, RunFacts};
use page::render;
pub use system::{ComponentFacts, SystemFacts};
pub use write::write;

/// Why a report cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A series cannot be read.
    #[error(transparent)]
    Series(#[from] RecordingError),
    /// A file cannot be read or written, or the manifest is not what a run writes.
    #[error(transparent)]
    File(#[from] FileError),
    /// A figure cannot be drawn.
    #[error("figure \"{figure}\": {reason}")]
    Drawing {
        /// Its title.
        figure: String,
        /// Reason.
        reason: String,
    },
    /// The page cannot be made from its template.
    #[error("report page: {0}")]
    Page(#[from] minijinja::Error),
}
