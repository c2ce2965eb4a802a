//! What the line does to every vehicle alike.
//!
//! | file | part |
//! |---|---|
//! | `local_line.rs` | gradient, elevation and curvature under a vehicle |
//! | `gravity.rs` | force of a gradient |
//! | `wind.rs` | the wind over the line |

pub mod gravity;
pub(crate) mod local_line;
pub mod wind;
