//! Heat in one rail from the wheels of a train.
//!
//! `model = "paper"` is the model of Bosomworth, Spiryagin, Alahakoon and Cole, *The influence of
//! vehicle system dynamics on rail foot heat transfer*, Australian Journal of Mechanical
//! Engineering (2018), doi 10.1080/14484846.2018.1457260; "the paper" is this one throughout.
//! `model = "energy"` conserves heat, in a real section of rail.
//!
//! The rail is cut into short elements along the track. Each is a column over the rail's depth
//! that conducts heat downwards. A wheel raises the surface of every element it passes to its
//! flash temperature; the weather acts on the surface; the foot is insulated.
//!
//! | room | part |
//! |---|---|
//! | `line.rs` | how the rail is cut along the track |
//! | `contact/` | a wheel on the rail: friction, flash temperature, rail chill, its own temperature |
//! | `section/` | the rail's cross-section and its modes |
//! | `weather/` | air, wind, sun and shade, and the heat exchanged with them |
//! | `heat_model.rs` | what every heat model can do |
//! | `paper/` | `model = "paper"` |
//! | `energy/` | `model = "energy"` |
//! | `interface/` | the model as an FMU |
//!
//! Equations are numbered in `docs/theory/railheat`, which also lists where the paper's text
//! leaves a choice, and what the model is known to get wrong. All values are in SI units;
//! temperatures of the rail are rises above its initial temperature.

pub mod contact;
pub mod energy;
mod heat_model;
mod interface;
pub mod line;
pub mod paper;
pub mod section;
pub mod weather;

pub use heat_model::HeatModel;
pub use interface::{FILE_NAME, RailHeat, Shape, Signals, State};
