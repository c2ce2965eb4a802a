//! An instance of an FMU as a unit: the calls of its life, and getting and setting of variables.

use std::ffi::{CStr, CString};

use numerics::seconds;

use super::binding::Functions;
use super::instance::FmuInstance;
use crate::interface::{Interface, VariableType};
use crate::system::unit::{Unit, UnitError};

/// Setting and getting of variables of a type, by arrays that the FMU cannot damage unseen.
macro_rules! exchange {
    ($($set:ident, $get:ident: $type:ty, $arrays:ident, $kind:ident, $c_set:ident $set_name:literal, $c_get:ident $get_name:literal;)*) => {$(
        fn $set(&mut self, references: &[u32], values: &[$type]) -> Result<(), UnitError> {
            assert_eq!(references.len(), values.len(), "one value for each reference");
            let (r, v) = self.$arrays.lend(references, values);
            let detail = |this: &Self| format!(" of {}", this.names(VariableType::$kind, references));
            // SAFETY: both arrays have the stated length.
            let set = |f: &Functions, c| unsafe { (f.$c_set)(c, r, references.len(), v) };
            let called = self.call($set_name, set, detail);
            match self.$arrays.damage_in_setting(references, values) {
                Some(damage) => Err(self.damaged($set_name, detail, damage)),
                None => called,
            }
        }

        fn $get(&mut self, references: &[u32], values: &mut [$type]) -> Result<(), UnitError> {
            assert_eq!(references.len(), values.len(), "one element for each reference");
            let (r, v) = self.$arrays.lend(references, values);
            let detail = |this: &Self| format!(" of {}", this.names(VariableType::$kind, references));
            // SAFETY: both arrays have the stated length.
            let get = |f: &Functions, c| unsafe { (f.$c_get)(c, r, references.len(), v) };
            let called = self.call($get_name, get, detail);
            match self.$arrays.damage_in_getting(references, values) {
                Some(damage) => Err(self.damaged($get_name, detail, damage)),
                None => called,
            }
        }
    )*};
}

impl Unit for FmuInstance {
    fn name(&self) -> &str {
        &self.name
    }

    fn source_file(&self) -> &str {
        self.import.file()
    }

    fn interface(&self) -> &Interface {
        self.import.interface()
    }

    fn set_text(&mut self, reference: u32, value: &str) -> Result<(), UnitError> {
        let c_value = CString::new(value).unwrap_or_default();
        let pointer = c_value.as_ptr();
        self.call(
            c"fmi2SetString",
            // SAFETY: one reference and one string, both alive during the call.
            |f, c| unsafe { (f.set_string)(c, &raw const reference, 1, &raw const pointer) },
            |this| format!(" of {} = '{value}'", this.names(VariableType::Text, &[reference])),
        )
    }

    fn get_text(&mut self, reference: u32) -> Result<String, UnitError> {
        let mut text = std::ptr::null();
        self.call(
            c"fmi2GetString",
            // SAFETY: one reference, and room for one pointer.
            |f, c| unsafe { (f.get_string)(c, &raw const reference, 1, &raw mut text) },
            |this| format!(" of {}", this.names(VariableType::Text, &[reference])),
        )?;
        if text.is_null() {
            return Ok(String::new());
        }
        // SAFETY: the FMU's string stays valid until the next call of the instance (§2.1.7),
        // and is copied before.
        Ok(unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned())
    }

    exchange! {
        set_reals, get_reals: f64, reals, Real, set_real c"fmi2SetReal", get_real c"fmi2GetReal";
        set_integers, get_integers: i32, integers, Integer, set_integer c"fmi2SetInteger", get_integer c"fmi2GetInteger";
        set_booleans, get_booleans: i32, integers, Boolean, set_boolean c"fmi2SetBoolean", get_boolean c"fmi2GetBoolean";
    }

    fn enter_initialization(&mut self, start: f64, stop: f64) -> Result<(), UnitError> {
        let (stated, tolerance) =
            (i32::from(self.tolerance.is_some()), self.tolerance.unwrap_or(0.0));
        self.messages.reached(start);
        self.call(
            c"fmi2SetupExperiment",
            // SAFETY: the instance is alive.
            |f, c| unsafe { (f.setup_experiment)(c, stated, tolerance, start, 1, stop) },
            |_| format!(" from {} s to {} s", seconds(start), seconds(stop)),
        )?;
        self.call(
            c"fmi2EnterInitializationMode",
            // SAFETY: the instance is alive.
            |f, c| unsafe { (f.enter_initialization)(c) },
            |_| String::new(),
        )
    }

    fn exit_initialization(&mut self) -> Result<(), UnitError> {
        self.call(
            c"fmi2ExitInitializationMode",
            // SAFETY: the instance is alive.
            |f, c| unsafe { (f.exit_initialization)(c) },
            |_| String::new(),
        )
    }

    fn step(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        self.step_or_retry(time, length)
    }

    fn wish_to_end(&self) -> Option<f64> {
        self.wish_to_end
    }

    fn keeps_states(&self) -> bool {
        let interface = self.interface();
        interface.can_get_and_set_state && interface.can_serialize_state
    }

    fn save(&mut self) -> Result<Vec<u8>, UnitError> {
        self.save_bytes()
    }

    fn restore(&mut self, saved: &[u8]) -> Result<(), UnitError> {
        self.restore_bytes(saved)
    }

    fn terminate(&mut self) -> Result<(), UnitError> {
        self.call(
            c"fmi2Terminate",
            // SAFETY: the instance is alive.
            |f, c| unsafe { (f.terminate)(c) },
            |_| String::new(),
        )
    }

    fn take_warnings(&mut self) -> Vec<String> {
        self.messages.take_warnings()
    }
}
