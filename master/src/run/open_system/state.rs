//! The state of an open system: saved, and gone on from.

use numerics::seconds;

use super::{OpenSystem, OpenSystemError};
use crate::run::checkpoint::{Reached, RunState, from_bytes, to_bytes};
use crate::run::setup::Setup;

impl OpenSystem {
    /// All that the system needs to go on from here, bit for bit.
    ///
    /// # Errors
    /// When a unit cannot be saved.
    pub fn save(&mut self) -> Result<Vec<u8>, OpenSystemError> {
        self.check_open()?;
        let Self { setup: Setup { system, .. }, workplace, done, .. } = self;
        if let Some(unit) = system.units().find(|unit| !unit.keeps_states()) {
            return Err(OpenSystemError::Request(format!(
                "{} ({}) cannot be saved, which would take canGetAndSetFMUstate and canSerializeFMUstate",
                unit.name(),
                unit.source_file()
            )));
        }
        let parts = workplace.pool.install(|| system.save())?;
        Ok(to_bytes(&RunState {
            reached: Reached::Run(*done),
            time: system.clock.at(*done),
            times: system.times.clone(),
            parts,
            tables: vec![],
            tapes: vec![],
            fmus: vec![],
        }))
    }

    /// Goes on from where this system, or another one of the same components, was saved.
    ///
    /// # Errors
    /// When it was saved by a system of other components, or is damaged, or this one records.
    pub fn restore(&mut self, saved: &[u8]) -> Result<(), OpenSystemError> {
        self.check_open()?;
        if self.records() {
            return Err(OpenSystemError::Request(
                "a system that records only goes forward; restore the state in one without results"
                    .to_owned(),
            ));
        }
        let wrong = |reason: &str| {
            OpenSystemError::Request(format!("this is no state of such a system: {reason}"))
        };
        let state: RunState = from_bytes(saved).map_err(|reason| wrong(&reason))?;
        let Self { setup: Setup { system, steps, .. }, workplace, done, failed, early, .. } = self;
        let (Reached::Run(reached), true) =
            (state.reached, state.parts.len() == system.parts.len())
        else {
            return Err(wrong("it has other components"));
        };
        if reached > *steps {
            return Err(wrong(&format!(
                "it is at {} s, and this one ends before",
                seconds(state.time)
            )));
        }
        // Some units may have taken it when another refuses.
        *failed = true;
        workplace.pool.install(|| system.restore(state.parts))?;
        (*done, *failed, *early) = (reached, false, None);
        Ok(())
    }
}
