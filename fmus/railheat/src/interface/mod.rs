//! The model as an FMU: its variables, what they may be, and the calls.
//!
//! | file | part |
//! |---|---|
//! | `rail_heat.rs` | initialisation and step |
//! | `build.rs` | the model that the parameters describe |
//! | `chosen_model.rs` | the heat model that is chosen |
//! | `shape.rs` | `railheat.toml`: the wheels and probes that shape the interface |
//! | `parameters/` | the parameters |
//! | `inputs.rs`, `outputs.rs` | the inputs and outputs |
//! | `signals.rs` | handles of all variables |
//! | `weather_source.rs` | the weather of the file or of the inputs |
//! | `field_file.rs` | when a snapshot of the field is written |

mod build;
mod chosen_model;
mod field_file;
mod inputs;
mod outputs;
mod parameters;
mod rail_heat;
mod shape;
mod signals;
mod weather_source;

pub use chosen_model::State;
pub use rail_heat::RailHeat;
pub use shape::{FILE_NAME, Shape};
pub use signals::Signals;
