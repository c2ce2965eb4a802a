//! Elements of the ellipse and the bound of each.

use std::f64::consts::PI;

/// Nodes and weights of Gauss' rule with four points on [-1, 1].
const GAUSS: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    (-0.339_981_043_584_856_3, 0.652_145_154_862_546_2),
    (0.339_981_043_584_856_3, 0.652_145_154_862_546_2),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
];

/// Numbers of elements along the rolling direction and across.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cells {
    /// Along the rolling direction.
    pub along: usize,
    /// Across.
    pub across: usize,
}

/// Elements in the rectangle around an ellipse with a b = 1; an element that the ellipse cuts counts
/// whole, with the mean of the bound over it.
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
        let step = 2.0 / along as f64;
        for row in 0..across {
            let of_row = &mut bound[row * along..(row + 1) * along];
            for (node, weight) in GAUSS {
                let y = (2 * row + 1) as f64 / across as f64 - 1.0 + node / across as f64;
                let half_squared = 1.0 - y * y;
                let under = |x: f64| under_semicircle(x, half_squared);
                for (column, value) in of_row.iter_mut().enumerate() {
                    let x = step * column as f64 - 1.0;
                    *value += 0.5 * weight * (under(x + step) - under(x)) / step;
                }
            }
            let first = of_row.iter().position(|value| *value > 0.0).unwrap_or(0);
            rows.push((first, along - first));
        }
        // The quadrature leaves a trifle of the load at the ends of the rows.
        let area = 4.0 * a * b / (along * across) as f64;
        let load: f64 = bound.iter().sum::<f64>() * area;
        let scale = 2.0 / 3.0 * PI * a * b / load;
        bound.iter_mut().for_each(|value| *value *= scale);
        Self { cells, size: [2.0 * a / along as f64, 2.0 * b / across as f64], rows, bound }
    }

    /// Middle of an element.
    pub(super) fn middle(&self, column: usize, row: usize) -> (f64, f64) {
        let at = |index: usize, count: usize, size: f64| {
            0.5 * size * ((2 * index + 1) as f64 - count as f64)
        };
        (at(column, self.cells.along, self.size[0]), at(row, self.cells.across, self.size[1]))
    }
}

/// Integral of sqrt(c² - x²) from 0 to x, where that is real.
fn under_semicircle(x: f64, half_squared: f64) -> f64 {
    let half = half_squared.max(0.0).sqrt();
    if half == 0.0 {
        return 0.0;
    }
    let x = x.clamp(-half, half);
    0.5 * (x * (half_squared - x * x).max(0.0).sqrt() + half_squared * libm::asin(x / half))
}
