//! The rail's cross-section: from its dimensions to the modes in which it conducts heat.
//!
//! | file | part |
//! |---|---|
//! | `file.rs` | the rail file in `stock/rails`: dimensions and their source |
//! | `outline.rs` | the outline as a polygon, its area, centroid and second moment |
//! | `clip.rs` | what of a polygon lies in a rectangle |
//! | `cells.rs` | cut cells with capacities, conductances and pieces of surface |
//! | `modes.rs` | the slowest modes of conduction and cooling |
//! | `propagator.rs` | one exact step of the modes |
//! | `running_surface.rs` | which pieces of the outline are the running surface |
//! | `crown.rs` | where on the head a contact's heat goes |
//! | `readings.rs` | where in the section the rise is read |
//!
//! Coordinates: y across the rail to the right of its middle, z downwards from the crown.

mod cells;
mod clip;
mod crown;
mod file;
mod modes;
mod outline;
mod propagator;
mod readings;
mod running_surface;

pub use cells::{Cell, Cells, Facet, Link};
pub use crown::Crown;
pub use file::RailFile;
pub use modes::{LANES, Modes, NoModes, add, dot};
pub use outline::{Outline, Point, Properties};
pub use propagator::Propagator;
pub use readings::Readings;
pub use running_surface::{crown_band, crown_piece, running_surface};
