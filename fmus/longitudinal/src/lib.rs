//! Longitudinal dynamics of a train: one mass a vehicle, joined by draft gears with slack.
//!
//! The equations stand, numbered, in `docs/theory/longitudinal.md`; the code cites them. The train
//! is rigid across the track and moves in the chainage only: curves act by their resistance.
//!
//! | room | part |
//! |---|---|
//! | `coupling/` | draft gears, two in series with slack between two vehicles |
//! | `line/` | what the line does to a vehicle: gradient and wind |
//! | `resistance/` | propulsion and curve resistance |
//! | `drive/` | traction and dynamic brake of a locomotive |
//! | `brake/` | friction brakes, by cable or by pipe |
//! | `command.rs`, `history.rs` | commands, and those on their way |
//! | `train/` | vehicles joined to a train: its start, its step, its energy |
//! | `driver/` | who commands: a schedule, profiles, a controller, a logger's file |
//! | `interface/` | the variables of the FMU, and the physics behind them |

pub mod brake;
pub mod command;
pub mod coupling;
pub mod drive;
pub mod driver;
mod history;
mod interface;
pub mod line;
pub mod resistance;
mod train;

pub use command::Command;
pub use interface::model::{State, Train};
pub use interface::signals::{Signals, TrainSignals, VehicleSignals};
pub use line::wind::Wind;
pub use train::build::BuildError;
pub use train::dynamics::{TrainDynamics, TrainState};
pub use train::energy::{Energy, Work};
pub use train::start::{Couplers, Start};
pub use train::step::LONGEST_STEP;
pub use train::totals::Totals;
pub use train::vehicle::Vehicle;
pub use train::vehicle_state::{Forces, VehicleState};
