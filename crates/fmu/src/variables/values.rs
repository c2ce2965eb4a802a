//! The values of an instance's variables.

use std::ops::{Index, IndexMut};

use serde::{Deserialize, Serialize};

use super::bounds::Bounds;
use super::unit::Unit;
use super::variable::{Kind, Variability};

/// A type of variables in FMI 2.0, by its type in Rust.
pub trait Type: Clone + Default + Sized {
    /// Handle of a variable of the type.
    type Handle: Copy;
    /// What belongs to a variable of the type besides its start value.
    type Domain;
    /// When an input or output of the type may change.
    const VARIABILITY: Variability;

    /// Type, start value and what else belongs to the type.
    fn kind(start: Self, domain: Self::Domain) -> Kind;
    /// The values of the variables of this type.
    #[doc(hidden)]
    fn store(values: &mut Values) -> &mut Vec<Self>;
    #[doc(hidden)]
    fn handle(reference: u32) -> Self::Handle;
}

macro_rules! types {
    ($(
        $(#[$doc:meta])*
        $handle:ident => $store:ident: $type:ty, $variability:ident, $domain_type:ty,
        |$start:ident, $domain:pat_param| $kind:expr;
    )*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub struct $handle(u32);

        impl $handle {
            /// The variable's value reference.
            pub fn reference(self) -> u32 {
                self.0
            }
        }

        impl Type for $type {
            type Handle = $handle;
            type Domain = $domain_type;
            const VARIABILITY: Variability = Variability::$variability;

            fn kind($start: Self, $domain: $domain_type) -> Kind {
                $kind
            }

            fn store(values: &mut Values) -> &mut Vec<Self> {
                &mut values.$store
            }

            fn handle(reference: u32) -> $handle {
                $handle(reference)
            }
        }

        impl Index<$handle> for Values {
            type Output = $type;
            fn index(&self, handle: $handle) -> &$type {
                &self.$store[handle.0 as usize]
            }
        }

        impl IndexMut<$handle> for Values {
            fn index_mut(&mut self, handle: $handle) -> &mut $type {
                &mut self.$store[handle.0 as usize]
            }
        }
    )*};
}

types! {
    /// Handle of a Real variable.
    Real => reals: f64, Continuous, (Unit, Bounds<f64>),
    |start, (unit, bounds)| Kind::Real { unit, start, bounds };
    /// Handle of an Integer variable.
    Integer => integers: i32, Discrete, Bounds<i32>,
    |start, bounds| Kind::Integer { start, bounds };
    /// Handle of a Boolean variable.
    Boolean => booleans: bool, Discrete, (),
    |start, ()| Kind::Boolean { start };
    /// Handle of a String variable.
    Text => texts: String, Discrete, &'static [&'static str],
    |start, choices| Kind::Text { start, choices };
}

/// Every variable's value; a value reference is the index in the array of its type.
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

/// Handle of Real variables that were declared one after the other, to read or write all at once.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reals<const N: usize> {
    first: u32,
}

impl<const N: usize> Reals<N> {
    /// The variable with this handle and those declared after it.
    pub fn from_first(Real(first): Real) -> Self {
        Self { first }
    }
}

impl<const N: usize> Index<Reals<N>> for Values {
    type Output = [f64; N];
    fn index(&self, handle: Reals<N>) -> &[f64; N] {
        let reals = self.reals[handle.first as usize..].first_chunk();
        reals.expect("all of them have a value")
    }
}

impl<const N: usize> IndexMut<Reals<N>> for Values {
    fn index_mut(&mut self, handle: Reals<N>) -> &mut [f64; N] {
        let reals = self.reals[handle.first as usize..].first_chunk_mut();
        reals.expect("all of them have a value")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn property_several_reals_are_those_of_their_handles() {
        let mut values = Values { reals: vec![0.0; 5], ..Values::default() };
        let handles = [Real(2), Real(3)];
        let both = Reals::from_first(handles[0]);
        values[both] = [1.0, 2.0];
        assert_eq!(handles.map(|handle| values[handle]), values[both]);
        assert_eq!(values.reals, [0.0, 0.0, 1.0, 2.0, 0.0]);
    }
}
