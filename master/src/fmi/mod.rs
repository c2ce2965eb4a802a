//! Import of FMI 2.0 co-simulation FMUs.
//!
//! | file | part |
//! |---|---|
//! | `binding.rs` | the C functions of an FMU's binary |
//! | `watched/` | what is called just now, for the parent of the process |
//! | `library.rs` | the binary, loaded |
//! | `callbacks.rs` | the functions that an FMU calls: logger, memory |
//! | `describe.rs` | asks a binary of Hotfoot's own to describe itself for given resources |
//! | `import.rs` | an FMU file: unpacked and loaded once |
//! | `origins.rs` | what its resources are copies of |
//! | `instance.rs`, `unit.rs` | an instance of it: a [`Unit`](crate::system::unit::Unit) |
//! | `resource_paths.rs` | texts that name files in an FMU's own resources |
//! | `step.rs` | the step, and what each status of it means |
//! | `pack.rs`, `documentation.rs` | FMUs are packed |
//! | `logger.c` | the variadic part of the logger |
//!
//! This is the only part of the master with `unsafe` code.

#![allow(unsafe_code)]

mod binding;
mod callbacks;
mod describe;
mod documentation;
mod import;
mod instance;
mod library;
mod origins;
pub mod pack;
mod resource_paths;
mod step;
mod unit;
pub mod watched;

pub use binding::missing_functions;
pub use describe::describe;
pub use import::{Import, ImportError, binary_path, read_interface};
pub use instance::FmuInstance;
pub use library::UNLOADING;
pub use origins::Origins;
pub use resource_paths::with_resource_paths;
