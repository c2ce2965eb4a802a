//! A Rust model becomes an FMI 2.0 co-simulation FMU.
//!
//! The author of a model writes one typed [`Declaration`] of its variables and implements
//! [`Model`]; everything a simulation tool sees follows from these two:
//!
//! | file | part |
//! |---|---|
//! | `unit.rs` | SI units as `UnitDefinitions` has them |
//! | `variable.rs` | the declaration of the variables, and the handles it gives |
//! | `values.rs` | the values of an instance's variables, read and written by handle |
//! | `model.rs` | the trait a physical model implements |
//! | `instance.rs` | the state machine: from being made to being terminated |
//! | `calls.rs` | which call is allowed when: the table of the standard |
//! | `stepping.rs` | the step, and what is checked before and after it |
//! | `exchange.rs` | getting and setting values |
//! | `restore.rs`, `state.rs` | saving an instance, setting it back, serializing |
//! | `interface.rs`, `guid.rs` | the declaration, checked and compact, and its fingerprint |
//! | `logging.rs`, `error.rs`, `status.rs` | what is told to the user, and what is returned |
//! | `description.rs` | `modelDescription.xml` |
//! | `signal_table.rs` | `documentation/index.html` |
//! | `terminals.rs` | `terminalsAndIcons/terminalsAndIcons.xml` |
//! | `abi.rs`, `export.rs` | the C functions, and their names in an FMU's library |
//! | `resource_location.rs` | the URI of the resources folder |
//!
//! An [`Instance`] is the whole FMU in safe Rust; the C functions add pointers and nothing else.
//! This is a model that integrates its input, and a run of it:
//!
//! ```
//! use std::borrow::Cow;
//! use std::path::Path;
//! use fmu::{Declaration, Identity, Instance, Interval, Log, Model, ModelError, Real, Values, unit};
//!
//! struct Integrator {
//!     position: f64,
//! }
//!
//! struct Signals {
//!     speed: Real,
//!     position: Real,
//! }
//!
//! impl Model for Integrator {
//!     const IDENTITY: Identity = Identity {
//!         name: "Integrator",
//!         identifier: "integrator",
//!         description: "Position from speed",
//!         default_step: 0.1,
//!     };
//!     type Signals = Signals;
//!     type State = f64;
//!
//!     fn declare(_: &Path, declaration: &mut Declaration) -> Result<Signals, ModelError> {
//!         Ok(Signals {
//!             speed: declaration.real("speed", unit::METRE_PER_SECOND, "Speed").input(0.0),
//!             position: declaration.real("position", unit::METRE, "Position").output(),
//!         })
//!     }
//!
//!     fn initialize(
//!         signals: &Signals,
//!         values: &mut Values,
//!         _resources: &Path,
//!         _start_time: f64,
//!         _log: &mut Log,
//!     ) -> Result<Self, ModelError> {
//!         values[signals.position] = 0.0;
//!         Ok(Self { position: 0.0 })
//!     }
//!
//!     fn step(
//!         &mut self,
//!         signals: &Signals,
//!         values: &mut Values,
//!         interval: Interval,
//!         _log: &mut Log,
//!     ) -> Result<(), ModelError> {
//!         self.position += values[signals.speed] * interval.length;
//!         values[signals.position] = self.position;
//!         Ok(())
//!     }
//!
//!     fn state(&self) -> Cow<'_, f64> {
//!         Cow::Borrowed(&self.position)
//!     }
//!
//!     fn restore(&mut self, position: f64) {
//!         self.position = position;
//!     }
//! }
//!
//! # fn main() -> Result<(), fmu::Error> {
//! let show = |_, message: &str| println!("{message}");
//! let mut instance = Instance::<Integrator>::new(Path::new(""), "one", Box::new(show))?;
//! instance.setup_experiment(0.0, None)?;
//! instance.enter_initialization_mode()?;
//! instance.exit_initialization_mode()?;
//! let speed = instance.signals().speed.reference();
//! instance.set_real(&[speed], [2.0])?;
//! instance.do_step(0.0, 0.5)?;
//! assert_eq!(instance.values()[instance.signals().position], 1.0);
//! # Ok(())
//! # }
//! ```
//!
//! The standard is *Functional Mock-up Interface 2.0.5* (Modelica Association); `§` in the
//! comments of this crate means its sections.

#[doc(hidden)]
pub mod abi;
mod calls;
mod description;
mod error;
mod exchange;
mod export;
mod guid;
mod instance;
mod interface;
mod logging;
mod model;
mod resource_location;
mod restore;
mod signal_table;
mod state;
mod status;
mod stepping;
mod terminals;
pub mod unit;
mod values;
mod variable;

pub use calls::{Call, Phase};
pub use description::model_description;
pub use error::Error;
pub use guid::Guid;
pub use instance::Instance;
pub use logging::{Category, Sink};
pub use model::{Identity, Interval, Log, LogLevel, Model, ModelError};
pub use signal_table::{documentation, signal_table_html};
pub use state::SavedState;
pub use status::Status;
pub use terminals::{Terminal, terminals};
pub use unit::Unit;
pub use values::{Boolean, Integer, Real, Reals, Text, Values};
pub use variable::{Causality, Declaration, Initial, Kind, Variability, Variable};
