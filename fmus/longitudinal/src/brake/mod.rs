//! The friction brakes of the train.
//!
//! | file | part |
//! |---|---|
//! | `friction_brake.rs` | force of the brake shoes of a vehicle |
//! | `ecp.rs` | train brake by cable |
//! | `air.rs` | train brake by pipe |
//! | `pipe.rs` | the wave of a command along the brake pipe |
//! | `reservoir.rs` | the air that a vehicle's brake has |
//! | `state.rs` | what changes in the brakes of a vehicle |

pub(crate) mod air;
mod ecp;
pub mod friction_brake;
pub(crate) mod pipe;
mod reservoir;
pub(crate) mod state;
