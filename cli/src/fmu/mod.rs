//! FMUs without running them.
//!
//! | file | command |
//! |---|---|
//! | `interface.rs` | `interface` |
//! | `pack.rs` | `pack` |

pub mod interface;
pub mod pack;
