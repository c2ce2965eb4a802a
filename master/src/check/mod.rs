//! `hotfoot check`: the rules of FMI 2.0 for an FMU, each a function with a lasting name.
//!
//! | file | rules |
//! |---|---|
//! | `rule.rs`, `rules.rs` | what a rule is, and all of them |
//! | `schema.rs`, `grammar.rs`, `elements.rs` | elements and attributes, as the schema of the standard has them |
//! | `root.rs` | what the FMU is and can do, log categories, default experiment |
//! | `units.rs` | units and types |
//! | `names.rs`, `kinds.rs`, `start.rs` | variables: names and references, what they are, values |
//! | `structure.rs`, `dependencies.rs` | outputs, initial unknowns, and what they depend on |
//! | `package.rs` | the files of the FMU, and its binary |
//! | `terminals.rs` | the terminals |
//! | `reference/` | the reference result that an FMU carries as a self-test |
//!
//! The checkers of other makers each see a part of this (`docs/user-guide/fmus.md` has a table);
//! a rule that any of them enforces is here.

mod dependencies;
mod description;
mod elements;
mod grammar;
mod kinds;
mod names;
mod package;
pub mod reference;
mod root;
mod rule;
mod rules;
mod schema;
mod start;
mod structure;
mod terminals;
#[cfg(test)]
mod tests;
mod units;

pub use package::check;
pub use rule::{Finding, Rule, Severity};
pub use rules::{check_description, rules};
pub(crate) use terminals::FILE as TERMINALS;
