//! Elements of the ellipse and the bound of each.

use std::f64::consts::PI;

/// Numbers of elements along the rolling direction and across.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cells {
    /// Along the rolling direction.
    pub along: usize,
    /// Across.
    pub across: usize,
}

/// Elements in the rectangle around an ellipse with a b = 1; those count whose middle lies within it.
pub(super) struct Grid {
    pub cells: Cells,
    /// Length of an element along and across.
    pub size: [f64; 2],
    /// First element along of each row across, and the one after its last.
    pub rows: Vec<(usize, usize)>,
    /// Greatest traction of each element, row by row; 0 outside the ellipse.
    pub bound: Vec<f64>,
}

impl Grid {
    /// Elements of an ellipse with the semi-axes `a` and `b`.
    pub(super) fn new(a: f64, b: f64, cells: Cells) -> Self {
        let Cells { along, across } = cells;
        let mut bound = vec![0.0; along * across];
        let mut rows = Vec::with_capacity(across);
        for row in 0..across {
            let of_row = &mut bound[row * along..(row + 1) * along];
            let y = (2 * row + 1) as f64 / across as f64 - 1.0;
            for (column, value) in of_row.iter_mut().enumerate() {
                let x = (2 * column + 1) as f64 / along as f64 - 1.0;
                *value = (1.0 - x * x - y * y).max(0.0).sqrt();
            }
            let first = of_row.iter().position(|value| *value > 0.0).unwrap_or(0);
            rows.push((first, along - first));
        }
        // The elements together are as large as the ellipse, and carry the whole load.
        let elements: usize = rows.iter().map(|(first, end)| end - first).sum();
        let area = PI * a * b / elements as f64;
        let stretch = (area * (along * across) as f64 / (4.0 * a * b)).sqrt();
        let load: f64 = bound.iter().sum::<f64>() * area;
        let scale = 2.0 / 3.0 * PI * a * b / load;
        bound.iter_mut().for_each(|value| *value *= scale);
        let size = [2.0 * stretch * a / along as f64, 2.0 * stretch * b / across as f64];
        Self { cells, size, rows, bound }
    }

    /// Middle of an element.
    pub(super) fn middle(&self, column: usize, row: usize) -> (f64, f64) {
        let at = |index: usize, count: usize, size: f64| {
            0.5 * size * ((2 * index + 1) as f64 - count as f64)
        };
        (at(column, self.cells.along, self.size[0]), at(row, self.cells.across, self.size[1]))
    }
}
