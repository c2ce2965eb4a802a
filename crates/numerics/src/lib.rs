//! Small numerical building blocks of the models; nothing here allocates in a step.
//!
//! | file | part |
//! |---|---|
//! | `table.rs` | piecewise linear tables with a cached index |
//! | `piecewise.rs` | straight lines or cubic splines between points, and steps |

mod piecewise;
mod table;

pub use piecewise::{Interpolation, Piecewise};
pub use table::{LinearTable, TableError, interval};
