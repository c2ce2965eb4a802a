//! A Rust model becomes an FMI 2.0 co-simulation FMU.
//!
//! The author of a model says its variables in tables, [`variables!`], and implements [`Model`];
//! everything a simulation tool sees follows from these two:
//!
//! | room | part |
//! |---|---|
//! | `variables/` | the variables: tables, declaration, units, bounds, handles, values |
//! | `model.rs` | the trait that a physical model implements |
//! | `calls.rs` | which call is allowed when: the table of the standard |
//! | `instance/` | the state machine, from being made to being terminated |
//! | `description/` | `modelDescription.xml` and what else describes the FMU |
//! | `abi/` | the C functions, and their names in an FMU's library |
//! | `error.rs`, `status.rs` | why a call did not succeed, and what it returns |
//!
//! An [`Instance`] is the whole FMU in safe Rust; the C functions add pointers and nothing else.
//! This is a model that integrates its input, and a run of it:
//!
//! ```
//! use std::borrow::Cow;
//! use std::path::Path;
//! use fmu::{
//!     Declaration, Handles, Identity, Instance, Interval, Log, Model, ModelError, Values, Variables,
//! };
//!
//! fmu::variables! {
//!     /// What moves the vehicle.
//!     pub struct Motion: input {
//!         /// Speed
//!         speed: "speed", METRE_PER_SECOND = 0.0;
//!     }
//!
//!     /// Where the vehicle is.
//!     pub struct Integrator: output {
//!         /// Position
//!         position: "position", METRE;
//!     }
//!
//!     /// All variables.
//!     pub struct Signals {
//!         /// What moves the vehicle.
//!         motion: "", group(Motion);
//!         /// Where it is.
//!         integrator: "", group(Integrator);
//!     }
//! }
//!
//! impl Model for Integrator {
//!     const IDENTITY: Identity = Identity {
//!         name: "Integrator",
//!         identifier: "integrator",
//!         description: "Position from speed",
//!         default_step: 0.1,
//!     };
//!     type Signals = Handles<Signals>;
//!     type State = f64;
//!
//!     fn declare(
//!         _resources: &Path,
//!         declaration: &mut Declaration,
//!     ) -> Result<Handles<Signals>, ModelError> {
//!         Ok(Signals::declare(declaration, ""))
//!     }
//!
//!     fn initialize(
//!         signals: &Handles<Signals>,
//!         values: &mut Values,
//!         _resources: &Path,
//!         _start_time: f64,
//!         _log: &mut Log,
//!     ) -> Result<Self, ModelError> {
//!         let integrator = Self { position: 0.0 };
//!         integrator.write(&signals.integrator, values);
//!         Ok(integrator)
//!     }
//!
//!     fn step(
//!         &mut self,
//!         signals: &Handles<Signals>,
//!         values: &mut Values,
//!         interval: Interval,
//!         _log: &mut Log,
//!     ) -> Result<(), ModelError> {
//!         let motion = Motion::read(&signals.motion, values);
//!         self.position += motion.speed * interval.length;
//!         self.write(&signals.integrator, values);
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
//! let speed = instance.signals().motion.speed.reference();
//! instance.set_real(&[speed], [2.0])?;
//! instance.do_step(0.0, 0.5)?;
//! assert_eq!(instance.values()[instance.signals().integrator.position], 1.0);
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
mod instance;
mod model;
mod status;
mod variables;

pub use calls::{Call, Phase};
pub use description::{documentation, model_description, signal_table_html, terminals};
pub use error::Error;
pub use instance::Instance;
pub use instance::logging::{Category, Sink};
pub use instance::state::SavedState;
pub use model::{Identity, Interval, Log, LogLevel, Model, ModelError};
pub use status::Status;
pub use variables::{
    Boolean, Bounds, Causality, Choice, Declaration, FileHandle, Guid, Handles, Initial, Integer,
    Kind, Real, Reals, ResourceFile, Scope, Terminal, Text, Type, Unit, Values, Variability,
    Variable, VariableDeclaration, Variables, above, unit,
};
