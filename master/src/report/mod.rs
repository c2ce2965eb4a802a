//! The report of a run: one self-contained page with the main figures and the paper's figures
//! 8 to 12 (Bosomworth et al. 2018), or of a system's run with what its components gave.
//!
//! | file | part |
//! |---|---|
//! | `data.rs` | what the report shows |
//! | `facts.rs` | what the run itself adds to the results: the part `[run]` of the manifest |
//! | `results.rs` | the results of a run, opened |
//! | `collect.rs` | reads from them what the report shows |
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
//! | `error.rs` | why a report cannot be made |
//!
//! The page refers to nothing outside itself: drawings are inline SVG, pictures are data URIs.

mod collect;
mod data;
mod error;
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
mod results;
mod system;
mod write;

#[cfg(test)]
mod drawing_tests;
#[cfg(test)]
mod invented;
#[cfg(test)]
mod system_tests;
#[cfg(test)]
mod tests;

pub use data::MainFigure;
pub use error::ReportError;
pub use facts::{EnergyLine, RailFacts, RunFacts};
pub use system::{ComponentFacts, SystemFacts};
pub use write::write;
