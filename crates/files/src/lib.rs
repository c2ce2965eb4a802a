//! The files that people write: how they are read, and how a mistake in one is answered.
//!
//! Scenario, track, vehicles, trains, drivers, rails, loggers and weather all come through here, so that a
//! mistake always reads the same:
//!
//! ```text
//! track.toml:7:12: alignment[2].radius_m = 0: must be at least 50 m
//!   |
//! 7 | radius_m = 0
//!   |            ^
//! ```
//!
//! | file | part |
//! |---|---|
//! | `document.rs` | a [`Document`]: the text of a file with its name |
//! | `mistake.rs` | a [`Mistake`]: file, line, column, and a sentence |
//! | `check.rs` | a [`Check`]: what the values of a TOML file must be |
//! | `key.rs` | where the value of a key stands, and which key stands there |
//! | `parse.rs` | what a document says, as a structure of the program |
//! | `structure.rs`, `syntax.rs` | the messages of serde and of TOML in plain words |
//! | `setting.rs` | a [`Setting`]: a value of the command line in place of the file's |
//! | `table.rs` | a [`Table`]: rows of comma-separated values |
//! | `column.rs` | a [`Column`]: what stands in one of its columns |
//! | `nearest.rs` | the name that was meant |

mod check;
mod column;
mod document;
mod key;
mod mistake;
mod nearest;
mod parse;
mod setting;
mod structure;
mod syntax;
mod table;

pub use check::Check;
pub use column::Column;
pub use document::{Document, exists};
pub use mistake::{Mark, Mistake};
pub use nearest::{did_you_mean, nearest};
pub use setting::Setting;
pub use table::Table;
