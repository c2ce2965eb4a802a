//! An instance of an FMU.

use std::ffi::{CStr, CString};
use std::sync::Arc;

use super::binding::{self, Component, FATAL, FmuState, Functions, OK, Status, WARNING};
use super::callbacks::callbacks;
use super::guard::arrays::Arrays;
use super::guard::guarded;
use super::import::Import;
use super::messages::Messages;
use super::watched::{Label, label};
use crate::interface::VariableType;
use crate::system::unit::UnitError;

/// `fmi2CoSimulation` of `fmi2Type`.
const CO_SIMULATION: i32 = 1;

/// The state of an instance before a step.
#[derive(Default)]
pub(super) struct StateSlot(pub(super) Option<FmuState>);

/// One instance of an FMU.
pub struct FmuInstance {
    pub(super) import: Arc<Import>,
    pub(super) name: String,
    /// Name and file, for the message of a crash or a call without end.
    label: Label,
    component: Component,
    /// Relative tolerance that it is told.
    pub(super) tolerance: Option<f64>,
    /// The time at which it wants the run to end, once it does.
    pub(super) wish_to_end: Option<f64>,
    /// Whether a discarded step is tried again in parts.
    pub(super) retries: bool,
    /// The state before the last step, if discarded steps are tried again.
    pub(super) slot: StateSlot,
    pub(super) messages: &'static Messages,
    /// Arrays for Reals.
    pub(super) reals: Arrays<f64>,
    /// Arrays for Integers and Booleans.
    pub(super) integers: Arrays<i32>,
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
        let c_name = CString::new(name).unwrap_or_default();
        let guid = CString::new(import.interface().guid.as_str()).unwrap_or_default();
        let resources = CString::new(import.resource_uri()).unwrap_or_default();
        let subject = format!("{name} ({})", import.file());
        let messages = Messages::of(&subject, import.binary());
        import.tell_loading(messages);
        let callbacks = callbacks(messages);
        let label = label(&subject);
        let component = guarded(messages, label, c"fmi2Instantiate", || {
            // SAFETY: the strings live during the call, the callbacks as long as the process.
            unsafe {
                (import.functions.instantiate)(
                    c_name.as_ptr(),
                    CO_SIMULATION,
                    guid.as_ptr(),
                    resources.as_ptr(),
                    callbacks,
                    0,
                    0,
                )
            }
        });
        let instance = Self {
            import: Arc::clone(import),
            name: name.to_owned(),
            label,
            component,
            tolerance: import.interface().experiment.tolerance,
            wish_to_end: None,
            retries: false,
            slot: StateSlot::default(),
            messages,
            reals: Arrays::default(),
            integers: Arrays::default(),
        };
        if component.is_null() {
            return Err(instance.error("fmi2Instantiate".to_owned(), None));
        }
        Ok(instance)
    }

    /// The instance with another relative tolerance than its FMU proposes; none: that.
    #[must_use]
    pub fn with_tolerance(mut self, tolerance: Option<f64>) -> Self {
        self.tolerance = tolerance.or(self.tolerance);
        self
    }

    /// Lets a step that the FMU discards be tried again in parts, from the state before it. An FMU
    /// that cannot save its state, or steps with one length only, cannot do that.
    #[must_use]
    pub fn retrying(mut self) -> Self {
        let interface = self.import.interface();
        self.retries = interface.can_get_and_set_state && interface.variable_step;
        self
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

    /// Calls a function of the FMU and gives its status; an FMU that has failed for good is not
    /// called again.
    pub(super) fn status_of(
        &mut self,
        name: &CStr,
        function: impl FnOnce(&Functions, Component) -> Status,
        detail: impl FnOnce(&Self) -> String,
    ) -> Result<Status, UnitError> {
        if self.component_is_fatal() {
            let action = format!("{}{} after fmi2Fatal", name.to_string_lossy(), detail(self));
            return Err(self.error(action, None));
        }
        let (functions, component) = (&self.import.functions, self.component);
        Ok(guarded(self.messages, self.label, name, || function(functions, component)))
    }

    /// Calls a function of the FMU and turns a bad status into an error; `detail` follows the name
    /// of the function in its text.
    pub(super) fn call(
        &mut self,
        name: &CStr,
        function: impl FnOnce(&Functions, Component) -> Status,
        detail: impl Fn(&Self) -> String,
    ) -> Result<(), UnitError> {
        match self.status_of(name, function, &detail)? {
            OK => Ok(()),
            WARNING => {
                let action = format!("{}{}", name.to_string_lossy(), detail(self));
                self.note_warning(&action);
                Ok(())
            }
            status => Err(self.failed(name, detail, status)),
        }
    }

    /// The error of a call that returned a bad status.
    pub(super) fn failed(
        &mut self,
        name: &CStr,
        detail: impl FnOnce(&Self) -> String,
        status: Status,
    ) -> UnitError {
        let action = format!("{}{}", name.to_string_lossy(), detail(self));
        let error = self.error(action, Some(status));
        if status == FATAL {
            // No function of any instance of the FMU may be called any more (§2.1.3).
            self.import.mark_fatal();
        }
        error
    }

    /// The error of a call in which the FMU has done what it must not.
    pub(super) fn damaged(
        &self,
        name: &CStr,
        detail: impl FnOnce(&Self) -> String,
        damage: String,
    ) -> UnitError {
        let action = format!("{}{}", name.to_string_lossy(), detail(self));
        UnitError { last_message: Some(damage.into()), ..self.error(action, None) }
    }

    /// Whether the FMU has failed for good.
    pub(super) fn component_is_fatal(&self) -> bool {
        self.component.is_null() || self.import.is_fatal()
    }

    /// Keeps a warning that the FMU returned without a message.
    pub(super) fn note_warning(&mut self, action: &str) {
        self.messages.note_warning(action);
    }

    /// Names variables for messages.
    pub(super) fn names(&self, kind: VariableType, references: &[u32]) -> String {
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
}

impl Drop for FmuInstance {
    fn drop(&mut self) {
        self.free_state();
        if !self.component_is_fatal() {
            let (functions, component) = (&self.import.functions, self.component);
            self.messages.free();
            guarded(self.messages, self.label, c"fmi2FreeInstance", || {
                // SAFETY: the instance is alive and never used again.
                unsafe { (functions.free_instance)(component) };
            });
        }
    }
}
