//! The FMI functions of a small model, called as a simulation tool calls them.
//!
//! | file | what it tests |
//! |---|---|
//! | `spring.rs` | the model: a mass on a spring that can fail on request |
//! | `tool.rs` | the simulation tool: a thin layer over the C functions |
//! | `life_cycle.rs` | making, initialising, resetting, ending |
//! | `calls.rs` | which call is allowed when |
//! | `exchange.rs` | getting and setting values |
//! | `stepping.rs` | steps, and steps that fail |
//! | `states.rs` | saving, restoring, serializing |
//! | `messages.rs` | the logger |
//! | `description.rs` | what the packer asks for |
//! | `allocation.rs` | that a step allocates nothing |
//! | `threads.rs` | many instances, and the same results without the C interface |
#![allow(unsafe_code, reason = "the tests call the C functions as a simulation tool does")]

mod allocation;
mod calls;
mod description;
mod exchange;
mod life_cycle;
mod messages;
mod spring;
mod states;
mod stepping;
mod threads;
mod tool;

fmu::export!(spring::Spring);
