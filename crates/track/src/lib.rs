//! The track that a train runs on: curvature, cant and gradient along the chainage.
//!
//! | file | part |
//! |---|---|
//! | `content.rs`, `check.rs` | the keys of a track file, and what their values must be |
//! | `chainages.rs` | the order of points along the track |
//! | `file.rs` | the file is read, and each of its parts compiled |
//! | `compile.rs` | from the file to the compiled track |
//! | `track.rs` | the compiled track: what holds at a chainage |
//! | `irregularity/` | offsets of the rails from their designed line |
//! | `support.rs` | the elastic support of the rails |
//! | `friction.rs` | how slippery the rails are |
//! | `speed_limit.rs` | how fast a train may run |
//!
//! Positive curvature is a right-hand curve; positive cant lowers the right rail (the inner rail
//! of a right-hand curve); a positive gradient rises in the running direction.

mod chainages;
mod check;
mod compile;
mod content;
mod file;
mod friction;
pub mod irregularity;
mod speed_limit;
mod support;
mod track;

pub use file::TrackFile;
pub use friction::Friction;
pub use irregularity::{Irregularity, RailOffset};
pub use speed_limit::SpeedLimit;
pub use support::Support;
pub use track::{Location, Track, TrackPoint};
