//! What the packer asks a binary for: the texts that describe it with a resources folder.
//!
//! These functions are no part of FMI.

use std::ffi::{CString, c_char, c_int};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use super::component::panic_message;
use super::pointers::{c_text, fill, text};
use crate::description::documentation;
use crate::description::model_description;
use crate::description::terminals;
use crate::error::Error;
use crate::model::Model;

/// The text is what was asked for.
const DONE: c_int = 0;
/// The text says why there is none.
const FAILED: c_int = 1;

/// `hotfoot_model_description`: the text of `modelDescription.xml`.
pub unsafe fn describe<M: Model>(resources: *const c_char, answer: *mut *mut c_char) -> c_int {
    // SAFETY: the pointers are those of the caller.
    unsafe { give(resources, answer, model_description::<M>) }
}

/// `hotfoot_documentation`: the text of `documentation/index.html`.
pub unsafe fn document<M: Model>(resources: *const c_char, answer: *mut *mut c_char) -> c_int {
    // SAFETY: the pointers are those of the caller.
    unsafe { give(resources, answer, documentation::<M>) }
}

/// `hotfoot_terminals`: the text of `terminalsAndIcons/terminalsAndIcons.xml`, which may be empty.
pub unsafe fn connect<M: Model>(resources: *const c_char, answer: *mut *mut c_char) -> c_int {
    // SAFETY: the pointers are those of the caller.
    unsafe { give(resources, answer, terminals::<M>) }
}

/// `hotfoot_free_text`; null is ignored.
pub unsafe fn free_text<M: Model>(text: *mut c_char) {
    if !text.is_null() {
        // SAFETY: `give` made the text with `CString::into_raw`, and the caller gives it up.
        drop(unsafe { CString::from_raw(text) });
    }
}

/// Gives the caller the text, or the reason why there is none.
///
/// The caller frees it with [`free_text`].
unsafe fn give(
    resources: *const c_char,
    answer: *mut *mut c_char,
    write: fn(&Path) -> Result<String, Error>,
) -> c_int {
    let write = || {
        // SAFETY: the pointer is null or one to a text.
        let resources = unsafe { text("resources", resources) }?;
        write(Path::new(resources))
    };
    let result = catch_unwind(AssertUnwindSafe(write)).unwrap_or_else(|panic| {
        let message = panic_message(panic.as_ref());
        Err(Error::PanicInDeclaration(message))
    });
    let (code, text) = match result {
        Ok(text) => (DONE, text),
        Err(error) => (FAILED, error.to_string()),
    };
    let text = c_text(&text).into_raw();
    // SAFETY: the caller's pointer is null or has room for one pointer.
    match unsafe { fill("text", answer, [text].into_iter()) } {
        Ok(()) => code,
        Err(_) => {
            // SAFETY: the text is the one made above, which nobody else has.
            drop(unsafe { CString::from_raw(text) });
            FAILED
        }
    }
}
