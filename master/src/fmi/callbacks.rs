//! What an FMU may call: the logger and the memory functions.

use std::ffi::{CStr, c_char, c_int, c_void};
use std::sync::Mutex;

use super::binding::Callbacks;

unsafe extern "C" {
    /// Defined in `logger.c`.
    fn hotfoot_logger();
    fn calloc(count: usize, size: usize) -> *mut c_void;
    fn free(memory: *mut c_void);
}

/// Collects the messages of one instance: the last one for error messages, and warnings.
#[derive(Default)]
pub struct Messages {
    content: Mutex<Content>,
}

#[derive(Default)]
struct Content {
    last: Option<String>,
    warnings: Vec<String>,
    /// Whether a message has come that explains a warning not yet noted.
    warned: bool,
}

/// Warnings kept per instance; an FMU that warns in each step must not fill the memory.
const MAX_WARNINGS: usize = 20;

impl Messages {
    /// The last message.
    pub fn last(&self) -> Option<String> {
        self.content.lock().ok()?.last.clone()
    }

    /// Takes the warnings out.
    pub fn take_warnings(&self) -> Vec<String> {
        self.content.lock().map(|mut c| std::mem::take(&mut c.warnings)).unwrap_or_default()
    }

    /// Keeps a warning that came without a message since the one before.
    pub fn note_warning(&self, action: &str) {
        if let Ok(mut content) = self.content.lock()
            && !std::mem::take(&mut content.warned)
            && content.warnings.len() < MAX_WARNINGS
        {
            content.warnings.push(format!("{action} returned fmi2Warning without a message"));
        }
    }

    fn add(&self, status: c_int, message: String) {
        if let Ok(mut content) = self.content.lock() {
            if status != super::binding::OK {
                content.warned = true;
                if content.warnings.len() < MAX_WARNINGS {
                    content.warnings.push(message.clone());
                }
            }
            content.last = Some(message);
        }
    }
}

/// The callbacks that log into `messages`, which must outlive the instance.
pub fn callbacks(messages: &Messages) -> Callbacks {
    Callbacks {
        logger: hotfoot_logger as *const c_void,
        allocate: calloc,
        free,
        step_finished: std::ptr::null(),
        environment: std::ptr::from_ref(messages).cast_mut().cast(),
    }
}

/// Called by `logger.c` with the formatted message.
///
/// # Safety
/// `environment` comes from [`callbacks`]; `message` is a C string.
#[unsafe(no_mangle)]
unsafe extern "C" fn hotfoot_take_message(
    environment: *mut c_void,
    status: c_int,
    _category: *const c_char,
    message: *const c_char,
) {
    if environment.is_null() {
        return;
    }
    // SAFETY: `callbacks` set the environment to a `Messages` that outlives the instance, and
    // `logger.c` passes its own buffer, which ends with zero.
    let (messages, text) =
        unsafe { (&*environment.cast::<Messages>(), CStr::from_ptr(message).to_string_lossy()) };
    messages.add(status, text.into_owned());
}
