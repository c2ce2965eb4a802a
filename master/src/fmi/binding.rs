//! The C functions of an FMI 2.0 co-simulation FMU (FMI 2.0 §2.1, §4.2).

use std::error::Error;
use std::ffi::{CStr, c_char, c_double, c_int, c_uint, c_void};
use std::path::Path;

use super::library::LoadedLibrary;

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
/// `fmi2Pending`.
pub const PENDING: Status = 5;

/// `fmi2DoStepStatus` of `fmi2StatusKind`.
pub const DO_STEP_STATUS: c_int = 0;
/// `fmi2LastSuccessfulTime` of `fmi2StatusKind`.
pub const LAST_SUCCESSFUL_TIME: c_int = 2;
/// `fmi2Terminated` of `fmi2StatusKind`.
pub const TERMINATED: c_int = 3;

/// `fmi2FMUstate`: belongs to the FMU that gave it.
#[derive(Debug, Clone, Copy)]
pub struct FmuState(pub *mut c_void);

/// `fmi2CallbackFunctions`.
#[repr(C)]
pub struct Callbacks {
    /// The variadic logger of `logger.c`; only its address is handed over.
    pub logger: *const c_void,
    /// `calloc`.
    pub allocate: unsafe extern "C" fn(usize, usize) -> *mut c_void,
    /// `free`.
    pub free: unsafe extern "C" fn(*mut c_void),
    /// Called when an asynchronous step has ended; may be null.
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
            library: LoadedLibrary,
        }

        impl Functions {
            /// Loads a binary of the FMU that messages call `subject`.
            ///
            /// # Errors
            /// When the binary cannot be loaded or lacks a function.
            pub fn load(binary: &Path, subject: &str) -> Result<Self, libloading::Error> {
                let library = LoadedLibrary::load(binary, subject)?;
                $(
                    // SAFETY: FMI 2.0 fixes the type of the function of that name.
                    let $field = unsafe {
                        library.get::<unsafe extern "C" fn($($argument),*) -> $result>($name)?
                    };
                )*
                for name in ALSO_REQUIRED {
                    // SAFETY: the symbol is only looked up, never called.
                    unsafe { library.get::<unsafe extern "C" fn()>(*name)? };
                }
                Ok(Self { $($field,)* library })
            }

            /// What `fmi2GetVersion` and `fmi2GetTypesPlatform` answer.
            pub fn version_and_platform(&self) -> (String, String) {
                let text = |name: &CStr, function: unsafe extern "C" fn() -> *const c_char| {
                    // SAFETY: the functions take nothing and may be called at any time.
                    let pointer = self.library.calling(name, || unsafe { function() });
                    match pointer.is_null() {
                        true => String::new(),
                        // SAFETY: they give texts that live as long as the binary is loaded.
                        false => unsafe { CStr::from_ptr(pointer) }.to_string_lossy().into_owned(),
                    }
                };
                (
                    text(c"fmi2GetVersion", self.get_version),
                    text(c"fmi2GetTypesPlatform", self.get_types_platform),
                )
            }
        }

        /// Names of the functions that the master calls.
        const CALLED: &[&[u8]] = &[$($name),*];
    };
}

functions! {
    /// `fmi2GetTypesPlatform`.
    get_types_platform = b"fmi2GetTypesPlatform": fn() -> *const c_char;
    /// `fmi2GetVersion`.
    get_version = b"fmi2GetVersion": fn() -> *const c_char;
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
    /// `fmi2GetInteger`.
    get_integer = b"fmi2GetInteger": fn(Component, *const Reference, usize, *mut c_int) -> Status;
    /// `fmi2SetInteger`.
    set_integer = b"fmi2SetInteger": fn(Component, *const Reference, usize, *const c_int) -> Status;
    /// `fmi2GetBoolean`.
    get_boolean = b"fmi2GetBoolean": fn(Component, *const Reference, usize, *mut c_int) -> Status;
    /// `fmi2SetBoolean`.
    set_boolean = b"fmi2SetBoolean": fn(Component, *const Reference, usize, *const c_int) -> Status;
    /// `fmi2GetString`.
    get_string = b"fmi2GetString": fn(Component, *const Reference, usize, *mut *const c_char) -> Status;
    /// `fmi2SetString`.
    set_string = b"fmi2SetString": fn(Component, *const Reference, usize, *const *const c_char) -> Status;
    /// `fmi2DoStep`.
    do_step = b"fmi2DoStep": fn(Component, c_double, c_double, c_int) -> Status;
    /// `fmi2CancelStep`.
    cancel_step = b"fmi2CancelStep": fn(Component) -> Status;
    /// `fmi2GetFMUstate`.
    get_fmu_state = b"fmi2GetFMUstate": fn(Component, *mut *mut c_void) -> Status;
    /// `fmi2SetFMUstate`.
    set_fmu_state = b"fmi2SetFMUstate": fn(Component, *mut c_void) -> Status;
    /// `fmi2FreeFMUstate`.
    free_fmu_state = b"fmi2FreeFMUstate": fn(Component, *mut *mut c_void) -> Status;
    /// `fmi2SerializedFMUstateSize`.
    serialized_fmu_state_size = b"fmi2SerializedFMUstateSize": fn(Component, *mut c_void, *mut usize) -> Status;
    /// `fmi2SerializeFMUstate`.
    serialize_fmu_state = b"fmi2SerializeFMUstate": fn(Component, *mut c_void, *mut c_char, usize) -> Status;
    /// `fmi2DeSerializeFMUstate`.
    de_serialize_fmu_state = b"fmi2DeSerializeFMUstate": fn(Component, *const c_char, usize, *mut *mut c_void) -> Status;
    /// `fmi2GetStatus`.
    get_status = b"fmi2GetStatus": fn(Component, c_int, *mut Status) -> Status;
    /// `fmi2GetBooleanStatus`.
    get_boolean_status = b"fmi2GetBooleanStatus": fn(Component, c_int, *mut c_int) -> Status;
    /// `fmi2GetRealStatus`.
    get_real_status = b"fmi2GetRealStatus": fn(Component, c_int, *mut c_double) -> Status;
}

/// The functions that the master does not call, but every FMU must have (§2.3).
const ALSO_REQUIRED: &[&[u8]] = &[
    b"fmi2SetDebugLogging",
    b"fmi2Reset",
    b"fmi2GetDirectionalDerivative",
    b"fmi2SetRealInputDerivatives",
    b"fmi2GetRealOutputDerivatives",
    b"fmi2GetIntegerStatus",
    b"fmi2GetStringStatus",
];

/// The status of that name.
#[cfg(target_os = "linux")]
pub fn known_status(name: &str) -> &'static str {
    (OK..=PENDING).map(status_name).find(|known| *known == name).unwrap_or(status_name(-1))
}

/// The functions that a binary of the FMU `subject` lacks of the 34 that every FMU must have.
///
/// # Errors
/// When the binary cannot be loaded.
pub fn missing_functions(binary: &Path, subject: &str) -> Result<Vec<String>, libloading::Error> {
    let library = LoadedLibrary::load(binary, subject)?;
    // SAFETY: the symbol is only looked up, never called.
    let lacks = |name: &[u8]| unsafe { library.get::<unsafe extern "C" fn()>(name) }.is_err();
    let names = CALLED.iter().chain(ALSO_REQUIRED).filter(|name| lacks(name));
    Ok(names.map(|name| String::from_utf8_lossy(name).into_owned()).collect())
}

/// Why a binary cannot be loaded, as the system says: which library or function is missing.
pub fn reason(error: &libloading::Error) -> String {
    match error.source() {
        Some(source) => source.to_string(),
        None => error.to_string(),
    }
}

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
