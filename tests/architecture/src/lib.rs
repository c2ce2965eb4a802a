//! The rules of the house: what holds for the layout and the words of this repository's own sources.
//!
//! | file | part |
//! |---|---|
//! | `workspace.rs` | the packages and their sources, read and parsed |
//! | `imports/` | which file of a package uses which |
//! | `breach.rs` | what breaks a rule |
//! | `rules/` | one file for each rule or kind of rules |
//!
//! `cargo run -q -p architecture` prints every breach of every rule with file and line, and
//! `cargo run -q -p architecture -- circles master` those of one rule in one folder.

mod breach;
mod imports;
mod rules;
mod workspace;

pub use breach::Breach;
pub use rules::{RULES, Rule};
pub use workspace::{Package, Source, Workspace};
