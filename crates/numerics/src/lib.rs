//! Small numerical building blocks of the models; nothing here allocates in a step.
//!
//! | file | part |
//! |---|---|
//! | `constants.rs` | gravity, radiation and units |
//! | `table.rs` | piecewise linear tables with a cached index |
//! | `piecewise.rs` | straight lines or cubic splines between points, and steps |
//! | `time.rs` | times as people read them |

pub mod constants;
mod piecewise;
mod table;
mod time;

pub use piecewise::{Interpolation, Piecewise};
pub use table::{LinearTable, TableError, interval};
pub use time::seconds;
