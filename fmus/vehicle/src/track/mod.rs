//! What a vehicle runs on.
//!
//! | file | part |
//! |---|---|
//! | `line.rs` | designed track, irregularities, support and friction |
//! | `rail.rs` | the rails under a wheelset: where they lie, how they give way |

pub mod line;
pub mod rail;

pub use line::Line;
pub use rail::{Deflection, RailMotion};
