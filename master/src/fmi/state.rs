//! The states of an FMU (FMI 2.0 §2.1.8).
//!
//! In memory they let a step be tried again, as bytes they let another program go on.

use std::ffi::{CStr, c_char, c_void};
use std::ptr;

use serde::{Deserialize, Serialize};

use super::binding::{Component, FmuState, Functions, Status};
use super::instance::FmuInstance;
use super::messages::Said;
use crate::system::unit::{Unit, UnitError};

/// An instance as bytes.
#[derive(Serialize, Deserialize)]
pub(super) struct Saved {
    /// What `fmi2SerializeFMUstate` gives.
    #[serde(with = "serde_bytes")]
    pub state: Vec<u8>,
    pub said: Said,
}

impl FmuInstance {
    /// The FMU's state and what it has said, as bytes.
    pub(super) fn save_bytes(&mut self) -> Result<Vec<u8>, UnitError> {
        self.keep()?;
        let state = self.serialized();
        self.free_state();
        let saved = Saved { state: state?, said: self.messages.save() };
        Ok(postcard::to_allocvec(&saved).expect("plain data can always be serialized"))
    }

    /// Goes on from another instance's bytes.
    pub(super) fn restore_bytes(&mut self, bytes: &[u8]) -> Result<(), UnitError> {
        let saved: Saved =
            postcard::from_bytes(bytes).map_err(|error| self.differs(&error.to_string()))?;
        self.free_state();
        let (mut state, bytes) = (ptr::null_mut::<c_void>(), &saved.state);
        // SAFETY: the bytes live during the call, and the FMU sets the pointer to a state of its own.
        let read = |f: &Functions, c: Component| unsafe {
            let first = bytes.as_ptr().cast::<c_char>();
            (f.de_serialize_fmu_state)(c, first, bytes.len(), &raw mut state)
        };
        self.state_call(c"fmi2DeSerializeFMUstate", read)?;
        self.slot.0 = Some(FmuState(state));
        let set = self.go_back();
        self.free_state();
        set?;
        self.messages.restore(saved.said);
        Ok(())
    }

    /// The state in the slot as bytes.
    fn serialized(&mut self) -> Result<Vec<u8>, UnitError> {
        let Some(FmuState(state)) = self.slot.0 else { return Ok(vec![]) };
        let mut size = 0;
        // SAFETY: the state is one that this FMU gave, and there is room for a size.
        let ask =
            |f: &Functions, c| unsafe { (f.serialized_fmu_state_size)(c, state, &raw mut size) };
        self.state_call(c"fmi2SerializedFMUstateSize", ask)?;
        let mut bytes = vec![0_u8; size];
        // SAFETY: the state is one that this FMU gave, and there is room for as many bytes as it asked for.
        let write = |f: &Functions, c: Component| unsafe {
            (f.serialize_fmu_state)(c, state, bytes.as_mut_ptr().cast(), size)
        };
        self.state_call(c"fmi2SerializeFMUstate", write)?;
        Ok(bytes)
    }

    /// Saves the instance into its slot.
    pub(super) fn keep(&mut self) -> Result<(), UnitError> {
        let mut state = self.slot.0.unwrap_or(FmuState(ptr::null_mut()));
        // SAFETY: the state is null or one that this FMU gave, which it reuses.
        let save = |f: &Functions, c| unsafe { (f.get_fmu_state)(c, &raw mut state.0) };
        self.state_call(c"fmi2GetFMUstate", save)?;
        self.slot.0 = Some(state);
        Ok(())
    }

    /// Sets the instance back to what its slot holds.
    pub(super) fn go_back(&mut self) -> Result<(), UnitError> {
        let Some(FmuState(state)) = self.slot.0 else { return Ok(()) };
        // SAFETY: the state is one that this FMU gave.
        self.state_call(c"fmi2SetFMUstate", |f, c| unsafe { (f.set_fmu_state)(c, state) })
    }

    /// Gives the saved state back to the FMU.
    pub(super) fn free_state(&mut self) {
        if let Some(FmuState(mut state)) = self.slot.0.take()
            && !self.component_is_fatal()
        {
            // SAFETY: the state is one that this FMU gave, and it is not used again.
            let free = |f: &Functions, c| unsafe { (f.free_fmu_state)(c, &raw mut state) };
            let _ = self.status_of(c"fmi2FreeFMUstate", free, |_| String::new());
        }
    }

    fn state_call(
        &mut self,
        name: &CStr,
        function: impl FnOnce(&Functions, Component) -> Status,
    ) -> Result<(), UnitError> {
        self.call(name, function, |_| String::new())
    }
}
