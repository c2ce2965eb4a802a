//! From `fmi2Instantiate` to `fmi2FreeInstance` (§2.1.5, §2.1.6, §4.2.1).

use std::ffi::{c_char, c_int, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;

use super::callback::{Callback, CallbackFunctions};
use super::component::{Component, call, panic_message};
use super::pointers::{text, texts};
use super::resource_location::path_of;
use crate::calls::Call;
use crate::error::Error;
use crate::instance::Instance;
use crate::instance::logging::Category;
use crate::model::Model;
use crate::status::Status;

/// `fmi2CoSimulation` of `fmi2Type`.
const CO_SIMULATION: c_int = 1;

/// `fmi2GetTypesPlatform`.
pub unsafe fn get_types_platform<M: Model>() -> *const c_char {
    c"default".as_ptr()
}

/// `fmi2GetVersion`.
pub unsafe fn get_version<M: Model>() -> *const c_char {
    c"2.0".as_ptr()
}

/// `fmi2Instantiate`; gives null, and says why, if no instance can be made.
pub unsafe fn instantiate<M: Model>(
    instance_name: *const c_char,
    fmu_type: c_int,
    guid: *const c_char,
    resource_location: *const c_char,
    functions: *const CallbackFunctions,
    _visible: c_int,
    logging_on: c_int,
) -> *mut c_void {
    // SAFETY: the caller's pointer is null or one to callback functions.
    let Some(&functions) = (unsafe { functions.as_ref() }) else {
        return ptr::null_mut();
    };
    // SAFETY: the caller's pointer is null or one to a text.
    let name = unsafe { text("instanceName", instance_name) };
    let callback = Callback::new(functions, name.as_deref().unwrap_or_default());
    let make = || {
        // SAFETY: the pointers are those of the caller.
        unsafe { make::<M>(name?, fmu_type, guid, resource_location, &callback, logging_on) }
    };
    let result = catch_unwind(AssertUnwindSafe(make)).unwrap_or_else(|panic| {
        let message = panic_message(panic.as_ref());
        Err(Error::PanicInDeclaration(message))
    });
    match result {
        Ok(component) => Box::into_raw(Box::new(component)).cast(),
        Err(error) => {
            callback.message(Category::Error, &error.to_string());
            ptr::null_mut()
        }
    }
}

unsafe fn make<M: Model>(
    name: &str,
    fmu_type: c_int,
    guid: *const c_char,
    resource_location: *const c_char,
    callback: &Callback,
    logging_on: c_int,
) -> Result<Component<M>, Error> {
    if fmu_type != CO_SIMULATION {
        return Err(Error::NotCoSimulation);
    }
    // SAFETY: the pointer is null or one to a text.
    let guid = unsafe { text("fmuGUID", guid) }?;
    let resources = match resource_location.is_null() {
        true => path_of("")?,
        // SAFETY: the pointer is one to a text.
        false => path_of(unsafe { text("fmuResourceLocation", resource_location) }?)?,
    };
    let callback = callback.clone();
    let sink = Box::new(move |category, message: &str| callback.message(category, message));
    let mut instance = Instance::new(&resources, name, sink)?;
    instance.check_guid(guid)?;
    instance.set_debug_logging(logging_on != 0, &[])?;
    Ok(Component { instance, texts: Vec::new() })
}

/// `fmi2FreeInstance`; null is ignored.
pub unsafe fn free_instance<M: Model>(component: *mut c_void) {
    if component.is_null() {
        return;
    }
    // SAFETY: `instantiate` made the component with `Box::into_raw`, and the caller gives it up.
    let component = unsafe { Box::from_raw(component.cast::<Component<M>>()) };
    // A panic while dropping must not pass into C; there is nobody left to tell.
    let _ = catch_unwind(AssertUnwindSafe(|| drop(component)));
}

/// `fmi2SetDebugLogging`.
pub unsafe fn set_debug_logging<M: Model>(
    component: *mut c_void,
    logging_on: c_int,
    count: usize,
    categories: *const *const c_char,
) -> Status {
    // SAFETY: the pointers are those of the caller.
    unsafe {
        call::<M>(component, Call::SetDebugLogging, |component| {
            let categories = texts("categories", categories, count)?;
            component.instance.set_debug_logging(logging_on != 0, &categories)
        })
    }
}

/// `fmi2SetupExperiment`; the models step with fixed steps, so a tolerance has no effect.
pub unsafe fn setup_experiment<M: Model>(
    component: *mut c_void,
    _tolerance_defined: c_int,
    _tolerance: f64,
    start_time: f64,
    stop_time_defined: c_int,
    stop_time: f64,
) -> Status {
    let stop_time = (stop_time_defined != 0).then_some(stop_time);
    // SAFETY: the component is the caller's.
    unsafe {
        call::<M>(component, Call::SetupExperiment, |component| {
            component.instance.setup_experiment(start_time, stop_time)
        })
    }
}

/// `fmi2EnterInitializationMode`.
pub unsafe fn enter_initialization_mode<M: Model>(component: *mut c_void) -> Status {
    // SAFETY: the component is the caller's.
    unsafe {
        call::<M>(component, Call::EnterInitializationMode, |component| {
            component.instance.enter_initialization_mode()
        })
    }
}

/// `fmi2ExitInitializationMode`.
pub unsafe fn exit_initialization_mode<M: Model>(component: *mut c_void) -> Status {
    // SAFETY: the component is the caller's.
    unsafe {
        call::<M>(component, Call::ExitInitializationMode, |component| {
            component.instance.exit_initialization_mode()
        })
    }
}

/// `fmi2DoStep`; a state may be set back at any time, so the last argument has no effect.
pub unsafe fn do_step<M: Model>(
    component: *mut c_void,
    current_communication_point: f64,
    communication_step_size: f64,
    _no_set_fmu_state_prior_to_current_point: c_int,
) -> Status {
    // SAFETY: the component is the caller's.
    unsafe {
        call::<M>(component, Call::DoStep, |component| {
            let instance = &mut component.instance;
            instance.do_step(current_communication_point, communication_step_size)
        })
    }
}

/// `fmi2Terminate`.
pub unsafe fn terminate<M: Model>(component: *mut c_void) -> Status {
    // SAFETY: the component is the caller's.
    unsafe { call::<M>(component, Call::Terminate, |component| component.instance.terminate()) }
}

/// `fmi2Reset`.
pub unsafe fn reset<M: Model>(component: *mut c_void) -> Status {
    // SAFETY: the component is the caller's.
    unsafe { call::<M>(component, Call::Reset, |component| component.instance.reset()) }
}
