//! The train: one mass a vehicle, joined by couplings, on a track.
//!
//! | file | part |
//! |---|---|
//! | `vehicle.rs`, `vehicle_state.rs` | one mass with all that acts on it |
//! | `member.rs` | what distinguishes a vehicle from others of its type |
//! | `build.rs`, `dynamics.rs` | how the train is built, and what it consists of |
//! | `start.rs` | the state at the beginning, in balance or unstressed |
//! | `step.rs`, `stability.rs` | the step, and how long it may be |
//! | `brake_pipe.rs` | which locomotives command the air brake of which vehicle |
//! | `energy.rs`, `audit.rs` | work of each kind, and the energy audit |
//! | `totals.rs` | sums and extremes over the train |

mod audit;
mod brake_pipe;
pub(crate) mod build;
pub(crate) mod dynamics;
pub(crate) mod energy;
pub(crate) mod member;
mod stability;
pub(crate) mod start;
pub(crate) mod step;
pub(crate) mod totals;
pub(crate) mod vehicle;
pub(crate) mod vehicle_state;
