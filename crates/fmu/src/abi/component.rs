//! What the functions of the C interface act on, and how each of their calls is made.

use std::any::Any;
use std::ffi::{CString, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::calls::Call;
use crate::error::Error;
use crate::instance::Instance;
use crate::model::Model;
use crate::status::Status;

/// What an `fmi2Component` points to.
pub(super) struct Component<M: Model> {
    pub(super) instance: Instance<M>,
    /// The texts that `fmi2GetString` gave last; they live until it is called again.
    pub(super) texts: Vec<CString>,
}

/// Does a call on a component, and turns its result, or a panic, into a status and a message.
pub(super) unsafe fn call<M: Model>(
    component: *mut c_void,
    call: Call,
    body: impl FnOnce(&mut Component<M>) -> Result<(), Error>,
) -> Status {
    // SAFETY: the caller gives a component of this model that nobody else uses, or null.
    let Some(component) = (unsafe { component.cast::<Component<M>>().as_mut() }) else {
        return Status::Error;
    };
    let result = catch_unwind(AssertUnwindSafe(|| body(component))).unwrap_or_else(|panic| {
        let message = panic_message(panic.as_ref());
        Err(component.instance.drop_model(call, message))
    });
    let instance = &mut component.instance;
    let warned = instance.take_warned();
    match result {
        Ok(()) if warned => Status::Warning,
        Ok(()) => Status::Ok,
        Err(error) => {
            instance.report(&error);
            error.status()
        }
    }
}

/// The text of a panic.
pub(super) fn panic_message(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(ToString::to_string);
    text.or_else(|| panic.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "no message".to_owned())
}
