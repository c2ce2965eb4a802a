//! Engineering commands that ask a model directly, without a simulation.
//!
//! The program `hotfoot` has them as subcommands; the master, which knows no model, has no part in them.
//!
//! | file | command |
//! |---|---|
//! | `contact/` | `hotfoot contact`: how a wheelset touches its rails |
//! | `creep/` | `hotfoot creep`: creep forces, friction power and flash temperature |
//! | `modes.rs` | `hotfoot modes`: natural frequencies, damping and shapes of a vehicle |
//! | `critical_speed.rs` | `hotfoot critical-speed`: the speed at which it becomes unstable |
//! | `plot.rs` | the page of curves that the two draw with `--plot` |
//! | `vehicle_argument.rs` | the vehicle that a command is about |

pub mod contact;
pub mod creep;
pub mod critical_speed;
pub mod modes;
mod plot;
mod vehicle_argument;

pub use vehicle_argument::VehicleArgument;
