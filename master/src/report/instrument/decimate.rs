//! Which records of a run are shown, and the extremes of those between them.

use std::ops::Range;

/// Records of which a curve is made at least.
pub(super) const FEWEST: usize = 40;

/// Some records of many: the first, every so many after it, and the last.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Picks {
    /// One record of so many is shown.
    pub every: usize,
    /// Numbers of the records that are shown, rising.
    pub records: Vec<usize>,
}

impl Picks {
    /// At most some `most` of `count` records.
    pub fn of(count: usize, most: usize) -> Self {
        let every = count.div_ceil(most.max(2)).max(1);
        let mut records: Vec<usize> = (0..count).step_by(every).collect();
        if records.last().is_some_and(|&last| last + 1 < count) {
            records.push(count - 1);
        }
        Self { every, records }
    }

    /// So many records at most that `columns` numbers of each fit into `budget` numbers, but [`FEWEST`].
    pub fn within(budget: usize, columns: usize, count: usize) -> Self {
        Self::of(count, (budget / columns.max(1)).clamp(FEWEST, 800))
    }

    /// The same with the records nearest to wanted times, of records at `times`.
    pub fn with_nearest(mut self, times: &[f64], wanted: &[f64]) -> Self {
        let nearest = |&wanted: &f64| {
            let distance = |index: &usize| (times[*index] - wanted).abs();
            (0..times.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))
        };
        self.records.extend(wanted.iter().filter_map(nearest));
        self.records.sort_unstable();
        self.records.dedup();
        self
    }

    /// The values of the records that are shown.
    pub fn values<'v>(&'v self, values: &'v [f64]) -> impl Iterator<Item = f64> + 'v {
        self.records.iter().map(|&record| values[record])
    }

    /// The lowest value since the shown record before, of each shown record.
    pub fn lowest<'v>(&'v self, values: &'v [f64]) -> impl Iterator<Item = f64> + 'v {
        self.spans().map(|span| values[span].iter().copied().fold(f64::NAN, f64::min))
    }

    /// The highest value since the shown record before, of each shown record.
    pub fn highest<'v>(&'v self, values: &'v [f64]) -> impl Iterator<Item = f64> + 'v {
        self.spans().map(|span| values[span].iter().copied().fold(f64::NAN, f64::max))
    }

    /// For each shown record the records since the shown one before, with itself.
    fn spans(&self) -> impl Iterator<Item = Range<usize>> {
        let begins = std::iter::once(0).chain(self.records.iter().map(|record| record + 1));
        begins.zip(&self.records).map(|(begin, &record)| begin..record + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_and_the_last_record_are_shown() {
        assert_eq!(Picks::of(5, 10), Picks { every: 1, records: vec![0, 1, 2, 3, 4] });
        assert_eq!(Picks::of(10, 4), Picks { every: 3, records: vec![0, 3, 6, 9] });
        assert_eq!(Picks::of(9, 4).records, [0, 3, 6, 8]);
        assert_eq!(Picks::of(0, 4).records, [0_usize; 0]);
        assert_eq!(Picks::within(1000, 10, 1000).records.len(), 101);
    }

    #[test]
    fn property_no_extreme_is_lost_between_shown_records() {
        let mut values = vec![0.0; 1000];
        (values[123], values[998]) = (-4.0, 9.0);
        let picks = Picks::of(1000, 50);
        assert_eq!(picks.lowest(&values).fold(0.0, f64::min), -4.0);
        assert_eq!(picks.highest(&values).fold(0.0, f64::max), 9.0);
        assert_eq!(picks.values(&values).count(), picks.lowest(&values).count());
    }
}
