//! Import of FMI 2.0 co-simulation FMUs.
//!
//! | file | part |
//! |---|---|
//! | `binding.rs` | the C functions of an FMU's binary |
//! | `watched/` | what is called just now, for the parent of the process |
//! | `library.rs` | the binary, loaded |
//! | `binaries.rs` | what an unpacked FMU has to be run with |
//! | `callbacks.rs`, `messages.rs` | the functions that an FMU calls: logger, memory; what it logs |
//! | `describe.rs` | asks a binary of Hotfoot's own to describe itself for given resources |
//! | `guard/` | what is checked around every call |
//! | `import.rs` | an FMU file: unpacked and loaded once |
//! | `isolated/` | an instance in a process of its own |
//! | `origins.rs` | what its resources are copies of |
//! | `instance.rs`, `unit.rs` | an instance of it: a [`Unit`](crate::system::unit::Unit) |
//! | `manner.rs`, `home.rs` | how an instance is called: on a thread of its own |
//! | `resource_paths.rs` | texts that name files in an FMU's own resources |
//! | `step.rs` | the step, and what each status of it means |
//! | `homes.rs` | which FMUs run in this process and which in their own |
//! | `state.rs` | the states of an instance, and as bytes |
//! | `pack.rs`, `documentation.rs` | FMUs are packed |
//! | `logger.c` | the variadic part of the logger |
//!
//! This is the only part of the master with `unsafe` code.

#![allow(unsafe_code)]

mod binaries;
mod binding;
mod callbacks;
mod describe;
mod documentation;
mod guard;
mod home;
pub mod homes;
mod import;
mod instance;
#[cfg(target_os = "linux")]
mod isolated;
mod library;
mod manner;
mod messages;
mod origins;
pub mod pack;
mod resource_paths;
mod state;
mod step;
mod unit;
pub mod watched;

pub use binaries::Binaries;
pub use binding::{missing_functions, reason};
pub use describe::describe;
pub use import::{Import, ImportError, binary_path, read_interface};
pub use instance::FmuInstance;
#[cfg(target_os = "linux")]
pub use isolated::{WAITING, serve};
pub use library::{UNLOADING, note_unloading};
pub use manner::{Manner, unit};
pub use origins::Origins;
pub use resource_paths::with_resource_paths;
