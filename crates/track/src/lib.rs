//! The track that a train runs on: curvature, cant and gradient along the chainage.
//!
//! | file | part |
//! |---|---|
//! | `file.rs` | the track file that people write |
//! | `track.rs` | the compiled track: what holds at a chainage |
//!
//! Positive curvature is a right-hand curve; positive cant lowers the right rail (the inner rail
//! of a right-hand curve); a positive gradient rises in the running direction.

mod file;
mod track;

pub use file::TrackError;
pub use track::{Track, TrackPoint};
