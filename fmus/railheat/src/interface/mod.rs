//! The model as an FMU: its variables, what they may be, and the calls.
//!
//! | file | part |
//! |---|---|
//! | `rail_heat.rs` | initialisation and step |
//! | `chosen_model.rs` | the heat model that is chosen |
//! | `shape.rs` | `railheat.toml`: the wheels and probes that shape the interface |
//! | `parameters*.rs`, `signals*.rs` | the variables |
//! | `bounds.rs` | what values parameters may have |
//! | `checks.rs` | what makes no sense is refused in words |
//! | `field_file.rs` | when a snapshot of the field is written |

mod bounds;
mod checks;
mod chosen_model;
mod field_file;
mod parameters;
mod parameters_energy;
mod parameters_site;
mod rail_heat;
mod shape;
mod signals;
mod signals_energy;
mod signals_inputs;

pub use chosen_model::State;
pub use rail_heat::RailHeat;
pub use shape::{FILE_NAME, Shape};
pub use signals::Signals;
