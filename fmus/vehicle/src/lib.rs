//! One railway vehicle in three dimensions: rigid bodies on springs and dampers, and the contact
//! of every wheel with its rail.
//!
//! | room | part |
//! |---|---|
//! | `structure.rs` | what a vehicle is: bodies, wheelsets and elements by index |
//! | `compile/` | from a vehicle file to that structure, with the static load of the springs |
//! | `body/` | rigid bodies, and the frames that follow the track |
//! | `track/` | what a vehicle runs on: designed track, irregularities, elastic rails |
//! | `contact/` | a wheel on its rail: approach, normal force, slip, creep force |
//! | `suspension/` | springs, dampers, stops, friction: one file for each element |
//! | `dynamics/` | the vehicle in motion: state and step, wheelsets, drives, couplers |
//! | `equilibrium/` | the start in equilibrium |
//! | `linear/` | the vehicle linearised: modes, critical speed |
//! | `energy.rs` | where the energy comes from and where it goes |
//! | `interface/` | the model as an FMU: its variables, its life |
//!
//! Equations are numbered in `docs/theory/vehicle`. Axes: x along the track in the running
//! direction, y to the right, z down; SI units.

pub mod body;
pub mod compile;
pub mod contact;
pub mod dynamics;
pub mod energy;
pub mod equilibrium;
mod interface;
pub mod linear;
pub mod structure;
pub mod suspension;
pub mod track;

pub use interface::{Signals, Vehicle};
