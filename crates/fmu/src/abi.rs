//! The C interface: functions over a model type, to which [`export!`](crate::export) gives their
//! C names.
//!
//! They turn pointers into Rust values and results into statuses; what a call does is in
//! [`Instance`]. No panic leaves them.
//!
//! # Safety
//! All functions ask of their caller what the standard asks of a simulation tool:
//! - a component is one that `instantiate` of the same model gave and that was not freed, and no
//!   other call uses it at the same time;
//! - an FMU state is one that the same FMU gave and that was not freed;
//! - a pointer that is not null points to as many readable or writable elements as the argument
//!   for their number says, and a text ends with a NUL.
//!
//! Null pointers are refused with a message, unless the standard gives them a meaning.
#![allow(unsafe_code, reason = "C passes pointers; this module turns them into safe values")]
#![allow(
    clippy::missing_safety_doc,
    reason = "all functions have the contract stated for the module"
)]

mod callback;
mod describe;
mod exchange;
mod life_cycle;
mod pointers;
mod state;
mod status;

use std::any::Any;
use std::ffi::{CString, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::calls::Call;
use crate::error::Error;
use crate::instance::Instance;
use crate::model::Model;
use crate::status::Status;

pub use callback::CallbackFunctions;
pub use describe::*;
pub use exchange::*;
pub use life_cycle::*;
pub use state::*;
pub use status::*;

/// What an `fmi2Component` points to.
struct Component<M: Model> {
    instance: Instance<M>,
    /// The texts that `fmi2GetString` gave last; they live until it is called again.
    texts: Vec<CString>,
}

/// Does a call on a component, and turns its result, or a panic, into a status and a message.
unsafe fn call<M: Model>(
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
        Err(component.instance.give_up(call, message))
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
fn panic_message(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(ToString::to_string);
    text.or_else(|| panic.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "no message".to_owned())
}
