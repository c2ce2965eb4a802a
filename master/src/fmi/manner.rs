//! How an instance of an FMU is called.

use std::sync::Arc;

use super::home::AtHome;
use super::import::Import;
use super::instance::FmuInstance;
use crate::system::unit::{Unit, UnitError};

/// How an instance is called.
#[derive(Debug, Clone, Copy, Default)]
pub struct Manner {
    /// Whether a step that it discards is tried again in parts.
    pub retries: bool,
    /// Whether it is made, called and freed on a thread of its own.
    pub same_thread: bool,
    /// Relative tolerance of its solver; none: what its FMU proposes.
    pub tolerance: Option<f64>,
}

/// Makes an instance that is called in this manner.
///
/// # Errors
/// When the FMU refuses, with what it logged.
pub fn unit(import: &Arc<Import>, name: &str, manner: Manner) -> Result<Box<dyn Unit>, UnitError> {
    let (own, own_name) = (Arc::clone(import), name.to_owned());
    let make = move || -> Result<FmuInstance, UnitError> {
        let instance = FmuInstance::new(&own, &own_name)?.with_tolerance(manner.tolerance);
        Ok(if manner.retries { instance.retrying() } else { instance })
    };
    Ok(match manner.same_thread {
        true => Box::new(AtHome::new(import, name, make)?),
        false => Box::new(make()?),
    })
}
