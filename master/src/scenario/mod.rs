//! The scenario: one TOML file that says what is run.
//!
//! | file | part |
//! |---|---|
//! | `file.rs` | the keys of the file with their bounds and defaults |
//! | `fmus.rs` | the keys of its table `[fmus]` |
//! | `heat.rs` | the keys of its table `[heat]` |
//! | `extent.rs` | the part of the track whose rail is modelled |
//! | `value.rs` | values for variables of FMUs |
//! | `times.rs` | times of the command line in place of the file's |
//! | `check.rs` | bounds, and what one key demands of another |
//! | `inputs.rs` | the files that it names |
//! | `blame.rs` | the key that a component complains of |
//! | `load.rs` | reading, with messages that point at the line |

mod blame;
mod check;
mod extent;
mod file;
mod fmus;
mod heat;
mod inputs;
mod load;
mod times;
mod value;

pub use extent::Extent;
pub use file::{
    Couplers, Driver, Record, Scenario, Scheme, Synchronisation, Track, Train, VehicleGroup, Wind,
};
pub use fmus::{Fmus, Isolate, OnFailure, VehicleReplacement};
pub use heat::{FieldFailure, Heat, Probe, Rail, Trains};
pub use load::{file_of, load};
pub use times::Times;
pub use value::{Value, quoted};
