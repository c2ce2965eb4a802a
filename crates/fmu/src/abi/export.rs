//! Gives the functions of the C interface their names.

/// Exports a model as an FMI 2.0 co-simulation FMU.
///
/// `fmu::export!(vehicle::Vehicle);` is all that the library of an FMU contains.
///
/// The 34 functions of the standard come without prefix, as §2.1.1 wants for shared libraries.
/// Besides them the packer finds
///
/// ```c
/// int  hotfoot_model_description(const char* resources, char** text);
/// int  hotfoot_documentation(const char* resources, char** text);
/// int  hotfoot_terminals(const char* resources, char** text);
/// void hotfoot_free_text(char* text);
/// ```
///
/// which write `modelDescription.xml`, `documentation/index.html` and `terminalsAndIcons.xml` for
/// the files in the folder `resources` (a path, not a URI): they return 0, or 1 if `text` says why
/// it could not be done.
#[macro_export]
macro_rules! export {
    ($model:ty) => {
        #[doc(hidden)]
        type ExportedModel = $model;

        #[allow(unsafe_code, reason = "the names of the C interface")]
        #[allow(non_snake_case, reason = "the standard gives the names")]
        mod fmi2 {
            use super::ExportedModel;
            use std::ffi::{c_char, c_int, c_void};
            use $crate::{abi::CallbackFunctions, Status};

            $crate::export_functions! { ExportedModel;
                fmi2GetTypesPlatform = get_types_platform() -> *const c_char;
                fmi2GetVersion = get_version() -> *const c_char;
                fmi2SetDebugLogging = set_debug_logging(component: *mut c_void, logging_on: c_int, count: usize, categories: *const *const c_char) -> Status;

                fmi2Instantiate = instantiate(name: *const c_char, fmu_type: c_int, guid: *const c_char, resource_location: *const c_char, functions: *const CallbackFunctions, visible: c_int, logging_on: c_int) -> *mut c_void;
                fmi2FreeInstance = free_instance(component: *mut c_void) -> ();
                fmi2SetupExperiment = setup_experiment(component: *mut c_void, tolerance_defined: c_int, tolerance: f64, start_time: f64, stop_time_defined: c_int, stop_time: f64) -> Status;
                fmi2EnterInitializationMode = enter_initialization_mode(component: *mut c_void) -> Status;
                fmi2ExitInitializationMode = exit_initialization_mode(component: *mut c_void) -> Status;
                fmi2Terminate = terminate(component: *mut c_void) -> Status;
                fmi2Reset = reset(component: *mut c_void) -> Status;

                fmi2GetReal = get_real(component: *mut c_void, references: *const u32, count: usize, values: *mut f64) -> Status;
                fmi2GetInteger = get_integer(component: *mut c_void, references: *const u32, count: usize, values: *mut i32) -> Status;
                fmi2GetBoolean = get_boolean(component: *mut c_void, references: *const u32, count: usize, values: *mut c_int) -> Status;
                fmi2GetString = get_string(component: *mut c_void, references: *const u32, count: usize, values: *mut *const c_char) -> Status;
                fmi2SetReal = set_real(component: *mut c_void, references: *const u32, count: usize, values: *const f64) -> Status;
                fmi2SetInteger = set_integer(component: *mut c_void, references: *const u32, count: usize, values: *const i32) -> Status;
                fmi2SetBoolean = set_boolean(component: *mut c_void, references: *const u32, count: usize, values: *const c_int) -> Status;
                fmi2SetString = set_string(component: *mut c_void, references: *const u32, count: usize, values: *const *const c_char) -> Status;

                fmi2GetFMUstate = get_fmu_state(component: *mut c_void, state: *mut *mut c_void) -> Status;
                fmi2SetFMUstate = set_fmu_state(component: *mut c_void, state: *mut c_void) -> Status;
                fmi2FreeFMUstate = free_fmu_state(component: *mut c_void, state: *mut *mut c_void) -> Status;
                fmi2SerializedFMUstateSize = serialized_fmu_state_size(component: *mut c_void, state: *mut c_void, size: *mut usize) -> Status;
                fmi2SerializeFMUstate = serialize_fmu_state(component: *mut c_void, state: *mut c_void, bytes: *mut u8, size: usize) -> Status;
                fmi2DeSerializeFMUstate = de_serialize_fmu_state(component: *mut c_void, bytes: *const u8, size: usize, state: *mut *mut c_void) -> Status;

                fmi2GetDirectionalDerivative = get_directional_derivative(component: *mut c_void, unknowns: *const u32, unknown_count: usize, knowns: *const u32, known_count: usize, known_seed: *const f64, unknown_sensitivity: *mut f64) -> Status;
                fmi2SetRealInputDerivatives = set_real_input_derivatives(component: *mut c_void, references: *const u32, count: usize, orders: *const c_int, values: *const f64) -> Status;
                fmi2GetRealOutputDerivatives = get_real_output_derivatives(component: *mut c_void, references: *const u32, count: usize, orders: *const c_int, values: *mut f64) -> Status;

                fmi2DoStep = do_step(component: *mut c_void, current_communication_point: f64, communication_step_size: f64, no_set_fmu_state_prior_to_current_point: c_int) -> Status;
                fmi2CancelStep = cancel_step(component: *mut c_void) -> Status;
                fmi2GetStatus = get_status(component: *mut c_void, kind: c_int, value: *mut c_int) -> Status;
                fmi2GetRealStatus = get_real_status(component: *mut c_void, kind: c_int, value: *mut f64) -> Status;
                fmi2GetIntegerStatus = get_integer_status(component: *mut c_void, kind: c_int, value: *mut c_int) -> Status;
                fmi2GetBooleanStatus = get_boolean_status(component: *mut c_void, kind: c_int, value: *mut c_int) -> Status;
                fmi2GetStringStatus = get_string_status(component: *mut c_void, kind: c_int, value: *mut *const c_char) -> Status;

                hotfoot_model_description = describe(resources: *const c_char, text: *mut *mut c_char) -> c_int;
                hotfoot_documentation = document(resources: *const c_char, text: *mut *mut c_char) -> c_int;
                hotfoot_terminals = connect(resources: *const c_char, text: *mut *mut c_char) -> c_int;
                hotfoot_free_text = free_text(text: *mut c_char) -> ();
            }
        }
    };
}

/// Writes the exported functions of [`export!`](crate::export).
#[doc(hidden)]
#[macro_export]
macro_rules! export_functions {
    ($model:ty; $($name:ident = $function:ident($($argument:ident: $type:ty),*) -> $result:ty;)*) => {$(
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name($($argument: $type),*) -> $result {
            // SAFETY: the standard binds the caller to what the function asks for.
            unsafe { $crate::abi::$function::<$model>($($argument),*) }
        }
    )*};
}
