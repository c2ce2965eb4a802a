//! Profiles of wheel and rail across the track.
//!
//! | file | part |
//! |---|---|
//! | `wheel.rs` | the profiles a wheel can have |
//! | `rail.rs` | the profiles a rail can have |
//! | `point.rs` | height and slope at one lateral coordinate |
//! | `s1002.rs`, `cone.rs` | tread and flange by formula |
//! | `rail_head.rs` | a head of arcs or points, upright or inclined |
//! | `rail_60e1.rs`, `rail_as60.rs`, `uic60_manchester.rs`, `round_head.rs` | the arcs of each head |
//! | `points.rs`, `spline.rs` | a profile through points, and the curve through them |
//! | `file/` | the files that points come from |
//! | `kind.rs` | whether a profile is that of a wheel or a rail |

pub(crate) mod cone;
pub(crate) mod file;
pub(crate) mod kind;
pub(crate) mod point;
pub(crate) mod points;
pub(crate) mod rail;
mod rail_60e1;
mod rail_as60;
pub(crate) mod rail_head;
mod round_head;
mod s1002;
mod spline;
mod uic60_manchester;
pub(crate) mod wheel;
