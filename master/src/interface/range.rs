//! What a variable may be.

/// From the least to the greatest value that a variable may have, in its own unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Least value.
    pub min: f64,
    /// Greatest value.
    pub max: f64,
}

impl Range {
    /// All finite numbers.
    pub const FINITE: Self = Self { min: f64::MIN, max: f64::MAX };

    /// What a model description states, of which a bound may be missing or no finite number.
    pub fn stated(min: Option<f64>, max: Option<f64>) -> Self {
        let bound = |stated: Option<f64>, otherwise: f64| match stated {
            Some(stated) if stated.is_finite() => stated,
            _ => otherwise,
        };
        Self { min: bound(min, f64::MIN), max: bound(max, f64::MAX) }
    }

    /// Whether a number lies in it.
    pub fn contains(&self, number: f64) -> bool {
        (self.min..=self.max).contains(&number)
    }

    /// What lies in both.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self { min: self.min.max(other.min), max: self.max.min(other.max) }
    }
}
