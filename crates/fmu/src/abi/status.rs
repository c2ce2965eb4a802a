//! Cancelling a step, and asking for its status (§4.2.2, §4.2.3).

use std::ffi::{c_char, c_int, c_void};

use super::component::call;
use super::pointers::fill;
use crate::calls::Call;
use crate::error::Error;
use crate::model::Model;
use crate::status::Status;

/// `fmi2LastSuccessfulTime` of `fmi2StatusKind`.
const LAST_SUCCESSFUL_TIME: c_int = 2;
/// `fmi2Terminated` of `fmi2StatusKind`.
const TERMINATED: c_int = 3;

/// `fmi2CancelStep`: no step runs when it is called, so none can be cancelled.
pub unsafe fn cancel_step<M: Model>(component: *mut c_void) -> Status {
    let flag = "canRunAsynchronuously=\"false\"";
    // SAFETY: the component is the caller's.
    unsafe {
        call::<M>(component, Call::CancelStep, |component| {
            component.instance.refuse(Call::CancelStep, flag)
        })
    }
}

/// `fmi2GetRealStatus`: the time up to which the last step succeeded.
pub unsafe fn get_real_status<M: Model>(
    component: *mut c_void,
    kind: c_int,
    value: *mut f64,
) -> Status {
    // SAFETY: the pointers are those of the caller.
    unsafe {
        call::<M>(component, Call::GetRealStatus, |component| {
            component.instance.check(Call::GetRealStatus)?;
            match kind {
                LAST_SUCCESSFUL_TIME => {
                    fill("value", value, [component.instance.time()].into_iter())
                }
                _ => no_status(Call::GetRealStatus, kind),
            }
        })
    }
}

/// `fmi2GetBooleanStatus`: whether the instance wants to end the simulation; it never does.
pub unsafe fn get_boolean_status<M: Model>(
    component: *mut c_void,
    kind: c_int,
    value: *mut c_int,
) -> Status {
    // SAFETY: the pointers are those of the caller.
    unsafe {
        call::<M>(component, Call::GetBooleanStatus, |component| {
            component.instance.check(Call::GetBooleanStatus)?;
            match kind {
                TERMINATED => fill("value", value, [0].into_iter()),
                _ => no_status(Call::GetBooleanStatus, kind),
            }
        })
    }
}

/// `fmi2GetStatus`: only an asynchronous step has one.
pub unsafe fn get_status<M: Model>(
    component: *mut c_void,
    kind: c_int,
    _value: *mut c_int,
) -> Status {
    // SAFETY: the component is the caller's.
    unsafe { no_status_of::<M>(component, Call::GetStatus, kind) }
}

/// `fmi2GetIntegerStatus`: there is no status of this type.
pub unsafe fn get_integer_status<M: Model>(
    component: *mut c_void,
    kind: c_int,
    _value: *mut c_int,
) -> Status {
    // SAFETY: the component is the caller's.
    unsafe { no_status_of::<M>(component, Call::GetIntegerStatus, kind) }
}

/// `fmi2GetStringStatus`: only an asynchronous step has one.
pub unsafe fn get_string_status<M: Model>(
    component: *mut c_void,
    kind: c_int,
    _value: *mut *const c_char,
) -> Status {
    // SAFETY: the component is the caller's.
    unsafe { no_status_of::<M>(component, Call::GetStringStatus, kind) }
}

unsafe fn no_status_of<M: Model>(component: *mut c_void, asked: Call, kind: c_int) -> Status {
    // SAFETY: the component is the caller's.
    unsafe {
        call::<M>(component, asked, |component| {
            component.instance.check(asked)?;
            no_status(asked, kind)
        })
    }
}

fn no_status(call: Call, kind: c_int) -> Result<(), Error> {
    Err(Error::NoStatus { call, kind })
}
