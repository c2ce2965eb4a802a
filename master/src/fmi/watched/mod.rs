//! What a run does just now, where a parent process sees it.
//!
//! So the parent can end a call that takes too long, and say after any end who was at fault.
//!
//! | file | part |
//! |---|---|
//! | `page.rs` | the shared memory: how far the run is, and whether it is to stop |
//! | `slot.rs` | what a thread calls |
//! | `labels.rs` | the names of instances and files in it |
//! | `calling.rs` | the page of this process, and its calls of FMUs |
//! | `culprit.rs`, `crash.c` | the thread that has ended the program |
//!
//! Without a parent there is no page, and nothing is noted.

mod calling;
mod culprit;
mod labels;
mod page;
mod slot;

pub(super) use calling::{call_until_the_end, calling, label};
pub use calling::{own, watch};
pub use culprit::{Culprit, EndedBy};
pub(super) use labels::Label;
pub use page::Page;
pub use slot::Call;
