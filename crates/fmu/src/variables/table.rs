//! Values in Rust that an FMU shows as one or several variables.

use std::array;
use std::fmt::Debug;

use super::values::{Boolean, Integer, Real, Text, Values};

/// Values that an FMU shows as variables.
///
/// They are a number, a text, a choice, or a table of [`variables!`](crate::variables!) with all
/// that stands in it.
pub trait Variables: Sized {
    /// Handles of the variables.
    type Handles: Copy + Debug + Send + Sync + 'static;

    /// The values as they are now.
    fn read(handles: &Self::Handles, values: &Values) -> Self;

    /// Shows these values.
    fn write(&self, handles: &Self::Handles, values: &mut Values);
}

/// Handles of the variables that show a `T`.
pub type Handles<T> = <T as Variables>::Handles;

macro_rules! one_variable {
    ($($type:ty: $handle:ty;)*) => {$(
        impl Variables for $type {
            type Handles = $handle;

            #[inline]
            fn read(handle: &$handle, values: &Values) -> Self {
                values[*handle].clone()
            }

            #[inline]
            fn write(&self, handle: &$handle, values: &mut Values) {
                values[*handle].clone_from(self);
            }
        }
    )*};
}

one_variable! {
    f64: Real;
    i32: Integer;
    bool: Boolean;
    String: Text;
}

impl<T: Variables, const N: usize> Variables for [T; N] {
    type Handles = [T::Handles; N];

    fn read(handles: &Self::Handles, values: &Values) -> Self {
        array::from_fn(|index| T::read(&handles[index], values))
    }

    fn write(&self, handles: &Self::Handles, values: &mut Values) {
        for (value, handles) in self.iter().zip(handles) {
            value.write(handles, values);
        }
    }
}
