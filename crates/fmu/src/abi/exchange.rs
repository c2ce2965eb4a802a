//! Getting and setting values (§2.1.7), and the derivatives that are not offered.

use std::ffi::{c_char, c_int, c_void};

use super::component::call;
use super::pointers::{array, c_text, fill, texts};
use crate::calls::Call;
use crate::model::Model;
use crate::status::Status;

/// Name of the argument with the value references in the standard.
const REFERENCES: &str = "vr";
/// Name of the argument with the values in the standard.
const VALUES: &str = "value";

/// `fmi2GetReal`.
pub unsafe fn get_real<M: Model>(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *mut f64,
) -> Status {
    // SAFETY: the pointers are those of the caller, each to `count` elements.
    unsafe {
        call::<M>(component, Call::GetReal, |component| {
            let references = array(REFERENCES, references, count)?;
            fill(VALUES, values, component.instance.get_real(references)?)
        })
    }
}

/// `fmi2GetInteger`.
pub unsafe fn get_integer<M: Model>(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *mut i32,
) -> Status {
    // SAFETY: the pointers are those of the caller, each to `count` elements.
    unsafe {
        call::<M>(component, Call::GetInteger, |component| {
            let references = array(REFERENCES, references, count)?;
            fill(VALUES, values, component.instance.get_integer(references)?)
        })
    }
}

/// `fmi2GetBoolean`.
pub unsafe fn get_boolean<M: Model>(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *mut c_int,
) -> Status {
    // SAFETY: the pointers are those of the caller, each to `count` elements.
    unsafe {
        call::<M>(component, Call::GetBoolean, |component| {
            let references = array(REFERENCES, references, count)?;
            let booleans = component.instance.get_boolean(references)?;
            fill(VALUES, values, booleans.map(c_int::from))
        })
    }
}

/// `fmi2GetString`; the texts live until the next call of this function.
pub unsafe fn get_string<M: Model>(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *mut *const c_char,
) -> Status {
    // SAFETY: the pointers are those of the caller, each to `count` elements.
    unsafe {
        call::<M>(component, Call::GetString, |component| {
            let references = array(REFERENCES, references, count)?;
            let texts = component.instance.get_string(references)?;
            component.texts = texts.map(|text| c_text(&text)).collect();
            fill(VALUES, values, component.texts.iter().map(|text| text.as_ptr()))
        })
    }
}

/// `fmi2SetReal`.
pub unsafe fn set_real<M: Model>(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *const f64,
) -> Status {
    // SAFETY: the pointers are those of the caller, each to `count` elements.
    unsafe {
        call::<M>(component, Call::SetReal, |component| {
            let references = array(REFERENCES, references, count)?;
            let values = array(VALUES, values, count)?;
            component.instance.set_real(references, values.iter().copied())
        })
    }
}

/// `fmi2SetInteger`.
pub unsafe fn set_integer<M: Model>(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *const i32,
) -> Status {
    // SAFETY: the pointers are those of the caller, each to `count` elements.
    unsafe {
        call::<M>(component, Call::SetInteger, |component| {
            let references = array(REFERENCES, references, count)?;
            let values = array(VALUES, values, count)?;
            component.instance.set_integer(references, values.iter().copied())
        })
    }
}

/// `fmi2SetBoolean`; as in C, all that is not zero is true.
pub unsafe fn set_boolean<M: Model>(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *const c_int,
) -> Status {
    // SAFETY: the pointers are those of the caller, each to `count` elements.
    unsafe {
        call::<M>(component, Call::SetBoolean, |component| {
            let references = array(REFERENCES, references, count)?;
            let values = array(VALUES, values, count)?.iter();
            component.instance.set_boolean(references, values.map(|&value| value != 0))
        })
    }
}

/// `fmi2SetString`.
pub unsafe fn set_string<M: Model>(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *const *const c_char,
) -> Status {
    // SAFETY: the pointers are those of the caller, each to `count` elements.
    unsafe {
        call::<M>(component, Call::SetString, |component| {
            let references = array(REFERENCES, references, count)?;
            let values = texts(VALUES, values, count)?;
            component.instance.set_string(references, values)
        })
    }
}

/// `fmi2GetDirectionalDerivative`: not offered.
pub unsafe fn get_directional_derivative<M: Model>(
    component: *mut c_void,
    _unknowns: *const u32,
    _unknown_count: usize,
    _knowns: *const u32,
    _known_count: usize,
    _known_seed: *const f64,
    _unknown_sensitivity: *mut f64,
) -> Status {
    let flag = "providesDirectionalDerivative=\"false\"";
    // SAFETY: the component is the caller's.
    unsafe { refuse::<M>(component, Call::GetDirectionalDerivative, flag) }
}

/// `fmi2SetRealInputDerivatives`: not offered.
pub unsafe fn set_real_input_derivatives<M: Model>(
    component: *mut c_void,
    _references: *const u32,
    _count: usize,
    _orders: *const c_int,
    _values: *const f64,
) -> Status {
    let flag = "canInterpolateInputs=\"false\"";
    // SAFETY: the component is the caller's.
    unsafe { refuse::<M>(component, Call::SetRealInputDerivatives, flag) }
}

/// `fmi2GetRealOutputDerivatives`: not offered.
pub unsafe fn get_real_output_derivatives<M: Model>(
    component: *mut c_void,
    _references: *const u32,
    _count: usize,
    _orders: *const c_int,
    _values: *mut f64,
) -> Status {
    let flag = "maxOutputDerivativeOrder=\"0\"";
    // SAFETY: the component is the caller's.
    unsafe { refuse::<M>(component, Call::GetRealOutputDerivatives, flag) }
}

/// Refuses a call that the FMU does not offer.
unsafe fn refuse<M: Model>(component: *mut c_void, refused: Call, flag: &'static str) -> Status {
    // SAFETY: the component is the caller's.
    unsafe { call::<M>(component, refused, |component| component.instance.refuse(refused, flag)) }
}
