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
//!
//! The standard is *Functional Mock-up Interface 2.0.5* (Modelica Association); `§` in the
//! comments of this crate means its sections.

mod model;
pub mod unit;
mod values;
mod variable;

pub use model::{Identity, Interval, Log, LogLevel, Model, ModelError};
pub use unit::Unit;
pub use values::{Boolean, Integer, Real, Text, Values};
pub use variable::{Causality, Declaration, Initial, Kind, Variability, Variable};
