//! Piecewise linear tables.

/// Why a table cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TableError {
    /// The two columns differ in length, or there are no rows.
    #[error(
        "a table needs two columns of the same length with at least one row, but has {x} and {y} values"
    )]
    Shape {
        /// Number of abscissae.
        x: usize,
        /// Number of ordinates.
        y: usize,
    },
    /// The abscissae do not rise.
    #[error("row {row}: the first column must rise from row to row, but {value} follows {before}")]
    NotRising {
        /// Row counted from one.
        row: usize,
        /// Value before it.
        before: f64,
        /// Value that is not greater.
        value: f64,
    },
    /// A value is not a finite number.
    #[error("row {row}: every value must be a finite number")]
    NotFinite {
        /// Row counted from one.
        row: usize,
    },
}

/// A function given by points, linear between them and constant outside.
///
/// A lookup remembers its interval in an index that the caller keeps, so that a slowly moving
/// argument costs one comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearTable {
    x: Vec<f64>,
    y: Vec<f64>,
}

impl LinearTable {
    /// A table through the points `(x[i], y[i])`.
    ///
    /// # Errors
    /// When the columns differ in length, are empty, not finite, or `x` does not rise.
    pub fn new(x: Vec<f64>, y: Vec<f64>) -> Result<Self, TableError> {
        if x.len() != y.len() || x.is_empty() {
            return Err(TableError::Shape { x: x.len(), y: y.len() });
        }
        if let Some(row) = (0..x.len()).find(|&i| !(x[i].is_finite() && y[i].is_finite())) {
            return Err(TableError::NotFinite { row: row + 1 });
        }
        if let Some(i) = (1..x.len()).find(|&i| x[i] <= x[i - 1]) {
            return Err(TableError::NotRising { row: i + 1, before: x[i - 1], value: x[i] });
        }
        Ok(Self { x, y })
    }

    /// The value at `x`; `index` is any number at first and that of the last lookup later.
    #[inline]
    pub fn value(&self, x: f64, index: &mut usize) -> f64 {
        let last = self.x.len() - 1;
        if x <= self.x[0] {
            return self.y[0];
        }
        if x >= self.x[last] {
            return self.y[last];
        }
        *index = interval(&self.x, x, *index);
        let i = *index;
        let share = (x - self.x[i]) / (self.x[i + 1] - self.x[i]);
        self.y[i] + share * (self.y[i + 1] - self.y[i])
    }

    /// The abscissae.
    pub fn x(&self) -> &[f64] {
        &self.x
    }

    /// The ordinates.
    pub fn y(&self) -> &[f64] {
        &self.y
    }
}

/// The interval of the rising values `x` that holds `value`, searched from the interval `guess`:
/// `x[i] <= value < x[i + 1]`. Outside it is the first or the last interval.
#[inline]
pub fn interval(x: &[f64], value: f64, guess: usize) -> usize {
    let last = x.len().saturating_sub(2);
    let mut i = guess.min(last);
    while i > 0 && value < x[i] {
        i -= 1;
    }
    while i < last && value >= x[i + 1] {
        i += 1;
    }
    i
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_linear_between_and_constant_outside() {
        let table = LinearTable::new(vec![0.0, 1.0, 3.0], vec![0.0, 2.0, 0.0]).unwrap();
        let mut index = 0;
        let at = |x: f64, index: &mut usize| table.value(x, index);
        assert_eq!(at(-1.0, &mut index), 0.0);
        assert_eq!(at(0.25, &mut index), 0.5);
        assert_eq!(at(2.0, &mut index), 1.0);
        assert_eq!(at(0.5, &mut index), 1.0);
        assert_eq!(at(9.0, &mut index), 0.0);
    }

    /// The guess decides how long the search takes, not what it finds.
    #[test]
    fn property_the_interval_does_not_depend_on_the_guess() {
        let x = [0.0, 1.0, 4.0, 9.0];
        for (value, expected) in [(-1.0, 0), (0.0, 0), (1.0, 1), (3.9, 1), (4.0, 2), (99.0, 2)] {
            for guess in [0, 1, 2, 3, 1000] {
                assert_eq!(interval(&x, value, guess), expected, "{value} from {guess}");
            }
        }
        assert_eq!(interval(&[5.0], 7.0, 3), 0);
    }

    #[test]
    fn columns_of_different_length_and_infinite_values_are_refused() {
        let table = |x: &[f64], y: &[f64]| LinearTable::new(x.to_vec(), y.to_vec()).unwrap_err();
        assert_eq!(table(&[0.0, 1.0], &[0.0]), TableError::Shape { x: 2, y: 1 });
        assert_eq!(table(&[], &[]), TableError::Shape { x: 0, y: 0 });
        assert_eq!(table(&[0.0, 1.0], &[0.0, f64::NAN]), TableError::NotFinite { row: 2 });
    }

    #[test]
    fn rows_that_do_not_rise_are_named() {
        let error = LinearTable::new(vec![0.0, 1.0, 1.0], vec![0.0; 3]).unwrap_err();
        assert_eq!(error, TableError::NotRising { row: 3, before: 1.0, value: 1.0 });
    }
}
