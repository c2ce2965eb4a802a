//! Last value, lowest and highest of every column between two records.

/// Sees every step and remembers what a record needs.
///
/// The interval of the extremes is closed at both ends: the value of the last record counts as
/// the first of the next interval, so that lowest <= last <= highest always holds and curves
/// of the extremes have no gaps. Values lie row by row, as the steps bring them.
#[derive(Debug)]
pub(super) struct Accumulator {
    columns: usize,
    last: Vec<f64>,
    lowest: Vec<f64>,
    highest: Vec<f64>,
}

impl Accumulator {
    /// For `rows` rows of `columns` values; all not-a-number until observed.
    pub fn new(rows: usize, columns: usize) -> Self {
        let empty = vec![f64::NAN; rows * columns];
        Self { columns, last: empty.clone(), lowest: empty.clone(), highest: empty }
    }

    /// Takes the values of a row after a step.
    ///
    /// `f64::min` and `f64::max` pass over not-a-number, so the first value replaces it.
    pub fn observe(&mut self, row: usize, values: &[f64]) {
        let range = row * self.columns..(row + 1) * self.columns;
        self.last[range.clone()].copy_from_slice(values);
        for (lowest, &value) in self.lowest[range.clone()].iter_mut().zip(values) {
            *lowest = lowest.min(value);
        }
        for (highest, &value) in self.highest[range].iter_mut().zip(values) {
            *highest = highest.max(value);
        }
    }

    /// Last value of a column in every row.
    pub fn last(&self, column: usize) -> impl Iterator<Item = f64> {
        self.of(&self.last, column)
    }

    /// Lowest value of a column in every row since the last [`Self::restart`].
    pub fn lowest(&self, column: usize) -> impl Iterator<Item = f64> {
        self.of(&self.lowest, column)
    }

    /// Highest value of a column in every row since the last [`Self::restart`].
    pub fn highest(&self, column: usize) -> impl Iterator<Item = f64> {
        self.of(&self.highest, column)
    }

    /// Begins the next interval at the last values.
    pub fn restart(&mut self) {
        self.lowest.copy_from_slice(&self.last);
        self.highest.copy_from_slice(&self.last);
    }

    fn of<'a>(&self, values: &'a [f64], column: usize) -> impl Iterator<Item = f64> + use<'a> {
        values[column..].iter().step_by(self.columns).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_extremes_between_records_and_across_them() {
        let mut accumulator = Accumulator::new(2, 1);
        for value in [1.0, -3.0, 2.0] {
            accumulator.observe(1, &[value]);
        }
        assert_eq!(accumulator.lowest(0).nth(1), Some(-3.0));
        assert_eq!(accumulator.highest(0).nth(1), Some(2.0));

        accumulator.restart();
        accumulator.observe(1, &[5.0]);
        assert_eq!(accumulator.lowest(0).nth(1), Some(2.0));
        assert_eq!(accumulator.highest(0).nth(1), Some(5.0));
        assert!(accumulator.last(0).next().unwrap().is_nan(), "row 0 was never observed");
    }
}
