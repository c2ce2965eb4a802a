//! What can be looked up.
//!
//! | file | commands |
//! |---|---|
//! | `stock.rs` | `stock` |
//! | `schema.rs` | `schema` |
//! | `shells.rs` | `completions`, `man` |

pub mod schema;
pub mod shells;
pub mod stock;
