//! What a profile belongs to.

use std::fmt;
use std::ops::RangeInclusive;

/// Whether a profile is that of a wheel or of a rail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProfileKind {
    /// Tread and flange of a wheel.
    Wheel,
    /// Head of a rail.
    Rail,
}

impl ProfileKind {
    /// Widths that there are, in m: flange back to field side of a wheel, or the head of a rail.
    pub(super) fn widths(self) -> RangeInclusive<f64> {
        match self {
            Self::Wheel => 0.100..=0.160,
            Self::Rail => 0.050..=0.090,
        }
    }

    /// Name of the width in messages.
    pub(super) fn width(self) -> &'static str {
        match self {
            Self::Wheel => "width of the wheel",
            Self::Rail => "width of the rail's head",
        }
    }
}

impl fmt::Display for ProfileKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Wheel => "wheel",
            Self::Rail => "rail",
        })
    }
}
