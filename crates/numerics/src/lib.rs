//! Small numerical building blocks of the models; nothing here allocates in a step.
//!
//! | file | part |
//! |---|---|
//! | `table.rs` | piecewise linear tables with a cached index |

mod table;

pub use table::{LinearTable, TableError, interval};
