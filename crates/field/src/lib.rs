//! Writes and reads the rail's temperature field.
//!
//! The field is the temperature **rise** above the initial state in K, stored as f32 with the
//! dimensions (time, chainage, depth) in a Zarr version 3 group. A store looks like this:
//!
//! ```text
//! rail.zarr/
//!   zarr.json            attributes: Conventions, title, what the writer's caller adds; a copy of
//!                        the metadata of all arrays ("consolidated")
//!   temperature_rise/    f32 (time, chainage, depth), one shard a snapshot, zstd
//!   time/                f64 (time), s
//!   chainage/            f64 (chainage), m, middle of each element
//!   depth/               f64 (depth), m, middle of each cell below the running surface
//! ```
//!
//! Of a rail with a whole section also that where the foot is warmest in each snapshot, and those at some
//! places, if any were asked for:
//!
//! ```text
//!   warmest_section_rise/      f32 (time, cell), zstd; the mean of left and right
//!   warmest_section_chainage/  f64 (time), m
//!   section_rise/              f32 (time, probe, cell), zstd
//!   section_chainage/          f64 (probe), m
//!   section_y/                 f64 (cell), m, to the right of the rail's middle
//!   section_z/                 f64 (cell), m, below the running surface
//!   section_area/              f64 (cell), m2 of steel
//! ```
//!
//! A snapshot is readable as soon as [`FieldWriter::append`] has returned: its values are on disk
//! before the arrays' shapes grow, and a shape grows by a rename. A run that is killed leaves all
//! snapshots that were appended.
//!
//! | file | part |
//! |---|---|
//! | `axes.rs` | the coordinates, and attributes of the group |
//! | `layout.rs` | names, chunks and codecs of the store |
//! | `writer.rs` | appends snapshots |
//! | `section_arrays.rs` | the sections in them |
//! | `complete.rs` | completes a field whose writer was killed |
//! | `reader.rs` | reads snapshots |
//! | `resumed.rs` | goes on with a field that is there |
//!
//! No other crate knows Zarr.

mod axes;
mod complete;
mod error;
mod layout;
mod reader;
mod resumed;
mod section_arrays;
mod writer;

pub use axes::{Attribute, Axes, SectionRises, Sections};
pub use complete::complete;
pub use error::FieldError;
pub use reader::{FieldReader, Snapshot, WarmestSection, fields_in};
pub use writer::{FieldWriter, is_rail_field};
