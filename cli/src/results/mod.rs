//! The folders that runs have written.
//!
//! | file | commands |
//! |---|---|
//! | `report.rs` | `report` |
//! | `expect.rs` | `expect` |
//! | `compare.rs` | `compare` |

pub mod compare;
pub mod expect;
pub mod report;
