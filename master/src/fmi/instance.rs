//! An instance of an FMU.

use std::ffi::CString;
use std::sync::Arc;

use super::binding::{self, Component, DISCARD, FATAL, Functions, OK, Status, WARNING};
use super::callbacks::{Messages, callbacks};
use super::import::Import;
use crate::interface::{Interface, VariableType};
use crate::unit::{Unit, UnitError};

/// `fmi2CoSimulation` of `fmi2Type`.
const CO_SIMULATION: i32 = 1;
/// `fmi2LastSuccessfulTime` of `fmi2StatusKind`.
const LAST_SUCCESSFUL_TIME: i32 = 2;

/// One instance of an FMU.
pub struct FmuInstance {
    import: Arc<Import>,
    name: String,
    component: Component,
    messages: Box<Messages>,
    /// Kept because the FMU may hold on to the pointer.
    _callbacks: Box<binding::Callbacks>,
}

// SAFETY: an FMU instance may be called from any thread as long as the calls do not overlap
// (FMI 2.0 §2.1.1 asks for reentrant functions without shared state); all calls go through
// `&mut self`. The message store is behind a mutex.
unsafe impl Send for FmuInstance {}

impl FmuInstance {
    /// Makes an instance.
    ///
    /// # Errors
    /// When the FMU refuses, with what it logged.
    pub fn new(import: &Arc<Import>, name: &str) -> Result<Self, UnitError> {
        let messages = Box::<Messages>::default();
        let callbacks = Box::new(callbacks(&messages));
        let c_name = CString::new(name).unwrap_or_default();
        let guid = CString::new(import.interface().guid.as_str()).unwrap_or_default();
        let resources = CString::new(import.resource_uri()).unwrap_or_default();
        // SAFETY: the strings and the callbacks live during the call, and the callbacks and
        // messages as long as the instance.
        let component = unsafe {
            (import.functions.instantiate)(
                c_name.as_ptr(),
                CO_SIMULATION,
                guid.as_ptr(),
                resources.as_ptr(),
                &raw const *callbacks,
                0,
                0,
            )
        };
        let instance = Self {
            import: Arc::clone(import),
            name: name.to_owned(),
            component,
            messages,
            _callbacks: callbacks,
        };
        if component.is_null() {
            return Err(instance.error("fmi2Instantiate".to_owned(), None));
        }
        Ok(instance)
    }

    fn error(&self, action: String, status: Option<Status>) -> UnitError {
        let last_message = self.messages.last();
        let last_message = last_message.map(|text| self.import.in_words_of_the_user(&text));
        UnitError {
            instance: self.name.as_str().into(),
            source_file: self.import.file().into(),
            action: action.into(),
            status: status.map(binding::status_name),
            last_message: last_message.map(Into::into),
        }
    }

    /// Calls a function of the FMU and turns a bad status into an error that tells `action`.
    fn call(
        &mut self,
        function: impl FnOnce(&Functions, Component) -> Status,
        action: impl FnOnce(&Self) -> String,
    ) -> Result<(), UnitError> {
        if self.component.is_null() {
            return Err(self.error(format!("{} after a fatal error", action(self)), None));
        }
        let status = function(&self.import.functions, self.component);
        if matches!(status, OK | WARNING) {
            return Ok(());
        }
        let error = self.error(action(self), Some(status));
        if status == FATAL {
            // After fmi2Fatal no function of the instance may be called (§2.1.3).
            self.component = std::ptr::null_mut();
        }
        Err(error)
    }

    /// Names variables for messages.
    fn names(&self, kind: VariableType, references: &[u32]) -> String {
        let name = |&reference: &u32| {
            let name = self.import.interface().name_of(kind, reference);
            name.map_or_else(|| format!("value reference {reference}"), str::to_owned)
        };
        match references {
            [] => "no variable".to_owned(),
            [one] => name(one),
            [first, ..] => format!("{} and {} more", name(first), references.len() - 1),
        }
    }

    /// The time until which a discarded step came.
    fn last_successful_time(&self) -> f64 {
        let mut time = f64::NAN;
        // SAFETY: the instance is alive after fmi2Discard, and the FMU writes one number.
        unsafe {
            (self.import.functions.get_real_status)(
                self.component,
                LAST_SUCCESSFUL_TIME,
                &raw mut time,
            )
        };
        time
    }
}

impl Unit for FmuInstance {
    fn interface(&self) -> &Interface {
        self.import.interface()
    }

    fn set_text(&mut self, reference: u32, value: &str) -> Result<(), UnitError> {
        let c_value = CString::new(value).unwrap_or_default();
        let pointer = c_value.as_ptr();
        self.call(
            // SAFETY: one reference and one string, both alive during the call.
            |f, c| unsafe { (f.set_string)(c, &raw const reference, 1, &raw const pointer) },
            |this| {
                let name = this.names(VariableType::Text, &[reference]);
                format!("fmi2SetString of {name} = '{value}'")
            },
        )
    }

    fn set_integer(&mut self, reference: u32, value: i32) -> Result<(), UnitError> {
        self.call(
            // SAFETY: one reference and one number, both alive during the call.
            |f, c| unsafe { (f.set_integer)(c, &raw const reference, 1, &raw const value) },
            |this| {
                let name = this.names(VariableType::Integer, &[reference]);
                format!("fmi2SetInteger of {name} = {value}")
            },
        )
    }

    fn set_reals(&mut self, references: &[u32], values: &[f64]) -> Result<(), UnitError> {
        assert_eq!(references.len(), values.len(), "one value for each reference");
        self.call(
            // SAFETY: both arrays have the stated length.
            |f, c| unsafe {
                (f.set_real)(c, references.as_ptr(), references.len(), values.as_ptr())
            },
            |this| format!("fmi2SetReal of {}", this.names(VariableType::Real, references)),
        )
    }

    fn get_reals(&mut self, references: &[u32], values: &mut [f64]) -> Result<(), UnitError> {
        assert_eq!(references.len(), values.len(), "one place for each reference");
        self.call(
            // SAFETY: both arrays have the stated length.
            |f, c| unsafe {
                (f.get_real)(c, references.as_ptr(), references.len(), values.as_mut_ptr())
            },
            |this| format!("fmi2GetReal of {}", this.names(VariableType::Real, references)),
        )
    }

    fn enter_initialization(&mut self, start: f64, stop: f64) -> Result<(), UnitError> {
        self.call(
            // SAFETY: the instance is alive.
            |f, c| unsafe { (f.setup_experiment)(c, 0, 0.0, start, 1, stop) },
            |_| format!("fmi2SetupExperiment from {start} s to {stop} s"),
        )?;
        self.call(
            // SAFETY: the instance is alive.
            |f, c| unsafe { (f.enter_initialization)(c) },
            |_| "fmi2EnterInitializationMode".to_owned(),
        )
    }

    fn exit_initialization(&mut self) -> Result<(), UnitError> {
        self.call(
            // SAFETY: the instance is alive.
            |f, c| unsafe { (f.exit_initialization)(c) },
            |_| "fmi2ExitInitializationMode".to_owned(),
        )
    }

    fn step(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        let mut discarded = false;
        self.call(
            |f, c| {
                // SAFETY: the instance is alive.
                let status = unsafe { (f.do_step)(c, time, length, 1) };
                discarded = status == DISCARD;
                status
            },
            |_| format!("fmi2DoStep from {time} s by {length} s"),
        )
        .map_err(|mut error| {
            if discarded {
                let reached = self.last_successful_time();
                error.action = format!("{}, done until {reached} s,", error.action).into();
            }
            error
        })
    }

    fn terminate(&mut self) -> Result<(), UnitError> {
        self.call(
            // SAFETY: the instance is alive.
            |f, c| unsafe { (f.terminate)(c) },
            |_| "fmi2Terminate".to_owned(),
        )
    }

    fn take_warnings(&mut self) -> Vec<String> {
        self.messages.take_warnings()
    }
}

impl Drop for FmuInstance {
    fn drop(&mut self) {
        if !self.component.is_null() {
            // SAFETY: the instance is alive and never used again.
            unsafe { (self.import.functions.free_instance)(self.component) };
        }
    }
}
