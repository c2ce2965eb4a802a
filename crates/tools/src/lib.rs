//! Engineering commands that ask a model directly, without a simulation.
//!
//! The program `hotfoot` has them as subcommands; the master, which knows no model, has no part in them.
//!
//! | file | command |
//! |---|---|
//! | `contact/` | `hotfoot contact`: how a wheelset touches its rails |
//! | `contact/profile/` | `hotfoot profile`: what is understood of a file of points |
//! | `creep/` | `hotfoot creep`: creep forces, friction power and flash temperature |
//! | `modes.rs` | `hotfoot modes`: natural frequencies, damping and shapes of a vehicle |
//! | `critical_speed.rs` | `hotfoot critical-speed`: the speed at which it becomes unstable |
//! | `rolling_stock/` | `hotfoot stock`: the rolling-stock library as a list |
//! | `schema.rs` | `hotfoot schema`: what may stand in the files of a train |
//! | `train_files/` | the files of a train, read as the models read them |
//! | `plot.rs` | the page of curves that three of them draw with `--plot` |
//! | `vehicle_argument.rs`, `number.rs` | the vehicle that a command is about, and the numbers of options |
//! | `error.rs` | why a command cannot answer |
//!
//! A command gives the text that the program prints.

pub mod contact;
pub mod creep;
pub mod critical_speed;
mod error;
pub mod modes;
pub mod number;
mod plot;
pub mod rolling_stock;
pub mod schema;
pub mod train_files;
mod vehicle_argument;

pub use self::contact::profile;
pub use error::ToolError;
pub use vehicle_argument::VehicleArgument;
