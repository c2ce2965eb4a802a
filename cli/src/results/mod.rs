//! The folders that runs have written.
//!
//! | file | commands |
//! |---|---|
//! | `report.rs` | `report`, `expect` |
//! | `compare.rs` | `compare` |

pub mod compare;
pub mod report;
