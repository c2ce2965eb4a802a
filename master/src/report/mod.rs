//! The report of a run: one page that opens offline, with its answer, pictures, a linked view of all
//! that was recorded, and tables; or of a system's run with what its components gave.
//!
//! | file | part |
//! |---|---|
//! | `data.rs` | figures, rails and curves that it shows |
//! | `facts.rs`, `provenance.rs` | what the run itself adds to the results: parts of the manifest |
//! | `results.rs` | the results of a run, opened |
//! | `collect.rs` | all that it shows, read from them |
//! | `main_figures.rs` | the table of main figures |
//! | `output_figures.rs` | what the run says of further outputs that were recorded |
//! | `speed_limits.rs` | where the train exceeds a speed limit |
//! | `rail_figures.rs` | what the run says of each rail |
//! | `verdict.rs`, `limits.rs` | the answer in sentences, and limits that it is judged by |
//! | `instrument/` | the numbers of the linked view |
//! | `script.rs` | the scripts that draw it, from `templates/instrument` |
//! | `quantity.rs` | numbers with SI prefixes |
//! | `figures.rs` | the pictures of the first screen |
//! | `palette.rs` | colours and patterns of lines |
//! | `line_chart.rs` | curves over time, as SVG |
//! | `heat_by_source.rs` | heat per metre by source, as bars |
//! | `wall_times.rs` | where the wall time went |
//! | `page.rs` | the page, from `templates/report.html` |
//! | `system.rs` | the page of a system of which nothing is known but its variables |
//! | `write.rs` | all of it: from a results folder to `report.html` |
//! | `compare/` | runs and measurements beside each other |
//! | `error.rs` | why a report cannot be made |
//!
//! The page refers to nothing outside itself: drawings are inline SVG or drawn by inline scripts.

mod collect;
pub mod compare;
mod data;
mod error;
mod facts;
mod figures;
mod heat_by_source;
mod instrument;
mod limits;
mod line_chart;
mod main_figures;
mod output_figures;
mod page;
mod palette;
mod provenance;
mod quantity;
mod rail_figures;
mod results;
mod script;
mod speed_limits;
mod system;
mod verdict;
mod wall_times;
mod write;

#[cfg(test)]
mod drawing_tests;
#[cfg(test)]
mod full_size_tests;
#[cfg(test)]
mod invented;
#[cfg(test)]
mod system_tests;
#[cfg(test)]
mod tests;

pub use data::MainFigure;
pub use error::ReportError;
pub use facts::{EnergyLine, Limit, LimitFacts, RailFacts, RunFacts, TrackFacts};
pub use provenance::UnitFacts;
pub use system::{ComponentFacts, SystemFacts};
pub use write::write;
