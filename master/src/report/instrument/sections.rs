//! The section of a rail where its foot is warmest, and at its probes.

use field::{FieldError, FieldReader};
use serde::Serialize;

use super::decimate::Picks;
use super::packed::{Packed, PackedRows};
use crate::report::data::{MainFigure, RailData};

/// Numbers that the sections of all rails may take.
const BUDGET: usize = 90_000;

/// Middles that differ by no more than this are the same, m.
const SAME: f64 = 1e-9;

/// The sections of a rail at some times.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Sections {
    /// Times of the snapshots that are shown, s.
    time: Packed,
    /// Chainage of each probe, m.
    chainage: Packed,
    /// Middle of each cell, to the right of the rail's middle, m.
    y: Packed,
    /// Middle of each cell, below the running surface, m.
    z: Packed,
    /// Width and height of the cells, m.
    size: [f64; 2],
    /// Rise above the initial state, K: a row for each time and probe, with its cells.
    rise: PackedRows,
    /// The section where the foot is warmest, where the store has it.
    warmest: Option<Warmest>,
}

/// The section where the foot is warmest at each time, the mean of left and right.
#[derive(Debug, Clone, Serialize)]
struct Warmest {
    /// Chainage at each time, m.
    chainage: Packed,
    /// Rise above the initial state, K: a row for each time, with its cells.
    rise: PackedRows,
}

impl Sections {
    /// Whether the section where the foot is warmest is there.
    pub fn has_warmest(&self) -> bool {
        self.warmest.is_some()
    }

    /// Reads the sections of one of so many rails, those nearest to the wanted times among them;
    /// `None` where none were kept.
    pub fn read(
        reader: &FieldReader,
        wanted: &[f64],
        rails: usize,
    ) -> Result<Option<Self>, FieldError> {
        let (Some(sections), times) = (&reader.axes().sections, reader.times()) else {
            return Ok(None);
        };
        let values = sections.values() + sections.y.len();
        let most = BUDGET / (values * rails.max(1)).max(1);
        let most = most.saturating_sub(wanted.len()).clamp(2, 200);
        let picks = Picks::of(times.len(), most).with_nearest(times, wanted);
        let (mut rows, mut chainages, mut of_warmest) = (vec![], vec![], vec![]);
        let numbers = |rises: Vec<f32>| rises.into_iter().map(f64::from).collect::<Vec<_>>();
        for time in picks.values(times) {
            let rises = numbers(reader.sections_at_time(time)?);
            rows.extend(rises.chunks(sections.y.len().max(1)).map(<[f64]>::to_vec));
            if let Some(warmest) = reader.warmest_at_time(time)? {
                chainages.push(warmest.chainage);
                of_warmest.push(numbers(warmest.rise));
            }
        }
        let warmest = (!chainages.is_empty())
            .then(|| Warmest { chainage: Packed::of(chainages), rise: PackedRows::of(of_warmest) });
        let packed = |values: &[f64]| Packed::of(values.iter().copied());
        Ok(Some(Self {
            time: Packed::of(picks.values(times)),
            chainage: packed(&sections.chainage),
            y: packed(&sections.y),
            z: packed(&sections.z),
            size: [spacing(&sections.y), spacing(&sections.z)],
            rise: PackedRows::of(rows),
            warmest,
        }))
    }
}

/// Says where the sections are, and how one comes to where the foot is warmest, if none was kept there.
pub(super) fn elsewhere(rail: &RailData, probes: &[f64], element_length: f64) -> Option<String> {
    let warmest = warmest_foot(rail)?.chainage_m?;
    if probes.iter().any(|probe| (probe - warmest).abs() <= element_length) {
        return None;
    }
    let probes: Vec<String> = probes.iter().map(|probe| format!("{probe:.1} m")).collect();
    let kept = match probes.as_slice() {
        [] => "no section was kept".to_owned(),
        _ => format!("sections were kept at {} only", probes.join(", ")),
    };
    Some(format!(
        "The foot of the {} rail is warmest at chainage {warmest:.1} m, but {kept}: {{ chainage_m = {warmest:.1} }} \
         among the probes of the scenario (heat.probe) keeps the one there, with section.model = \"2d\".",
        rail.side
    ))
}

/// What the report says of the warmest foot of a rail.
pub(super) fn warmest_foot(rail: &RailData) -> Option<&MainFigure> {
    let key = format!("{}.foot.highest", rail.side);
    rail.figures.iter().find(|figure| figure.key == key)
}

/// The least distance between middles of cells that differ; zero if all are the same.
fn spacing(middles: &[f64]) -> f64 {
    let mut sorted = middles.to_vec();
    sorted.sort_by(f64::total_cmp);
    let distances = sorted.windows(2).map(|pair| pair[1] - pair[0]);
    let least = distances.filter(|distance| *distance > SAME).fold(f64::INFINITY, f64::min);
    if least.is_finite() { least } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::spacing;

    #[test]
    fn cells_are_as_wide_as_their_middles_are_apart() {
        assert!((spacing(&[0.002, -0.002, 0.006, 0.002, -0.006]) - 0.004).abs() < 1e-15);
        assert_eq!(spacing(&[0.002]), 0.0);
    }
}
