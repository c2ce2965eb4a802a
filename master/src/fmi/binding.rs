//! The C functions of an FMI 2.0 co-simulation FMU (FMI 2.0 §2.1, §4.2).

use std::ffi::{c_char, c_double, c_int, c_uint, c_void};
use std::path::Path;

use libloading::Library;

/// `fmi2Component`.
pub type Component = *mut c_void;
/// `fmi2Status`.
pub type Status = c_int;
/// `fmi2ValueReference`.
pub type Reference = c_uint;

/// `fmi2OK`.
pub const OK: Status = 0;
/// `fmi2Warning`.
pub const WARNING: Status = 1;
/// `fmi2Discard`.
pub const DISCARD: Status = 2;
/// `fmi2Fatal`.
pub const FATAL: Status = 4;

/// `fmi2CallbackFunctions`.
#[repr(C)]
pub struct Callbacks {
    /// The variadic logger of `logger.c`; only its address is handed over.
    pub logger: *const c_void,
    /// `calloc`.
    pub allocate: unsafe extern "C" fn(usize, usize) -> *mut c_void,
    /// `free`.
    pub free: unsafe extern "C" fn(*mut c_void),
    /// Told when an asynchronous step has ended; none is allowed.
    pub step_finished: *const c_void,
    /// Given back to the logger.
    pub environment: *mut c_void,
}

/// Loads each function by its name; a missing one is reported by that name.
macro_rules! functions {
    ($($(#[$doc:meta])* $field:ident = $name:literal : fn($($argument:ty),*) -> $result:ty;)*) => {
        /// The functions of a binary that the master calls; all 34 must be there (§2.3).
        pub struct Functions {
            $($(#[$doc])* pub $field: unsafe extern "C" fn($($argument),*) -> $result,)*
            /// Keeps the functions valid.
            _library: Library,
        }

        impl Functions {
            /// Loads a binary.
            ///
            /// # Errors
            /// When the binary cannot be loaded or lacks a function.
            pub fn load(binary: &Path) -> Result<Self, libloading::Error> {
                // SAFETY: loading runs the binary's initialisers; to run a foreign binary is
                // what importing an FMU means, and the user has chosen the file.
                let library = unsafe { Library::new(binary)? };
                $(
                    // SAFETY: FMI 2.0 fixes the type of the function of that name.
                    let $field = *unsafe {
                        library.get::<unsafe extern "C" fn($($argument),*) -> $result>($name)?
                    };
                )*
                for name in ALSO_REQUIRED {
                    // SAFETY: the symbol is only looked up, never called.
                    unsafe { library.get::<unsafe extern "C" fn()>(*name)? };
                }
                Ok(Self { $($field,)* _library: library })
            }
        }
    };
}

functions! {
    /// `fmi2Instantiate`.
    instantiate = b"fmi2Instantiate": fn(*const c_char, c_int, *const c_char, *const c_char, *const Callbacks, c_int, c_int) -> Component;
    /// `fmi2FreeInstance`.
    free_instance = b"fmi2FreeInstance": fn(Component) -> ();
    /// `fmi2SetupExperiment`.
    setup_experiment = b"fmi2SetupExperiment": fn(Component, c_int, c_double, c_double, c_int, c_double) -> Status;
    /// `fmi2EnterInitializationMode`.
    enter_initialization = b"fmi2EnterInitializationMode": fn(Component) -> Status;
    /// `fmi2ExitInitializationMode`.
    exit_initialization = b"fmi2ExitInitializationMode": fn(Component) -> Status;
    /// `fmi2Terminate`.
    terminate = b"fmi2Terminate": fn(Component) -> Status;
    /// `fmi2GetReal`.
    get_real = b"fmi2GetReal": fn(Component, *const Reference, usize, *mut c_double) -> Status;
    /// `fmi2SetReal`.
    set_real = b"fmi2SetReal": fn(Component, *const Reference, usize, *const c_double) -> Status;
    /// `fmi2SetInteger`.
    set_integer = b"fmi2SetInteger": fn(Component, *const Reference, usize, *const c_int) -> Status;
    /// `fmi2SetString`.
    set_string = b"fmi2SetString": fn(Component, *const Reference, usize, *const *const c_char) -> Status;
    /// `fmi2DoStep`.
    do_step = b"fmi2DoStep": fn(Component, c_double, c_double, c_int) -> Status;
    /// `fmi2GetRealStatus`.
    get_real_status = b"fmi2GetRealStatus": fn(Component, c_int, *mut c_double) -> Status;
}

/// The functions that the master does not call, but every FMU must have (§2.3).
const ALSO_REQUIRED: &[&[u8]] = &[
    b"fmi2GetTypesPlatform",
    b"fmi2GetVersion",
    b"fmi2SetDebugLogging",
    b"fmi2Reset",
    b"fmi2GetInteger",
    b"fmi2GetBoolean",
    b"fmi2SetBoolean",
    b"fmi2GetString",
    b"fmi2GetFMUstate",
    b"fmi2SetFMUstate",
    b"fmi2FreeFMUstate",
    b"fmi2SerializedFMUstateSize",
    b"fmi2SerializeFMUstate",
    b"fmi2DeSerializeFMUstate",
    b"fmi2GetDirectionalDerivative",
    b"fmi2SetRealInputDerivatives",
    b"fmi2GetRealOutputDerivatives",
    b"fmi2CancelStep",
    b"fmi2GetStatus",
    b"fmi2GetIntegerStatus",
    b"fmi2GetBooleanStatus",
    b"fmi2GetStringStatus",
];

/// The name of a status.
pub fn status_name(status: Status) -> &'static str {
    match status {
        0 => "fmi2OK",
        1 => "fmi2Warning",
        2 => "fmi2Discard",
        3 => "fmi2Error",
        4 => "fmi2Fatal",
        5 => "fmi2Pending",
        _ => "a status that FMI 2.0 does not know",
    }
}
