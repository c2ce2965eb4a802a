//! Where in the section the rise is read.
//!
//! It is read on the middle line, linear between the middles of rows; at the foot on its underside.

use super::cells::{Cell, Cells};
use super::modes::Modes;
use super::running_surface::crown_band;

/// Rows of shapes: a product with an element's amplitudes is the rise, K.
#[derive(Clone, Debug, PartialEq)]
pub struct Readings {
    /// Surface, the depths asked for, foot.
    pub levels: Vec<Vec<f64>>,
    /// The middle line, row after row from the crown.
    pub rows: Vec<Vec<f64>>,
    /// Depth of the middle of each row, m.
    pub depths: Vec<f64>,
}

impl Readings {
    /// The rows of a section, and the levels at `depths` in m.
    pub fn new(cells: &Cells, modes: &Modes, depths: &[f64]) -> Self {
        let middles: Vec<Vec<(usize, f64)>> =
            (0..cells.rows).map(|row| middle_of_row(cells, row)).collect();
        let step = cells.height / cells.rows as f64;
        let last = cells.rows - 1;
        let mix = |row: usize, weight: f64| {
            middles[row].iter().map(move |(cell, part)| (*cell, part * weight))
        };
        let at_depth = |depth: &f64| {
            let position = (depth / step - 0.5).clamp(0.0, last as f64);
            let above = position as usize;
            let share = position - above as f64;
            modes.weighted(mix(above, 1.0 - share).chain(mix((above + 1).min(last), share)))
        };
        // On a parabola through the last two rows that is level at the underside, where next to nothing flows.
        let foot = modes.weighted(mix(last, 9.0 / 8.0).chain(mix(last - 1, -1.0 / 8.0)));
        let levels = std::iter::once(modes.weighted(crown(cells)))
            .chain(depths.iter().map(at_depth))
            .chain([foot])
            .collect();
        Self {
            levels,
            rows: middles.iter().map(|row| modes.weighted(row.iter().copied())).collect(),
            depths: (0..cells.rows).map(|row| (row as f64 + 0.5) * step).collect(),
        }
    }
}

/// The cells of a row nearest to the middle line, with equal weights.
///
/// Where all of a row was merged into its neighbours, those of the nearest row that has cells.
fn middle_of_row(cells: &Cells, row: usize) -> Vec<(usize, f64)> {
    let cells = &cells.cells;
    let from_row = |cell: &Cell| cell.row.abs_diff(row);
    let nearest_row = cells.iter().map(from_row).min().unwrap_or(0);
    let in_row = || cells.iter().enumerate().filter(|(_, cell)| from_row(cell) == nearest_row);
    let distance = in_row().map(|(_, cell)| cell.middle.y.abs()).fold(f64::INFINITY, f64::min);
    let nearest: Vec<usize> = in_row()
        .filter(|(_, cell)| cell.middle.y.abs() <= distance + 1e-9)
        .map(|(cell, _)| cell)
        .collect();
    nearest.iter().map(|cell| (*cell, 1.0 / nearest.len() as f64)).collect()
}

/// The cells of the crown's middle band with their shares.
fn crown(cells: &Cells) -> Vec<(usize, f64)> {
    let facets = crown_band(&cells.facets);
    let length: f64 = facets.iter().map(|facet| facet.length).sum();
    facets.iter().map(|facet| (facet.cell, facet.length / length)).collect()
}
