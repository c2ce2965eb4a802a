//! What an FMU may call: the logger and the memory functions.

use std::ffi::{CStr, c_char, c_int, c_void};
use std::path::Path;

use super::binding::Callbacks;
use super::messages::Messages;

unsafe extern "C" {
    /// Defined in `logger.c`.
    fn hotfoot_logger();
    fn calloc(count: usize, size: usize) -> *mut c_void;
    fn free(memory: *mut c_void);
}

/// The callbacks of the instance whose messages these are. They live as long as the process, as an FMU
/// may hold on to them, and threads of its own may outlive it.
pub fn callbacks(messages: &'static Messages) -> &'static Callbacks {
    Box::leak(Box::new(Callbacks {
        logger: hotfoot_logger as *const c_void,
        allocate: calloc,
        free,
        step_finished: std::ptr::null(),
        environment: std::ptr::from_ref(messages).cast_mut().cast(),
    }))
}

/// Called by `logger.c` with the formatted message. The environment is whatever the FMU hands back.
///
/// # Safety
/// `caller` and `message` are C strings.
#[unsafe(no_mangle)]
unsafe extern "C" fn hotfoot_take_message(
    environment: *mut c_void,
    caller: *const c_char,
    status: c_int,
    message: *const c_char,
) {
    // SAFETY: `logger.c` passes two C strings; the environment is only compared.
    let (caller, text) = unsafe {
        (CStr::from_ptr(caller).to_string_lossy(), CStr::from_ptr(message).to_string_lossy())
    };
    Messages::take_in(environment.addr(), Path::new(&*caller), status, &text);
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
        let messages = Messages::of("vehicle", Path::new("vehicle.so"));
        let callbacks = callbacks(messages);
        let log = logger(callbacks);
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
}
