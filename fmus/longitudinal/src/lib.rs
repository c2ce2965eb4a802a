//! Longitudinal dynamics of a train: one mass a vehicle, joined by draft gears with slack.
//!
//! The equations stand, numbered, in `docs/theory/longitudinal.md`; the code cites them. The train
//! is rigid across the track and moves in the chainage only: curves act by their resistance.
//!
//! | file | part |
//! |---|---|
//! | `draft_gear.rs` | force of a gear over its deflection; two gears in series |
//! | `connection.rs`, `connection_side.rs` | two gears with slack between two vehicles |
//! | `resistance.rs`, `curve_resistance.rs`, `gravity.rs`, `wind.rs` | what the line does to a vehicle |
//! | `lever.rs`, `traction.rs`, `dynamic_brake.rs` | what a locomotive does |
//! | `brake.rs`, `ecp_brake.rs` | friction brakes, by cable |
//! | `air_brake.rs`, `pipe.rs`, `reservoir.rs` | by pipe: the wave along the train, the air there is |
//! | `history.rs` | commands on their way |
//! | `driver/` | who commands: a schedule, profiles, a controller, a logger's file |
//! | `vehicle.rs`, `vehicle_state.rs` | one mass with all that acts on it |
//! | `train.rs`, `member.rs`, `build.rs` | the train: vehicles, connections, track; how it is built |
//! | `start.rs` | the state at the beginning, in balance or unstressed |
//! | `integrate.rs`, `stability.rs` | the step, and how long it may be |
//! | `energy.rs` | work of each kind and the energy audit |
//! | `totals.rs` | sums and extremes over the train |
//! | `signals.rs` | the variables of the FMU |
//! | `interface.rs` | the way from them to the physics and back |

mod air_brake;
pub mod brake;
mod build;
pub mod connection;
mod connection_side;
pub mod curve_resistance;
pub mod draft_gear;
pub mod driver;
pub mod dynamic_brake;
mod ecp_brake;
mod energy;
pub mod gravity;
mod history;
mod integrate;
mod interface;
pub mod lever;
mod member;
mod pipe;
mod reservoir;
pub mod resistance;
mod signals;
mod stability;
mod start;
mod totals;
pub mod traction;
mod train;
mod vehicle;
mod vehicle_state;
mod wind;

pub use build::BuildError;
pub use energy::{Energy, Work};
pub use integrate::LONGEST_STEP;
pub use interface::{State, Train};
pub use signals::{Signals, VehicleSignals};
pub use start::{Couplers, Start};
pub use totals::Totals;
pub use train::{TrainDynamics, TrainState};
pub use vehicle::Vehicle;
pub use vehicle_state::{Forces, VehicleState};
pub use wind::Wind;
