//! Import of FMI 2.0 co-simulation FMUs.
//!
//! | file | part |
//! |---|---|
//! | `binding.rs` | the C functions of an FMU's binary |
//! | `crash.rs`, `crash.c` | which FMU was at work when the program crashes |
//! | `callbacks.rs` | the functions that an FMU calls: logger, memory |
//! | `describe.rs` | asks a binary of Hotfoot's own to describe itself for given resources |
//! | `import.rs` | an FMU file: unpacked and loaded once |
//! | `origins.rs` | what its resources are copies of |
//! | `instance.rs`, `unit.rs` | an instance of it: a [`Unit`](crate::system::unit::Unit) |
//! | `resource_paths.rs` | texts that name files in an FMU's own resources |
//! | `step.rs` | the step, and what each status of it means |
//! | `state.rs` | the states of an instance, and as bytes |
//! | `pack.rs`, `documentation.rs` | FMUs are packed |
//! | `logger.c` | the variadic part of the logger |
//!
//! This is the only part of the master with `unsafe` code.

#![allow(unsafe_code)]

mod binding;
mod callbacks;
mod crash;
mod describe;
mod documentation;
mod import;
mod instance;
mod origins;
pub mod pack;
mod resource_paths;
mod state;
mod step;
mod unit;

pub use binding::missing_functions;
pub use crash::watch as watch_crashes;
pub use describe::describe;
pub use import::{Import, ImportError, binary_path, read_interface};
pub use instance::FmuInstance;
pub use origins::Origins;
pub use resource_paths::with_resource_paths;
