//! The folder of a run's results: whose it is, and how it is left.
//!
//! | file | part |
//! |---|---|
//! | `claim.rs` | one run has the folder, from its start to its end |
//! | `contents.rs` | what a run writes there |
//! | `complete.rs` | the results of a run that has ended anyhow, completed |

pub mod claim;
pub mod complete;
pub mod contents;
