//! The scenario: one TOML file that says what is run.
//!
//! | file | part |
//! |---|---|
//! | `file.rs` | the keys of the file with their bounds and defaults |
//! | `load.rs` | reading and checking, with messages that point at the line |

mod file;
mod load;

pub use file::{
    Couplers, Driver, Fmus, Heat, Probe, Rail, Record, Scenario, Scheme, Synchronisation, Track,
    Train, VehicleGroup, VehicleReplacement, Wind,
};
pub use load::{ScenarioError, load};
