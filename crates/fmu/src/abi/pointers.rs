//! From C pointers to Rust values and back.

use std::ffi::{CStr, CString, c_char};
use std::slice;

use crate::error::Error;

/// The elements an array argument points to; null is as good as any pointer if there are none.
pub(super) unsafe fn array<'a, T>(
    argument: &'static str,
    pointer: *const T,
    count: usize,
) -> Result<&'a [T], Error> {
    match (count, pointer.is_null()) {
        (0, _) => Ok(&[]),
        (_, true) => Err(Error::NullArgument(argument)),
        // SAFETY: the caller's pointer has `count` elements.
        (_, false) => Ok(unsafe { slice::from_raw_parts(pointer, count) }),
    }
}

/// The text an argument points to.
pub(super) unsafe fn text<'a>(
    argument: &'static str,
    pointer: *const c_char,
) -> Result<&'a str, Error> {
    if pointer.is_null() {
        return Err(Error::NullArgument(argument));
    }
    // SAFETY: the caller's pointer is one to a text that ends with a NUL.
    let text = unsafe { CStr::from_ptr(pointer) };
    text.to_str().map_err(|_| Error::NotUtf8(argument))
}

/// The texts an array argument points to.
pub(super) unsafe fn texts<'a>(
    argument: &'static str,
    pointer: *const *const c_char,
    count: usize,
) -> Result<Vec<&'a str>, Error> {
    // SAFETY: the caller's pointer has `count` elements.
    let pointers = unsafe { array(argument, pointer, count) }?;
    let texts = pointers.iter();
    // SAFETY: each of them points to a text.
    texts.map(|&pointer| unsafe { text(argument, pointer) }).collect()
}

/// Writes the values to where an array argument points.
pub(super) unsafe fn fill<T>(
    argument: &'static str,
    pointer: *mut T,
    values: impl ExactSizeIterator<Item = T>,
) -> Result<(), Error> {
    if values.len() == 0 {
        return Ok(());
    }
    if pointer.is_null() {
        return Err(Error::NullArgument(argument));
    }
    for (index, value) in values.enumerate() {
        // SAFETY: the caller's pointer has room for as many elements as there are values. The
        // memory need not be initialised, so it is written to without a reference to it.
        unsafe { pointer.add(index).write(value) };
    }
    Ok(())
}

/// A text for C, which cannot hold the character NUL.
pub(super) fn c_text(text: &str) -> CString {
    CString::new(text.replace('\0', "")).unwrap_or_default()
}
