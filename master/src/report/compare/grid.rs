//! The times at which two curves are compared.

use serde::Serialize;

/// Times that differ by less than this part, and in s, are one.
const SAME: f64 = 1e-9;

/// How the values of two curves come to the same times.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum How {
    /// Both have these times.
    Shared,
    /// The times are those of the coarser one; the other one's values are interpolated linearly.
    Interpolated,
}

/// The times at which two curves are compared.
pub(super) struct Grid {
    /// How the values come there.
    pub how: How,
    /// The times, s.
    pub time: Vec<f64>,
    /// Where these times lie among those of each curve.
    points: [Vec<Point>; 2],
}

/// A point of a curve: behind a value, by a part of the way to the next one.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Point {
    index: usize,
    part: f64,
}

impl Grid {
    /// The grid of curves with these times, which rise.
    pub fn of(first: &[f64], other: &[f64]) -> Self {
        let shared = shared(first, other);
        let [in_first, in_other] = [within(first, other), within(other, first)];
        if !shared.is_empty() && shared.len() == in_first.len().min(in_other.len()) {
            let point = |index| Point { index, part: 0.0 };
            return Self {
                how: How::Shared,
                time: shared.iter().map(|(index, _)| first[*index]).collect(),
                points: [
                    shared.iter().map(|(index, _)| point(*index)).collect(),
                    shared.iter().map(|(_, index)| point(*index)).collect(),
                ],
            };
        }
        let time = if in_first.len() <= in_other.len() { in_first } else { in_other };
        let points = [first, other].map(|own| time.iter().map(|at| point(own, *at)).collect());
        Self { how: How::Interpolated, time: time.to_vec(), points }
    }

    /// The grid of these times themselves, with the other curve's interpolated.
    pub fn at(times: &[f64], other: &[f64]) -> Self {
        let points = [times, other].map(|own| times.iter().map(|at| point(own, *at)).collect());
        Self { how: How::Interpolated, time: times.to_vec(), points }
    }

    /// The values of the first (0) or the other (1) curve at the times.
    pub fn values(&self, which: usize, values: &[f64]) -> Vec<f64> {
        let at = |Point { index, part }: &Point| match values.get(index + 1) {
            Some(next) if *part > 0.0 => values[*index] + part * (next - values[*index]),
            _ => values.get(*index).copied().unwrap_or(f64::NAN),
        };
        self.points[which].iter().map(at).collect()
    }
}

/// Pairs of indices of the same time.
pub(super) fn shared(first: &[f64], other: &[f64]) -> Vec<(usize, usize)> {
    let (mut i, mut j, mut pairs) = (0, 0, vec![]);
    while let (Some(&a), Some(&b)) = (first.get(i), other.get(j)) {
        if (a - b).abs() <= SAME * a.abs().max(1.0) {
            pairs.push((i, j));
            (i, j) = (i + 1, j + 1);
        } else if a < b {
            i += 1;
        } else {
            j += 1;
        }
    }
    pairs
}

/// The times that lie within those of the other.
fn within<'t>(own: &'t [f64], other: &[f64]) -> &'t [f64] {
    let (Some(&begin), Some(&end)) = (other.first(), other.last()) else { return &[] };
    let room = |time: f64| SAME * time.abs().max(1.0);
    let from = own.partition_point(|time| *time < begin - room(begin));
    let to = own.partition_point(|time| *time <= end + room(end));
    &own[from..to.max(from)]
}

/// Where a time lies among rising times.
fn point(times: &[f64], at: f64) -> Point {
    let index = times.partition_point(|time| *time <= at).saturating_sub(1);
    let part = match (times.get(index), times.get(index + 1)) {
        (Some(from), Some(to)) if to > from => ((at - from) / (to - from)).clamp(0.0, 1.0),
        _ => 0.0,
    };
    Point { index, part }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_of_one_interval_are_compared_where_they_are() {
        let grid = Grid::of(&[0.0, 0.1, 0.2, 0.3], &[0.1 + 1e-12, 0.2, 0.3, 0.4]);
        assert_eq!((grid.how, grid.time.as_slice()), (How::Shared, &[0.1, 0.2, 0.3][..]));
        assert_eq!(grid.values(1, &[1.0, 2.0, 3.0, 4.0]), [1.0, 2.0, 3.0]);
        let every_second = Grid::of(&[0.0, 0.1, 0.2, 0.3, 0.4], &[0.0, 0.2, 0.4]);
        assert_eq!((every_second.how, every_second.time.len()), (How::Shared, 3));
    }

    /// y = 10 t at 0, 1, 2 s against times of another clock: linear interpolation is exact.
    #[test]
    fn analytic_other_times_are_interpolated_at_those_of_the_coarser() {
        let grid = Grid::of(&[0.0, 0.4, 0.8, 1.2, 1.6, 2.0], &[0.5, 1.5, 2.5]);
        assert_eq!((grid.how, grid.time.as_slice()), (How::Interpolated, &[0.5, 1.5][..]));
        let line = [0.0, 4.0, 8.0, 12.0, 16.0, 20.0];
        for (value, expected) in grid.values(0, &line).iter().zip([5.0, 15.0]) {
            assert!((value - expected).abs() < 1e-12, "{value}");
        }
        assert_eq!(grid.values(1, &[1.0, 2.0, 3.0]), [1.0, 2.0]);
    }

    #[test]
    fn runs_that_never_overlap_have_no_time_in_common() {
        assert!(Grid::of(&[0.0, 1.0], &[2.0, 3.0]).time.is_empty());
        assert!(Grid::of(&[], &[2.0]).time.is_empty());
    }
}
