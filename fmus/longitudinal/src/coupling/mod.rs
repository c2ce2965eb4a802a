//! The coupling of two vehicles: two draft gears in series with slack between them.
//!
//! | file | part |
//! |---|---|
//! | `draft_gear.rs` | force of a gear over its deflection; two gears in series |
//! | `connection.rs` | two gears with slack between two vehicles |
//! | `connection_side.rs` | what the gears do in one direction, draft or buff |

pub mod connection;
mod connection_side;
pub mod draft_gear;
