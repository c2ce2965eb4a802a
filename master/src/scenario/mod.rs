//! The scenario: one TOML file that says what is run.
//!
//! | file | part |
//! |---|---|
//! | `file.rs` | the keys of the file with their bounds and defaults |
//! | `heat.rs` | the keys of its table `[heat]` |
//! | `value.rs` | values for variables of FMUs |
//! | `load.rs` | reading and checking, with messages that point at the line |

mod file;
mod heat;
mod load;
mod value;

pub use file::{
    Couplers, Driver, Fmus, Record, Scenario, Scheme, Synchronisation, Track, Train, VehicleGroup,
    VehicleReplacement, Wind,
};
pub use heat::{FieldFailure, Heat, Probe, Rail, Trains};
pub use load::{ScenarioError, file_of, load};
pub use value::Value;
