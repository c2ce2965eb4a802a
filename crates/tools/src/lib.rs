//! Engineering commands that ask a model directly, without a simulation.
//!
//! They are the program `hotfoot-tools`. The program `hotfoot` starts it for its subcommands of
//! the same names, so that people need to know one program only and the master still knows no
//! model.
//!
//! | file | command |
//! |---|---|
//! | `contact.rs` | `hotfoot contact`: how a wheelset touches its rails |
//! | `creep.rs` | `hotfoot creep`: creep forces, friction power and flash temperature |
//! | `modes.rs` | `hotfoot modes`: natural frequencies, damping and shapes of a vehicle |
//! | `critical_speed.rs` | `hotfoot critical-speed`: the speed at which it becomes unstable |
//! | `contact_plot.rs`, `creep_plot.rs`, `plot.rs` | what the two draw with `--plot` |
//! | `vehicle_argument.rs` | the vehicle that a command is about |

pub mod contact;
mod contact_plot;
pub mod creep;
mod creep_plot;
pub mod critical_speed;
pub mod modes;
mod plot;
mod vehicle_argument;

pub use vehicle_argument::VehicleArgument;
