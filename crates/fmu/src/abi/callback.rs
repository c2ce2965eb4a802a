//! The functions that a simulation tool hands over, of which the logger is used (§2.1.5).

use std::ffi::{CString, c_char, c_int, c_void};

use super::pointers::c_text;
use crate::instance::logging::Category;

/// `fmi2CallbackFunctions`.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct CallbackFunctions {
    /// Shows a message to the user: environment, instance, status, category, format, arguments.
    pub logger: Option<
        unsafe extern "C" fn(*mut c_void, *const c_char, c_int, *const c_char, *const c_char, ...),
    >,
    /// Not used: see `canNotUseMemoryManagementFunctions`.
    pub allocate_memory: Option<unsafe extern "C" fn(usize, usize) -> *mut c_void>,
    /// Not used, as above.
    pub free_memory: Option<unsafe extern "C" fn(*mut c_void)>,
    /// Not used: no step runs asynchronously.
    pub step_finished: Option<unsafe extern "C" fn(*mut c_void, c_int)>,
    /// The tool's own; goes back to the logger untouched.
    pub component_environment: *mut c_void,
}

/// Passes messages to the tool's logger.
#[derive(Clone)]
pub(super) struct Callback {
    functions: CallbackFunctions,
    instance_name: CString,
}

// SAFETY: an instance may be used by any one thread at a time, so its messages come from that
// thread; the standard wants the tool's logger to be callable from where it calls the FMU.
unsafe impl Send for Callback {}

impl Callback {
    /// A logger for the instance of this name.
    pub(super) fn new(functions: CallbackFunctions, instance_name: &str) -> Self {
        Self { functions, instance_name: c_text(instance_name) }
    }

    /// Shows a message to the user.
    pub(super) fn message(&self, category: Category, text: &str) {
        let Some(logger) = self.functions.logger else {
            return;
        };
        let (name, text) = (c_text(category.name()), c_text(text));
        // SAFETY: the tool's logger takes these arguments. The text is an argument of the
        // format "%s", so that a `%` in it does no harm. All texts outlive the call.
        unsafe {
            logger(
                self.functions.component_environment,
                self.instance_name.as_ptr(),
                category.status() as c_int,
                name.as_ptr(),
                c"%s".as_ptr(),
                text.as_ptr(),
            );
        }
    }
}
