//! What can be foreseen before the first step: wheels outside the modelled rail, which heat nothing.

use crate::train::prepare_rail::Extent;
use crate::train::rail::Rail;
use crate::train::roles::rail_input;

/// A sentence on wheels that stand outside the modelled rail at the start, and one on wheels that
/// leave it if they keep their speed for `duration`, s.
pub fn wheels_outside(rail: &Rail, extent: &Extent, duration: f64) -> Vec<String> {
    let blocks = || rail.inputs.values.chunks_exact(rail_input::NAMES.len());
    let positions = || blocks().map(|block| block[rail_input::POSITION]);
    let ahead = blocks().map(|b| b[rail_input::POSITION] + duration * b[rail_input::SPEED]);
    let (tail, head) = (lowest(positions()), highest(positions()));
    let farthest = highest(ahead);
    let (begin, end) = (extent.begin, extent.begin + extent.length);
    let mut sentences = vec![];
    if tail < begin || head > end {
        sentences.push(format!(
            "at the start wheels stand from chainage {tail:.1} m to {head:.1} m, but the rail is modelled \
             from {begin} m to {end} m only (heat.begin_m, heat.length_m); wheels outside of it heat nothing"
        ));
    }
    if head <= end && farthest > end {
        sentences.push(format!(
            "at the speed of the start the first wheel comes to chainage {farthest:.1} m, but the rail is \
             modelled to {end} m only (heat.length_m); wheels beyond it heat nothing"
        ));
    }
    sentences
}

fn lowest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(f64::INFINITY, f64::min)
}

fn highest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(f64::NEG_INFINITY, f64::max)
}
