//! A heated rail: its temperature field and its foot.

use std::ops::Range;
use std::path::Path;

use field::{FieldError, FieldReader};
use serde::Serialize;

use super::decimate::Picks;
use super::packed::{Packed, PackedRows};
use super::sections::Sections;
use crate::report::data::{Foot, RailData};

/// Columns of the field along the track, at most.
const MOST_COLUMNS: usize = 160;

/// Rises that are no more than this are none, K.
const SMALL: f32 = 1e-6;

/// Numbers that the fields of all rails may take.
const BUDGET: usize = 200_000;

/// A heated rail.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Rail {
    /// `left` or `right`.
    side: String,
    /// What cameras see of its foot.
    foot: Option<FootOverTime>,
    /// Its temperature field.
    field: Option<Field>,
}

/// The foot over time.
#[derive(Debug, Clone, Serialize)]
struct FootOverTime {
    time: Packed,
    /// Highest along the track, K.
    highest: Packed,
    /// Under the last wheel, K.
    under_train: Packed,
}

/// The temperature field, decimated.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Field {
    /// Number of elements in a column: of these the rise farthest from zero is shown.
    elements: usize,
    /// One snapshot of so many is shown.
    every: usize,
    /// Times of the snapshots, s.
    time: Packed,
    /// Chainage of the middle of each column, m; only those between which the rail has changed.
    chainage: Packed,
    /// Depth of the middle of each row below the running surface, m.
    depth: Packed,
    /// Rise above the initial state, K: a row for each time and depth, with its columns.
    rise: PackedRows,
    /// The whole section where the foot is warmest and at the probes, of rails that have one.
    pub sections: Option<Sections>,
    /// Chainage of these probes, m.
    #[serde(skip)]
    pub probes: Vec<f64>,
    /// Length of an element, m.
    #[serde(skip)]
    pub element_length: f64,
}

impl Rail {
    /// A rail of which the report knows the foot, with its field.
    pub fn of(rail: &RailData, field: Option<Field>) -> Self {
        let over_time = |foot: &Foot| {
            let picks = Picks::of(foot.time.len(), 800);
            let packed = |values: &[f64]| Packed::of(picks.values(values));
            FootOverTime {
                time: packed(&foot.time),
                highest: packed(&foot.highest),
                under_train: packed(&foot.under_train),
            }
        };
        Self { side: rail.side.clone(), foot: rail.foot.as_ref().map(over_time), field }
    }
}

impl Field {
    /// Reads the field of one of so many rails; the times that are wanted are among those that are shown.
    /// `None` if it has no snapshot.
    pub fn read(store: &Path, wanted: &[f64], rails: usize) -> Result<Option<Self>, FieldError> {
        let reader = FieldReader::open(store)?;
        let (axes, times) = (reader.axes(), reader.times());
        if times.is_empty() {
            return Ok(None);
        }
        let depths = axes.depth.len().max(1);
        let columns = axes.chainage.len().min(MOST_COLUMNS);
        let most = BUDGET / (columns * depths * rails.max(1));
        let most = most.saturating_sub(wanted.len()).clamp(4, 200);
        let picks = Picks::of(times.len(), most).with_nearest(times, wanted);
        let mut changed = axes.chainage.len()..0;
        for time in picks.values(times) {
            let of_one = changed_elements(&reader.at_time(time)?.rise, depths);
            changed = changed.start.min(of_one.start)..changed.end.max(of_one.end);
        }
        let shown = if changed.is_empty() { 0..axes.chainage.len() } else { changed };
        let elements = shown.len().div_ceil(MOST_COLUMNS).max(1);
        let mut rows = vec![];
        for time in picks.values(times) {
            let rise = reader.at_time(time)?.rise;
            let rise = &rise[shown.start * depths..shown.end * depths];
            rows.extend((0..depths).map(|depth| row(rise, depth, depths, elements)));
        }
        let middle = |span: &[f64]| span.iter().sum::<f64>() / span.len() as f64;
        Ok(Some(Self {
            elements,
            every: picks.every,
            time: Packed::of(picks.values(times)),
            chainage: Packed::of(axes.chainage[shown].chunks(elements).map(middle)),
            depth: Packed::of(axes.depth.iter().copied()),
            rise: PackedRows::of(rows),
            sections: Sections::read(&reader, wanted, rails)?,
            probes: axes.sections.as_ref().map_or(vec![], |sections| sections.chainage.clone()),
            element_length: axes.chainage.windows(2).next().map_or(0.0, |pair| pair[1] - pair[0]),
        }))
    }
}

/// The elements from the first to the last whose temperature has changed at some depth.
fn changed_elements(rise: &[f32], depths: usize) -> Range<usize> {
    let changed = |column: &[f32]| column.iter().any(|rise| rise.abs() > SMALL);
    let columns = || rise.chunks_exact(depths);
    match (columns().position(changed), columns().rposition(changed)) {
        (Some(first), Some(last)) => first..last + 1,
        _ => rise.len() / depths..0,
    }
}

/// The rises at one depth: of so many elements each the one farthest from zero.
fn row(rise: &[f32], depth: usize, depths: usize, elements: usize) -> Vec<f64> {
    let along: Vec<f64> = rise.iter().skip(depth).step_by(depths).map(|&r| r.into()).collect();
    let farthest = |a: f64, &b: &f64| if b.abs() > a.abs() { b } else { a };
    along.chunks(elements).map(|span| span.iter().fold(0.0, farthest)).collect()
}

#[cfg(test)]
mod tests {
    use super::{changed_elements, row};

    /// Two depths of four elements: the second depth has 1, -5, 2, 3.
    #[test]
    fn of_some_elements_the_rise_farthest_from_zero_is_shown() {
        let rise = [9.0, 1.0, 9.0, -5.0, 9.0, 2.0, 9.0, 3.0];
        assert_eq!(row(&rise, 1, 2, 2), [-5.0, 3.0]);
        assert_eq!(row(&rise, 1, 2, 1), [1.0, -5.0, 2.0, 3.0]);
        assert_eq!(row(&rise, 1, 2, 3), [-5.0, 3.0]);
    }

    /// Two depths of four elements, of which the second and the third are warm or cold somewhere.
    #[test]
    fn elements_that_have_not_changed_are_left_out() {
        let rise = [0.0, 1e-9, 0.0, 0.1, -0.1, 0.0, 0.0, 0.0];
        assert_eq!(changed_elements(&rise, 2), 1..3);
        assert!(changed_elements(&[0.0; 8], 2).is_empty());
    }
}
