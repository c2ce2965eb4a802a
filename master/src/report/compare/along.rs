//! The rises of surface and foot along the rails, which the page of a comparison draws on each other.

use field::{Axes, FieldError, FieldReader, is_rail_field};
use serde::Serialize;

use super::curves::at;
use super::error::CompareError;
use super::fields::names;
use super::grid::shared;
use super::run::Run;
use crate::report::instrument::Packed;

/// Points of a curve, at most; those of the largest rises and differences come on top.
const MOST_POINTS: usize = 1200;

/// The row of cells of a level among so many depths.
type RowOf = fn(usize) -> usize;

/// The levels.
const LEVELS: [(&str, RowOf); 2] = [("foot", |depths| depths - 1), ("surface", |_| 0)];

/// The rises along a rail at one level and time.
#[derive(Debug, Serialize)]
pub(super) struct AlongRail {
    /// Name of the field.
    field: String,
    /// `foot` or `surface`.
    level: &'static str,
    /// How far below the running surface that is in the first run, m.
    depth: f64,
    /// The last time that the runs have in common, s.
    time: f64,
    /// Chainages of the first run's elements, m.
    chainage: Packed,
    /// Rises there in K: of the first run, then of the others; none where one has no such field or time.
    values: Vec<Option<Packed>>,
}

/// The curves of all fields of the first run that another run has too.
pub(super) fn along_rails(
    first: &Run,
    others: &[Option<&Run>],
) -> Result<Vec<AlongRail>, CompareError> {
    let mut curves = vec![];
    for name in names(first)? {
        let own = FieldReader::open(&first.folder.join(&name))?;
        let open = |run: &Option<&Run>| {
            let path = run.map(|run| run.folder.join(&name));
            path.filter(|path| is_rail_field(path)).map(|path| FieldReader::open(&path)).transpose()
        };
        let others = others.iter().map(open).collect::<Result<Vec<_>, _>>()?;
        let (time, common) = last_common(&own, others);
        if common.iter().any(Option::is_some) {
            curves.extend(of_field(&name, time, &own, &common)?);
        }
    }
    Ok(curves)
}

/// The last time that the first and the others have; those that have none in common with it are left out.
fn last_common(
    first: &FieldReader,
    others: Vec<Option<FieldReader>>,
) -> (f64, Vec<Option<FieldReader>>) {
    let mut times = first.times().to_vec();
    let mut keep = |other: Option<FieldReader>| {
        let other = other?;
        let left: Vec<f64> =
            shared(&times, other.times()).into_iter().map(|(index, _)| times[index]).collect();
        if left.is_empty() {
            return None;
        }
        times = left;
        Some(other)
    };
    let others = others.into_iter().map(&mut keep).collect();
    (times.last().copied().unwrap_or_default(), others)
}

/// The foot, then the surface.
fn of_field(
    name: &str,
    time: f64,
    first: &FieldReader,
    others: &[Option<FieldReader>],
) -> Result<Vec<AlongRail>, FieldError> {
    let axes = first.axes();
    let own = first.at_time(time)?.rise;
    let mut of_others = vec![];
    for other in others {
        of_others.push(match other {
            Some(other) => Some((other.axes(), other.at_time(time)?.rise)),
            None => None,
        });
    }
    let mut levels = vec![];
    for (level, row_of) in LEVELS {
        let own = row(axes, &own, row_of);
        let at_own = |(other, rise): &(&Axes, Vec<f32>)| {
            at(&axes.chainage, &other.chainage, &row(other, rise, row_of))
        };
        let of_others: Vec<_> = of_others.iter().map(|other| other.as_ref().map(at_own)).collect();
        let chosen = chosen(&own, &of_others);
        let picked = |values: &[f64]| Packed::of(chosen.iter().map(|index| values[*index]));
        let values = of_others.iter().map(|values| values.as_deref().map(picked));
        levels.push(AlongRail {
            field: name.to_owned(),
            level,
            depth: axes.depth[row_of(axes.depth.len())],
            time,
            chainage: picked(&axes.chainage),
            values: std::iter::once(Some(picked(&own))).chain(values).collect(),
        });
    }
    Ok(levels)
}

/// The rises of a snapshot in the row of a level.
fn row(axes: &Axes, rise: &[f32], row_of: RowOf) -> Vec<f64> {
    let depths = axes.depth.len();
    rise.iter().skip(row_of(depths)).step_by(depths).map(|&rise| rise.into()).collect()
}

/// Elements that are shown: evenly many, the last one, and those of the largest rises and differences.
fn chosen(own: &[f64], others: &[Option<Vec<f64>>]) -> Vec<usize> {
    let step = own.len().div_ceil(MOST_POINTS).max(1);
    let mut chosen: Vec<usize> = (0..own.len()).step_by(step).collect();
    chosen.extend(own.len().checked_sub(1));
    let largest = |values: &mut dyn Iterator<Item = f64>| {
        let finite = values.map(f64::abs).enumerate().filter(|(_, size)| size.is_finite());
        finite.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index)
    };
    chosen.extend(largest(&mut own.iter().copied()));
    for other in others.iter().flatten() {
        chosen.extend(largest(&mut other.iter().copied()));
        chosen.extend(largest(&mut other.iter().zip(own).map(|(other, own)| other - own)));
    }
    chosen.sort_unstable();
    chosen.dedup();
    chosen
}

#[cfg(test)]
mod tests {
    use super::chosen;

    /// Of 5000 elements one in five is shown, and the peaks between them too.
    #[test]
    fn peaks_are_shown_however_long_the_rail() {
        let mut own = vec![0.0; 5000];
        own[1001] = 2.0;
        let mut other = vec![0.0; 5000];
        (other[1002], other[2003], other[0]) = (1.0, -1.5, f64::NAN);
        let chosen = chosen(&own, &[Some(other), None]);
        assert!(chosen.len() <= 1010, "{}", chosen.len());
        for index in [0, 1001, 2003, 4999] {
            assert!(chosen.contains(&index), "{index}");
        }
        assert!(chosen.is_sorted());
    }
}
