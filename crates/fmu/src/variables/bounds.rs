//! The values that a number may have.

use std::fmt::{self, Display};
use std::ops::{RangeFrom, RangeInclusive, RangeToInclusive};

use serde::Serialize;

/// Smallest and largest value of a number, both allowed themselves unless `above` is set.
///
/// A range is one: `0.0..`, `..=0.0`, `0.0..=1.0`; [`above`] makes one without its smallest value.
///
/// ```
/// use fmu::{Bounds, above};
/// assert_eq!(Bounds::from(0.0..=1.0).to_string(), "from 0 to 1");
/// assert_eq!(above(0.0).at_most(2.5).to_string(), "greater than 0, at most 2.5");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Bounds<T> {
    /// Smallest value.
    pub min: Option<T>,
    /// Largest value.
    pub max: Option<T>,
    /// Whether `min` itself is not allowed.
    ///
    /// FMI 2.0 knows only bounds that are allowed themselves (§2.2.3). The model description
    /// keeps `min`, which every tool reads as the number the author meant, and the description
    /// says "greater than"; the next greater number, 4.9e-324, would be exact but no help in a
    /// dialogue, and not every tool reads a subnormal number. The FMU itself refuses `min`.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub above: bool,
}

/// All numbers greater than `min`.
pub fn above<T>(min: T) -> Bounds<T> {
    Bounds { min: Some(min), max: None, above: true }
}

impl<T> Bounds<T> {
    /// Every finite number.
    pub const NONE: Self = Self { min: None, max: None, above: false };

    /// The bounds with this largest value.
    #[must_use]
    pub fn at_most(self, max: T) -> Self {
        Self { max: Some(max), ..self }
    }
}

impl<T> From<RangeFrom<T>> for Bounds<T> {
    fn from(range: RangeFrom<T>) -> Self {
        Self { min: Some(range.start), ..Self::NONE }
    }
}

impl<T> From<RangeToInclusive<T>> for Bounds<T> {
    fn from(range: RangeToInclusive<T>) -> Self {
        Self { max: Some(range.end), ..Self::NONE }
    }
}

impl<T> From<RangeInclusive<T>> for Bounds<T> {
    fn from(range: RangeInclusive<T>) -> Self {
        let (min, max) = range.into_inner();
        Self { min: Some(min), max: Some(max), above: false }
    }
}

impl Bounds<f64> {
    /// Smallest and largest finite value that is allowed.
    pub(crate) fn limits(&self) -> (f64, f64) {
        let min = match self.min {
            Some(min) if self.above => min.next_up(),
            Some(min) => min,
            None => f64::MIN,
        };
        (min, self.max.unwrap_or(f64::MAX))
    }
}

impl Bounds<i32> {
    /// Smallest and largest value that is allowed.
    pub(crate) fn limits(&self) -> (i32, i32) {
        let min = self.min.map_or(i32::MIN, |min| min.saturating_add(i32::from(self.above)));
        (min, self.max.unwrap_or(i32::MAX))
    }
}

impl<T: Display> Display for Bounds<T> {
    /// The bounds in words; nothing without bounds.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.min, &self.max) {
            (None, None) => Ok(()),
            (Some(min), None) if self.above => write!(formatter, "greater than {min}"),
            (Some(min), Some(max)) if self.above => {
                write!(formatter, "greater than {min}, at most {max}")
            }
            (Some(min), None) => write!(formatter, "at least {min}"),
            (None, Some(max)) => write!(formatter, "at most {max}"),
            (Some(min), Some(max)) => write!(formatter, "from {min} to {max}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_excluded_smallest_value_is_outside_and_the_next_number_is_inside() {
        assert_eq!(above(0.0).limits(), (5e-324, f64::MAX));
        assert_eq!(above(1.0).at_most(2.0).limits(), (1.0 + f64::EPSILON, 2.0));
        assert_eq!(above(0).limits(), (1, i32::MAX));
    }

    #[test]
    fn bounds_speak() {
        let words = |bounds: Bounds<f64>| bounds.to_string();
        assert_eq!(words(Bounds::NONE), "");
        assert_eq!(words((0.5..).into()), "at least 0.5");
        assert_eq!(words((..=1e9).into()), "at most 1000000000");
        assert_eq!(words(above(0.0)), "greater than 0");
    }
}
