//! One railway vehicle in three dimensions: rigid bodies on springs and dampers, and the contact
//! of every wheel with its rail.
//!
//! | file | part |
//! |---|---|
//! | `structure.rs` | a vehicle file compiled into flat arrays |
//! | `creep_law.rs` | the creep law that a vehicle file chooses |
//! | `frame.rs` | the frames that follow the track |
//! | `body.rs` | a rigid body in its frame, with the frame's inertia forces |
//! | `suspension/` | springs, dampers, stops, friction: one file for each element |
//! | `line.rs` | what a vehicle runs on: designed track, irregularities, support |
//! | `rail.rs` | the rails under a wheelset: irregularities, elastic support |
//! | `wheel.rs`, `patch.rs`, `rows.rs` | a wheel and the contacts in which it touches: approach, normal force, slip |
//! | `wheelset.rs`, `slip_mobility.rs` | a wheelset's step with its contact forces; how much of creep is implicit in it |
//! | `wheel_output.rs` | what a wheel does to its rail at the end of a step |
//! | `drive.rs` | traction and brake of a wheelset |
//! | `dynamics.rs`, `outer_forces.rs` | the vehicle in motion: state and step; forces of couplers and train |
//! | `equilibrium/` | the start in equilibrium |
//! | `statics.rs`, `linear/` | static load of the springs; the vehicle linearised |
//! | `energy.rs`, `inputs.rs`, `six.rs` | energy account; forces from outside; algebra |
//! | `signals/`, `interface.rs` | the model as an FMU: its variables, its life |
//!
//! Equations are numbered in `docs/theory/vehicle`. Axes: x along the track in the running
//! direction, y to the right, z down; SI units.

pub mod body;
mod creep_law;
pub mod drive;
pub mod dynamics;
pub mod energy;
pub mod equilibrium;
pub mod frame;
pub mod inputs;
mod interface;
pub mod line;
pub mod linear;
mod outer_forces;
pub mod patch;
pub mod rail;
pub mod rows;
mod signals;
pub mod six;
pub mod slip_mobility;
mod statics;
pub mod structure;
pub mod suspension;
pub mod wheel;
pub mod wheel_output;
pub mod wheelset;

pub use interface::Vehicle;
pub use signals::Signals;
