//! Scenarios without running them.
//!
//! | file | command |
//! |---|---|
//! | `new.rs` | `new` |
//! | `wiring.rs` | `wiring` |
//! | `export_ssp.rs` | `export-ssp` |

pub mod export_ssp;
pub mod new;
pub mod wiring;
