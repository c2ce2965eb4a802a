//! How an instance of an FMU is called.

use std::sync::Arc;

use super::home::AtHome;
use super::import::Import;
use super::instance::FmuInstance;
#[cfg(target_os = "linux")]
use super::isolated::Isolated;
use crate::system::structure::Home;
use crate::system::unit::{Unit, UnitError};

/// How an instance is called.
#[derive(Debug, Clone, Copy, Default)]
pub struct Manner {
    /// Whether a step that it discards is tried again in parts.
    pub retries: bool,
    /// Where it is made, called and freed.
    pub home: Home,
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
    Ok(match manner.home {
        Home::AnyThread => Box::new(make()?),
        Home::OwnThread => Box::new(AtHome::new(import, name, make)?),
        #[cfg(target_os = "linux")]
        Home::OwnProcess => {
            Box::new(Isolated::new(import, name, (manner.tolerance, manner.retries))?)
        }
        #[cfg(not(target_os = "linux"))]
        Home::OwnProcess => return Err(not_here(import, name)),
    })
}

/// The error of an FMU that is wanted in a process of its own where there is no way to do so.
#[cfg(not(target_os = "linux"))]
fn not_here(import: &Import, name: &str) -> UnitError {
    UnitError {
        instance: name.into(),
        source_file: import.file().into(),
        action: "a process of its own".into(),
        status: None,
        last_message: Some("an FMU can be isolated on Linux only; leave `isolate` out".into()),
    }
}
