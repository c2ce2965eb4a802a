//! Heat in one rail from the wheels of a train: the model of Bosomworth, Spiryagin, Alahakoon and
//! Cole, *The influence of vehicle system dynamics on rail foot heat transfer*, Australian Journal
//! of Mechanical Engineering (2018), doi 10.1080/14484846.2018.1457260, as `model = "paper"`, and heat that is conserved in a real section, as
//! `model = "energy"`.
//!
//! The rail is cut into short elements along the track. Each is a column over the rail's depth
//! that conducts heat downwards. A wheel raises the surface of every element it passes to its
//! flash temperature; the weather acts on the surface; the foot is insulated.
//!
//! | file | part |
//! |---|---|
//! | `material.rs` | the rail's steel |
//! | `creep_force.rs` | longitudinal creep force of a wheel |
//! | `flash_temperature.rs` | temperature rise of the rail's surface under a wheel |
//! | `surface.rs` | heat exchanged with the weather |
//! | `column.rs` | heat conduction over the depth |
//! | `rail.rs` | all elements: grid, untouched rail, readings |
//! | `wheels.rs` | which elements a wheel passes in a step |
//! | `audit.rs` | where the heat came from and where it is |
//! | `paper.rs` | the paper's model: what happens in which order |
//! | `energy/` | `model = "energy"` |
//! | `section/` | the rail's cross-section and its modes |
//! | `weather_file.rs` | weather from a CSV file |
//! | `heat.rs` | the chosen model |
//! | `file.rs` | `railheat.toml`: the wheels and probes that shape the interface |
//! | `parameters*.rs`, `signals*.rs` | the FMU's variables |
//! | `bounds.rs` | what values parameters may have |
//! | `interface.rs` | the model as an FMU |
//! | `checks.rs` | what makes no sense is refused in words |
//! | `field_file.rs` | when a snapshot of the field is written |
//!
//! Equations are numbered in `docs/theory/railheat`, which also lists where the paper's text
//! leaves a choice, and what the model is known to get wrong. All values are in SI units;
//! temperatures of the rail are rises above its initial temperature.

pub mod audit;
mod bounds;
mod checks;
pub mod column;
pub mod creep_force;
pub mod energy;
mod field_file;
pub mod file;
pub mod flash_temperature;
mod heat;
mod interface;
pub mod material;
pub mod paper;
mod parameters;
mod parameters_energy;
mod parameters_site;
pub mod rail;
pub mod section;
mod signals;
mod signals_energy;
mod signals_inputs;
pub mod surface;
pub mod weather_file;
pub mod wheels;

pub use interface::RailHeat;
pub use signals::Signals;
