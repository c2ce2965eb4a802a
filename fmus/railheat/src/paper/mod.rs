//! `model = "paper"`: the model of the paper, one column of cells over the depth for each element.
//!
//! | file | part |
//! |---|---|
//! | `model.rs` | what happens in which order |
//! | `rail.rs` | all elements: grid, untouched rail, readings |
//! | `column.rs` | heat conduction over the depth |
//! | `running_surface.rs` | heat exchanged with the weather |
//! | `audit.rs` | where the heat came from and where it is |

mod audit;
mod column;
mod model;
mod rail;
mod running_surface;

pub use audit::Audit;
pub use column::{LANES, Unstable, conduct, fourier_number};
pub use model::{PaperModel, Parameters, State};
pub use rail::{Grid, Level, Rail, Sums, SurfaceStep};
pub use running_surface::RunningSurface;
