//! FMUs in processes of their own, which alone a crash, an exit, a damaged memory or a call without end
//! costs then.
//!
//! | file | part |
//! |---|---|
//! | `unit.rs` | such an instance as a [`Unit`](crate::system::unit::Unit) |
//! | `line.rs` | what goes from it to its process and back |
//! | `worker.rs` | what its process does |
//! | `process.rs` | its process, seen from the run |
//! | `death.rs` | why it has ended |
//! | `message.rs` | what the two tell each other |
//! | `mailbox.rs` | the memory by which they do |
//!
//! The process is this program again. It ends with the run, whichever way that ends.

mod death;
mod line;
mod mailbox;
mod message;
mod process;
mod unit;
mod worker;

pub use process::WAITING;
pub use unit::Isolated;
pub use worker::serve;
