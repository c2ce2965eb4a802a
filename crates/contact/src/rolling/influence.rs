//! Displacement of two half-spaces against each other by a traction on one element.
//!
//! A point force Q along x moves the surface of two equal bodies against each other by
//!
//! ```text
//! ux = Q/(pi G) ((1 - nu)/r + nu x²/r³),    uy = Q/(pi G) nu x y/r³                                (C14)
//! ```
//!
//! (Boussinesq and Cerruti; Johnson, Contact Mechanics, eq. 3.75). Over a rectangle the integrals of 1/r,
//! x²/r³, y²/r³ and x y/r³ are sums over its corners of
//!
//! ```text
//! y asinh(x/|y|) for x²/r³,   x asinh(y/|x|) for y²/r³,   -r for x y/r³,   1/r = x²/r³ + y²/r³
//! ```

use super::grid::Cells;
use std::f64::consts::FRAC_1_PI;

/// Derivative along x of the displacement by a unit traction on one element, for all distances.
///
/// In single precision, which halves the time and is far finer than the grid.
///
/// It is the displacement one element ahead less the displacement here, by the length of an element:
/// what a particle takes up while it travels by one element.
pub(super) struct Influence {
    along: usize,
    /// Along x by a traction along x; by the distance across, then along.
    xx: Vec<f32>,
    /// Along y by a traction along x, or the reverse; for a place further to positive y.
    xy: Vec<f32>,
    /// Along y by a traction along y.
    yy: Vec<f32>,
    /// Displacement along x by a traction along x, and the same for y, at an element of the same column,
    /// by the length of an element; by the distance across.
    column: Vec<[f64; 2]>,
}

impl Influence {
    /// For elements of this size.
    pub(super) fn new(size: [f64; 2], cells: Cells, poisson_ratio: f64) -> Self {
        let Cells { along, across } = cells;
        let length = 2 * along - 1;
        let mut influence = Self {
            along,
            xx: Vec::with_capacity(length * across),
            xy: Vec::with_capacity(length * across),
            yy: Vec::with_capacity(length * across),
            column: Vec::with_capacity(across),
        };
        for row in 0..across {
            // The source lies ahead by `index - (along - 1)` elements.
            for index in 0..length {
                let behind = along as f64 - 1.0 - index as f64;
                let at = |elements: f64| {
                    displacement(elements * size[0], row as f64 * size[1], size, poisson_ratio)
                };
                let (here, ahead) = (at(behind), at(behind + 1.0));
                if behind == 0.0 {
                    influence.column.push([here[0] / size[0], here[2] / size[0]]);
                }
                influence.xx.push(((ahead[0] - here[0]) / size[0]) as f32);
                influence.xy.push(((ahead[1] - here[1]) / size[0]) as f32);
                influence.yy.push(((ahead[2] - here[2]) / size[0]) as f32);
            }
        }
        influence
    }

    /// xx, xy and yy at an element of column `column` by the elements of a row at a distance of `across`
    /// rows.
    #[inline]
    pub(super) fn by_row(&self, column: usize, across: usize) -> [&[f32]; 3] {
        let begin = across * (2 * self.along - 1) + self.along - 1 - column;
        let end = begin + self.along;
        [&self.xx[begin..end], &self.xy[begin..end], &self.yy[begin..end]]
    }

    /// Displacement by the element of the same column at a distance of `across` rows.
    pub(super) fn in_column(&self, across: usize) -> [f64; 2] {
        self.column[across]
    }
}

/// Displacements xx, xy and yy at (x, y) from the middle of an element with unit traction, G = 1.
fn displacement(x: f64, y: f64, size: [f64; 2], nu: f64) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for (x, sign_x) in [(x + 0.5 * size[0], 1.0), (x - 0.5 * size[0], -1.0)] {
        for (y, sign_y) in [(y + 0.5 * size[1], 1.0), (y - 0.5 * size[1], -1.0)] {
            let (xx, yy) = (y * libm::asinh(x / y.abs()), x * libm::asinh(y / x.abs()));
            let corner = [xx + (1.0 - nu) * yy, -nu * libm::hypot(x, y), (1.0 - nu) * xx + yy];
            for (sum, value) in sums.iter_mut().zip(corner) {
                *sum += sign_x * sign_y * FRAC_1_PI * value;
            }
        }
    }
    sums
}
