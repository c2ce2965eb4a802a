//! The engineering commands: their values against closed forms and published ones, their columns, and
//! what they refuse.
//!
//! | file | command |
//! |---|---|
//! | `contact.rs` | `hotfoot contact` |
//! | `profile.rs` | `hotfoot profile` |
//! | `creep.rs` | `hotfoot creep` |
//! | `modes.rs` | `hotfoot modes` |
//! | `critical_speed.rs` | `hotfoot critical-speed` |
//! | `table.rs` | typed arguments, and the rows that a command gives |

mod contact;
mod creep;
mod critical_speed;
mod modes;
mod profile;
mod table;
