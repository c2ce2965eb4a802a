//! What an FMU may call: the logger and the memory functions.

use std::ffi::{CStr, c_char, c_int, c_void};
use std::sync::Mutex;

use serde::{Deserialize, Serialize};

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

/// What an instance has said so far.
#[derive(Clone, Default, Serialize, Deserialize)]
pub struct Content {
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

    /// What the instance has said so far, to be saved.
    pub fn content(&self) -> Content {
        self.content.lock().map(|content| content.clone()).unwrap_or_default()
    }

    /// Goes on from what another instance had said.
    pub fn set_content(&self, said: Content) {
        if let Ok(mut content) = self.content.lock() {
            *content = said;
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    /// `fmi2CallbackLogger` of FMI 2.0 §2.1.5: environment, instance, status, category, format and what it
    /// formats.
    type Logger =
        unsafe extern "C" fn(*mut c_void, *const c_char, c_int, *const c_char, *const c_char, ...);

    fn logger(callbacks: &Callbacks) -> Logger {
        // SAFETY: `logger.c` defines the function with this type.
        unsafe { std::mem::transmute::<*const c_void, Logger>(callbacks.logger) }
    }

    /// The message is formatted as `printf` of C does (C11, 7.21.6.1).
    #[test]
    fn what_an_fmu_logs_is_formatted() {
        let messages = Messages::default();
        let callbacks = callbacks(&messages);
        let log = logger(&callbacks);
        // SAFETY: the texts are C strings, and the arguments those of the format.
        unsafe {
            log(
                callbacks.environment,
                c"vehicle".as_ptr(),
                super::super::binding::WARNING,
                c"logStatusWarning".as_ptr(),
                c"%s wheel lifts at %.2f s, %d times".as_ptr(),
                c"left".as_ptr(),
                1.5_f64,
                3,
            );
        }
        let expected = "left wheel lifts at 1.50 s, 3 times";
        assert_eq!(messages.last().as_deref(), Some(expected));
        assert_eq!(messages.take_warnings(), [expected]);
        assert!(messages.take_warnings().is_empty(), "they are taken out");
    }

    #[test]
    fn a_warning_without_message_is_noted_and_one_with_a_message_is_not_noted_twice() {
        let messages = Messages::default();
        messages.note_warning("fmi2DoStep");
        assert_eq!(messages.take_warnings(), ["fmi2DoStep returned fmi2Warning without a message"]);
        messages.add(super::super::binding::WARNING, "low oil".to_owned());
        messages.note_warning("fmi2DoStep");
        assert_eq!(messages.take_warnings(), ["low oil"]);
    }

    #[test]
    fn an_fmu_that_warns_in_each_step_does_not_fill_the_memory() {
        let messages = Messages::default();
        for step in 0..1000 {
            messages.add(super::super::binding::WARNING, format!("step {step}"));
        }
        assert_eq!(messages.take_warnings().len(), MAX_WARNINGS);
        assert_eq!(messages.last().as_deref(), Some("step 999"), "the last one explains an error");
    }

    #[test]
    fn an_ordinary_message_is_no_warning() {
        let messages = Messages::default();
        messages.add(super::super::binding::OK, "started".to_owned());
        assert_eq!(messages.last().as_deref(), Some("started"));
        assert!(messages.take_warnings().is_empty());
    }
}
