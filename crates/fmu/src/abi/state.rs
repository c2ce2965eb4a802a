//! Saving, setting back and serializing the FMU state (§2.1.8).

use std::ffi::c_void;
use std::ptr;

use super::component::call;
use super::pointers::{array, fill};
use crate::calls::Call;
use crate::error::Error;
use crate::instance::state::SavedState;
use crate::model::Model;
use crate::status::Status;

/// Name of the argument with the state in the standard.
const STATE: &str = "FMUstate";

/// `fmi2GetFMUstate`; a state that is there already is overwritten.
pub unsafe fn get_fmu_state<M: Model>(component: *mut c_void, state: *mut *mut c_void) -> Status {
    // SAFETY: the pointers are those of the caller; the state is null or one of this FMU.
    unsafe {
        call::<M>(component, Call::GetFMUstate, |component| {
            let state = state.as_mut().ok_or(Error::NullArgument(STATE))?;
            match state.cast::<SavedState<M>>().as_mut() {
                Some(saved) => component.instance.save_into(saved)?,
                None => *state = hand_over(component.instance.save()?),
            }
            Ok(())
        })
    }
}

/// `fmi2SetFMUstate`.
pub unsafe fn set_fmu_state<M: Model>(component: *mut c_void, state: *mut c_void) -> Status {
    // SAFETY: the pointers are those of the caller; the state is null or one of this FMU.
    unsafe {
        call::<M>(component, Call::SetFMUstate, |component| {
            component.instance.restore(borrow::<M>(state)?)
        })
    }
}

/// `fmi2FreeFMUstate`; null, and a pointer to null, are ignored.
pub unsafe fn free_fmu_state<M: Model>(component: *mut c_void, state: *mut *mut c_void) -> Status {
    // SAFETY: the pointers are those of the caller; the state is null or one of this FMU, and
    // the caller gives it up.
    unsafe {
        call::<M>(component, Call::FreeFMUstate, |_| {
            if let Some(state) = state.as_mut()
                && !state.is_null()
            {
                drop(Box::from_raw(state.cast::<SavedState<M>>()));
                *state = ptr::null_mut();
            }
            Ok(())
        })
    }
}

/// `fmi2SerializedFMUstateSize`.
pub unsafe fn serialized_fmu_state_size<M: Model>(
    component: *mut c_void,
    state: *mut c_void,
    size: *mut usize,
) -> Status {
    // SAFETY: the pointers are those of the caller; the state is null or one of this FMU.
    unsafe {
        call::<M>(component, Call::SerializedFMUstateSize, |_| {
            let needed = borrow::<M>(state)?.serialized_size();
            fill("size", size, [needed].into_iter())
        })
    }
}

/// `fmi2SerializeFMUstate`.
pub unsafe fn serialize_fmu_state<M: Model>(
    component: *mut c_void,
    state: *mut c_void,
    bytes: *mut u8,
    size: usize,
) -> Status {
    // SAFETY: the pointers are those of the caller; the state is null or one of this FMU, and
    // there is room for `size` bytes.
    unsafe {
        call::<M>(component, Call::SerializeFMUstate, |_| {
            let serialized = borrow::<M>(state)?.to_bytes();
            if serialized.len() > size {
                return Err(Error::SmallBuffer { needed: serialized.len(), given: size });
            }
            fill("serializedState", bytes, serialized.into_iter())
        })
    }
}

/// `fmi2DeSerializeFMUstate`.
pub unsafe fn de_serialize_fmu_state<M: Model>(
    component: *mut c_void,
    bytes: *const u8,
    size: usize,
    state: *mut *mut c_void,
) -> Status {
    // SAFETY: the pointers are those of the caller.
    unsafe {
        call::<M>(component, Call::DeSerializeFMUstate, |component| {
            let bytes = array("serializedState", bytes, size)?;
            let state = state.as_mut().ok_or(Error::NullArgument(STATE))?;
            *state = hand_over(component.instance.deserialize_state(bytes)?);
            Ok(())
        })
    }
}

/// Gives a state to the caller, who frees it with [`free_fmu_state`].
fn hand_over<M: Model>(state: SavedState<M>) -> *mut c_void {
    Box::into_raw(Box::new(state)).cast()
}

/// The state that the caller's pointer means.
unsafe fn borrow<'a, M: Model>(state: *mut c_void) -> Result<&'a SavedState<M>, Error> {
    // SAFETY: the pointer is null or one to a state of this FMU.
    let state = unsafe { state.cast::<SavedState<M>>().as_ref() };
    state.ok_or(Error::NullArgument(STATE))
}
