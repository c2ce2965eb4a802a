//! Last value of every column between two records, and mean, lowest and highest of some.

use serde::{Deserialize, Serialize};

/// Sees every step and remembers what a record needs.
///
/// The interval of the extremes is closed at both ends: the value of the last record counts as
/// the first of the next interval, so that lowest <= last <= highest always holds and curves
/// of the extremes have no gaps. A mean is over the steps since the last record. Values lie row by
/// row, as the steps bring them.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Accumulator {
    columns: usize,
    /// The columns whose extremes are kept.
    extremes: Vec<usize>,
    last: Vec<f64>,
    /// A value for each of `extremes` in every row.
    lowest: Vec<f64>,
    highest: Vec<f64>,
    /// The columns whose means are kept.
    means: Vec<usize>,
    /// A sum for each of `means` in every row.
    sums: Vec<f64>,
    /// Number of values in the sums of each row.
    counts: Vec<f64>,
}

impl Accumulator {
    /// For `rows` rows of `columns` values, with the means and the extremes of some of them.
    pub fn new(rows: usize, columns: usize, means: Vec<usize>, extremes: Vec<usize>) -> Self {
        Self {
            columns,
            last: vec![f64::NAN; rows * columns],
            lowest: vec![f64::INFINITY; rows * extremes.len()],
            highest: vec![f64::NEG_INFINITY; rows * extremes.len()],
            extremes,
            sums: vec![0.0; rows * means.len()],
            counts: vec![0.0; rows],
            means,
        }
    }

    /// Takes the values of a row after a step; the extremes pass over not-a-number.
    pub fn observe(&mut self, row: usize, values: &[f64]) {
        self.last[row * self.columns..][..self.columns].copy_from_slice(values);
        self.counts[row] += 1.0;
        let sums = &mut self.sums[row * self.means.len()..][..self.means.len()];
        for (&column, sum) in self.means.iter().zip(sums) {
            *sum += values[column];
        }
        let begin = row * self.extremes.len();
        let lowest = &mut self.lowest[begin..][..self.extremes.len()];
        let highest = &mut self.highest[begin..][..self.extremes.len()];
        for ((&column, lowest), highest) in self.extremes.iter().zip(lowest).zip(highest) {
            let value = values[column];
            if value < *lowest {
                *lowest = value;
            }
            if value > *highest {
                *highest = value;
            }
        }
    }

    /// Last value of every column in a row; not-a-number until observed.
    pub fn last_of_row(&self, row: usize) -> &[f64] {
        &self.last[row * self.columns..][..self.columns]
    }

    /// Whether another one is of the same rows and columns.
    pub fn is_like(&self, other: &Self) -> bool {
        (self.columns, &self.extremes, &self.means)
            == (other.columns, &other.extremes, &other.means)
            && self.last.len() == other.last.len()
            && self.lowest.len() == other.lowest.len()
            && self.highest.len() == other.highest.len()
            && self.sums.len() == other.sums.len()
            && self.counts.len() == other.counts.len()
    }

    /// Last value of a column in every row; not-a-number until observed.
    pub fn last(&self, column: usize) -> impl Iterator<Item = f64> {
        every(self.columns, &self.last, column)
    }

    /// Mean in every row since the last [`Self::restart`] of a column, by its index among
    /// those whose means are kept; not-a-number until observed.
    pub fn mean(&self, index: usize) -> impl Iterator<Item = f64> {
        every(self.means.len(), &self.sums, index).zip(&self.counts).map(|(sum, count)| sum / count)
    }

    /// Lowest value in every row since the last [`Self::restart`] of a column, by its
    /// index among those whose extremes are kept.
    pub fn lowest(&self, index: usize) -> impl Iterator<Item = f64> {
        every(self.extremes.len(), &self.lowest, index)
    }

    /// Highest value, as [`Self::lowest`].
    pub fn highest(&self, index: usize) -> impl Iterator<Item = f64> {
        every(self.extremes.len(), &self.highest, index)
    }

    /// Begins the next interval at the last values.
    pub fn restart(&mut self) {
        self.sums.fill(0.0);
        self.counts.fill(0.0);
        let rows = self.last.chunks_exact(self.columns.max(1));
        let last = rows.flat_map(|row| self.extremes.iter().map(|&column| row[column]));
        for (value, (lowest, highest)) in last.zip(self.lowest.iter_mut().zip(&mut self.highest)) {
            // Nothing is lower or higher than not-a-number: it must not begin an interval.
            let known = !value.is_nan();
            *lowest = if known { value } else { f64::INFINITY };
            *highest = if known { value } else { f64::NEG_INFINITY };
        }
    }
}

/// The values of a column in rows of `columns`.
fn every(columns: usize, values: &[f64], column: usize) -> impl Iterator<Item = f64> {
    values[column..].iter().step_by(columns).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_means_and_extremes_between_records_and_across_them() {
        let mut accumulator = Accumulator::new(2, 1, vec![0], vec![0]);
        for value in [1.0, -3.0, 2.0] {
            accumulator.observe(1, &[value]);
        }
        assert_eq!(accumulator.lowest(0).nth(1), Some(-3.0));
        assert_eq!(accumulator.highest(0).nth(1), Some(2.0));
        assert_eq!(accumulator.mean(0).nth(1), Some(0.0));

        accumulator.restart();
        accumulator.observe(1, &[5.0]);
        assert_eq!(accumulator.lowest(0).nth(1), Some(2.0));
        assert_eq!(accumulator.highest(0).nth(1), Some(5.0));
        assert_eq!(accumulator.mean(0).nth(1), Some(5.0));
        assert!(accumulator.last(0).next().unwrap().is_nan(), "row 0 was never observed");
    }
}
