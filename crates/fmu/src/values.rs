//! The values of an instance's variables.

use std::ops::{Index, IndexMut};

use serde::{Deserialize, Serialize};

macro_rules! handles {
    ($($(#[$doc:meta])* $handle:ident => $store:ident : $value:ty),* $(,)?) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub struct $handle(pub(crate) u32);

        impl $handle {
            /// The variable's value reference.
            pub fn reference(self) -> u32 {
                self.0
            }
        }

        impl Index<$handle> for Values {
            type Output = $value;
            fn index(&self, handle: $handle) -> &$value {
                &self.$store[handle.0 as usize]
            }
        }

        impl IndexMut<$handle> for Values {
            fn index_mut(&mut self, handle: $handle) -> &mut $value {
                &mut self.$store[handle.0 as usize]
            }
        }
    )*};
}

/// Every variable's value; a value reference is the place in the array of its type.
///
/// Getters and setters of the C interface copy from and to these arrays; a model reads and
/// writes them by the handles its declaration gave: `values[signals.position] = x`.
#[derive(Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Values {
    pub(crate) reals: Vec<f64>,
    pub(crate) integers: Vec<i32>,
    pub(crate) booleans: Vec<bool>,
    pub(crate) texts: Vec<String>,
}

impl Values {
    /// Whether there are as many values of each type.
    pub(crate) fn has_shape_of(&self, other: &Self) -> bool {
        self.reals.len() == other.reals.len()
            && self.integers.len() == other.integers.len()
            && self.booleans.len() == other.booleans.len()
            && self.texts.len() == other.texts.len()
    }
}

impl Clone for Values {
    fn clone(&self) -> Self {
        Self {
            reals: self.reals.clone(),
            integers: self.integers.clone(),
            booleans: self.booleans.clone(),
            texts: self.texts.clone(),
        }
    }

    /// Keeps the memory of the arrays, so that saving a state again and again allocates nothing.
    fn clone_from(&mut self, source: &Self) {
        self.reals.clone_from(&source.reals);
        self.integers.clone_from(&source.integers);
        self.booleans.clone_from(&source.booleans);
        self.texts.clone_from(&source.texts);
    }
}

handles! {
    /// Handle of a Real variable.
    Real => reals: f64,
    /// Handle of an Integer variable.
    Integer => integers: i32,
    /// Handle of a Boolean variable.
    Boolean => booleans: bool,
    /// Handle of a String variable.
    Text => texts: String,
}
