//! Which FMU a thread is calling, for the message when the FMU crashes the program.

use std::ffi::{CStr, c_char};
use std::ptr;

unsafe extern "C" {
    /// Defined in `crash.c`.
    fn hotfoot_watch_crashes();
    fn hotfoot_now_calling(instance: *const c_char, function: *const c_char);
}

/// Lets the program say, when it crashes, which FMU was at work.
pub fn watch() {
    // SAFETY: it sets signal handlers that call nothing but what signal handlers may call.
    unsafe { hotfoot_watch_crashes() };
}

/// Notes that this thread calls `function` of the FMU that `label` names, while `call` runs.
pub(super) fn calling<T>(label: &CStr, function: &CStr, call: impl FnOnce() -> T) -> T {
    // SAFETY: both texts live until the note is cleared below.
    unsafe { hotfoot_now_calling(label.as_ptr(), function.as_ptr()) };
    let result = call();
    // SAFETY: null clears the note.
    unsafe { hotfoot_now_calling(ptr::null(), ptr::null()) };
    result
}
