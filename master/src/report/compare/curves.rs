//! The curves that the page of a comparison shows, with few enough points for a page of 2 MB.

use serde::Serialize;

use super::errors::ColumnErrors;
use super::grid::Grid;
use super::run::Curves;
use crate::report::instrument::Packed;

/// Numbers of all curves together: 1.2 MB in base64.
const MOST_NUMBERS: usize = 225_000;
/// Points of a curve, at least and at most.
const POINTS: [usize; 2] = [100, 600];

/// The curves of a column in the row that differs most.
#[derive(Debug, Serialize)]
pub(super) struct Curve {
    table: String,
    column: String,
    /// Name of the signal.
    signal: String,
    unit: String,
    /// Largest relative difference; `null` where it is infinite.
    relative: f64,
    /// Times, s.
    time: Packed,
    /// Values of the first run, then of the others at these times; none where one has no such column.
    values: Vec<Option<Packed>>,
}

/// How many points the curves have.
pub(super) struct Thinning {
    points: usize,
    most_curves: usize,
}

impl Thinning {
    /// For so many curves of a run and of so many others.
    pub fn of(curves: usize, others: usize) -> Self {
        let numbers = others + 2;
        let points = (MOST_NUMBERS / (numbers * curves.max(1))).clamp(POINTS[0], POINTS[1]);
        Self { points, most_curves: (MOST_NUMBERS / (points * numbers)).max(1) }
    }

    /// The curves of the row that differs most; none where the first run has no value there.
    pub fn curve(
        &self,
        worst: &ColumnErrors,
        first: &Curves,
        others: &[Option<Curves>],
    ) -> Option<Curve> {
        let own = row(first, &worst.row)?;
        let chosen = self.chosen(&first.time, worst.at_s);
        let times: Vec<f64> = chosen.iter().map(|index| first.time[*index]).collect();
        let mut values = vec![Some(Packed::of(chosen.iter().map(|index| own[*index])))];
        for other in others {
            let found = other.as_ref().and_then(|other| Some((other, row(other, &worst.row)?)));
            values.push(found.map(|(other, found)| Packed::of(at(&times, &other.time, found))));
        }
        Some(Curve {
            table: worst.table.clone(),
            column: worst.column.clone(),
            signal: worst.signal(),
            unit: worst.unit.clone(),
            relative: worst.relative,
            time: Packed::of(times),
            values,
        })
    }

    /// Indices of the times that are shown: evenly many, the last one, and that nearest to `at`.
    fn chosen(&self, times: &[f64], at: f64) -> Vec<usize> {
        let step = times.len().div_ceil(self.points).max(1);
        let mut chosen: Vec<usize> = (0..times.len()).step_by(step).collect();
        chosen.extend(times.len().checked_sub(1));
        chosen.push(times.partition_point(|time| *time < at).min(times.len().saturating_sub(1)));
        chosen.sort_unstable();
        chosen.dedup();
        chosen
    }

    /// As many of the curves as a page holds, those that differ most.
    pub fn most_different(&self, mut curves: Vec<Curve>) -> Vec<Curve> {
        if curves.len() > self.most_curves {
            curves.sort_by(|a, b| b.relative.total_cmp(&a.relative));
            curves.truncate(self.most_curves);
        }
        curves
    }
}

fn row<'c>(curves: &'c Curves, row: &str) -> Option<&'c [f64]> {
    let found = curves.rows.iter().find(|(own, _)| own == row);
    found.map(|(_, values)| values.as_slice())
}

/// The values of another curve at these times (or chainages), not-a-number beyond its ends.
pub(super) fn at(times: &[f64], own: &[f64], values: &[f64]) -> Vec<f64> {
    let grid = Grid::at(times, own);
    let is_within = |time: &f64| {
        let room = 1e-9 * time.abs().max(1.0);
        own.first().is_some_and(|begin| *time >= begin - room)
            && own.last().is_some_and(|end| *time <= end + room)
    };
    let found = grid.values(1, values).into_iter().zip(times);
    found.map(|(value, time)| if is_within(time) { value } else { f64::NAN }).collect()
}
