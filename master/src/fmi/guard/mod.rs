//! What is checked around every call of an FMU.
//!
//! | file | part |
//! |---|---|
//! | `arrays.rs` | the arrays that an FMU is handed, with guard words around them |
//! | `environment.rs` | how the processor computes: rounding, denormal numbers, exceptions |

pub mod arrays;
pub mod environment;

use std::ffi::CStr;

use super::messages::Messages;
use super::watched::{Label, calling};
use environment::Environment;

/// Calls `function` of the instance that `label` names and whose messages these are. What the call
/// changes of how the processor computes is put back and noted.
pub(super) fn guarded<T>(
    messages: &'static Messages,
    label: Label,
    function: &CStr,
    call: impl FnOnce() -> T,
) -> T {
    let before = Environment::now();
    let outer = messages.enter();
    let result = calling(label, function, call);
    Messages::leave(outer);
    if let Some(change) = before.put_back() {
        messages.note_environment(&format!("{} left {change}", function.to_string_lossy()));
    }
    result
}
