//! A text that is one of a few, as an enumeration.

use super::values::{Text, Values};

/// An enumeration whose values a String variable names; [`choices!`](crate::choices!) makes one.
pub trait Choice: Copy + PartialEq + 'static {
    /// The texts, in the order of the values.
    const TEXTS: &'static [&'static str];
    /// The values.
    const VALUES: &'static [Self];

    /// The text that names the value.
    fn text(self) -> &'static str {
        let named = Self::VALUES.iter().zip(Self::TEXTS).find(|(value, _)| **value == self);
        named.expect("every value has a text").1
    }

    /// The value that the variable names.
    ///
    /// # Panics
    /// When the text names none, which the setter refuses.
    fn read(handle: Text, values: &Values) -> Self {
        let text = values[handle].as_str();
        let named = Self::TEXTS.iter().zip(Self::VALUES).find(|(name, _)| **name == text);
        *named.expect("the setter admits no other text").1
    }
}

/// Makes an enumeration of what a String variable may be.
///
/// Such a variable is a row `choice(…)` in a table of [`variables!`](crate::variables!).
///
/// ```
/// use fmu::Choice;
///
/// fmu::choices! {
///     /// Which pneumatic brake the wagons have.
///     pub enum Brake {
///         /// One pipe.
///         Air = "air",
///         /// Electronically controlled.
///         Electronic = "ecp",
///     }
/// }
/// assert_eq!(Brake::TEXTS, ["air", "ecp"]);
/// assert_eq!(Brake::Electronic.text(), "ecp");
/// ```
#[macro_export]
macro_rules! choices {
    ($(
        $(#[$attribute:meta])*
        $visibility:vis enum $choice:ident {
            $($(#[$doc:meta])* $value:ident = $text:literal,)+
        }
    )+) => {$(
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        $visibility enum $choice {
            $($(#[$doc])* $value,)+
        }

        impl $crate::Choice for $choice {
            const TEXTS: &'static [&'static str] = &[$($text),+];
            const VALUES: &'static [Self] = &[$(Self::$value),+];
        }

        impl $crate::Variables for $choice {
            type Handles = $crate::Text;

            fn read(handle: &$crate::Text, values: &$crate::Values) -> Self {
                <Self as $crate::Choice>::read(*handle, values)
            }

            fn write(&self, handle: &$crate::Text, values: &mut $crate::Values) {
                $crate::Choice::text(*self).clone_into(&mut values[*handle]);
            }
        }
    )+};
}
