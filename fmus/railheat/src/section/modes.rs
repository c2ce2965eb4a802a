//! The modes in which the section conducts heat along itself and gives it to the air.
//!
//! The temperatures u of the cells above their surroundings obey (theory eq. 9)
//!
//! ```text
//! C u' = -(K + H) u + s
//! ```
//!
//! with capacities C, conductances K between the cells, conductances H to the surroundings and
//! heat s per time, all per metre of rail. The eigenvectors φ of (K + H) φ = λ C φ, scaled to
//! φᵀ C φ = 1, take it apart into single decays
//!
//! ```text
//! a' = -λ a + φᵀ s,    u = Σ a φ
//! ```
//!
//! which are solved exactly for any step as long as s is constant. Modes that decay within
//! `shortest` are left out, if wanted: their heat, next to nothing, counts as given to the air at
//! once, but the temperatures ripple all over the section for some ten times as long after heat
//! comes in, because what cancelled at the foot is missing.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

use super::cells::Cells;
use crate::material::Material;

/// Sums are formed in so many parts at a time, and mode arrays padded to a multiple of it.
pub const LANES: usize = 8;

/// No modes can be found.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "the section has {cells} cells: from 2 to {most} are possible; choose another \
     section.cell_size ({size} m)"
)]
pub struct NoModes {
    /// Number of cells.
    pub cells: usize,
    /// Most cells.
    pub most: usize,
    /// Size of the cells, m.
    pub size: f64,
}

/// Most cells of a section: its modes take some ten seconds.
const MOST_CELLS: usize = 1500;

/// The slowest modes of a section.
#[derive(Clone, Debug, PartialEq)]
pub struct Modes {
    /// λ of each mode, slowest first, 1/s; padded with zeros.
    pub rates: Vec<f64>,
    /// Number of modes without the padding.
    pub count: usize,
    /// Heat in the rail by an amplitude of one, 1ᵀ C φ, J/m.
    pub content: Vec<f64>,
    /// Heat per time to the surroundings by an amplitude of one, summed over the surface, W/m.
    pub loss: Vec<f64>,
    /// φ, cell after cell.
    shapes: Vec<f64>,
}

impl Modes {
    /// The modes of cells of a material, with the conductance to the surroundings of each facet in
    /// W/(m²·K). Those with a time constant below `shortest` in s are left out.
    ///
    /// # Errors
    /// When there are fewer than two cells, or too many.
    pub fn new(
        cells: &Cells,
        material: &Material,
        surface: &[f64],
        shortest: f64,
        size: f64,
    ) -> Result<Self, NoModes> {
        let n = cells.cells.len();
        if !(2..=MOST_CELLS).contains(&n) {
            return Err(NoModes { cells: n, most: MOST_CELLS, size });
        }
        let root = DVector::from_iterator(
            n,
            cells.cells.iter().map(|cell| (material.heat_capacity() * cell.area).sqrt()),
        );
        let mut matrix = DMatrix::<f64>::zeros(n, n);
        for link in &cells.links {
            let [a, b] = link.cells;
            let conductance = material.conductivity * link.ratio;
            matrix[(a, a)] += conductance / (root[a] * root[a]);
            matrix[(b, b)] += conductance / (root[b] * root[b]);
            matrix[(a, b)] -= conductance / (root[a] * root[b]);
            matrix[(b, a)] -= conductance / (root[a] * root[b]);
        }
        let mut to_air = DVector::<f64>::zeros(n);
        for (facet, conductance) in cells.facets.iter().zip(surface) {
            to_air[facet.cell] += conductance * facet.length;
        }
        for cell in 0..n {
            matrix[(cell, cell)] += to_air[cell] / (root[cell] * root[cell]);
        }
        let eigen = SymmetricEigen::new(matrix);
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
        order.retain(|mode| eigen.eigenvalues[*mode] * shortest < 1.0);
        let count = order.len();
        let width = count.next_multiple_of(LANES);
        let mut modes = Self {
            rates: vec![0.0; width],
            count,
            content: vec![0.0; width],
            loss: vec![0.0; width],
            shapes: vec![0.0; width * n],
        };
        for (k, mode) in order.into_iter().enumerate() {
            // Rounding may leave the rate of the uniform mode of an insulated section negative.
            modes.rates[k] = eigen.eigenvalues[mode].max(0.0);
            for cell in 0..n {
                let shape = eigen.eigenvectors[(cell, mode)] / root[cell];
                modes.shapes[cell * width + k] = shape;
                modes.content[k] += root[cell] * root[cell] * shape;
                modes.loss[k] += to_air[cell] * shape;
            }
        }
        Ok(modes)
    }

    /// Number of amplitudes of an element, with the padding.
    pub fn width(&self) -> usize {
        self.rates.len()
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.shapes.len() / self.width()
    }

    /// The shapes at one cell: temperature by an amplitude of one, K, and amplitude by heat of
    /// 1 J/m in the cell.
    pub fn at(&self, cell: usize) -> &[f64] {
        &self.shapes[cell * self.width()..][..self.width()]
    }

    /// The sum of the shapes at cells with their weights.
    pub fn weighted(&self, weights: impl IntoIterator<Item = (usize, f64)>) -> Vec<f64> {
        let mut sum = vec![0.0; self.width()];
        for (cell, weight) in weights {
            add(&mut sum, weight, self.at(cell));
        }
        sum
    }
}

/// `sum += factor · values`
#[inline]
pub fn add(sum: &mut [f64], factor: f64, values: &[f64]) {
    for (sum, value) in sum.iter_mut().zip(values) {
        *sum += factor * value;
    }
}

/// The product of two rows of amplitudes, summed in a fixed order in `LANES` parts, which the
/// compiler makes vector instructions of.
#[inline]
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    let (a, _) = a.as_chunks::<LANES>();
    let (b, _) = b.as_chunks::<LANES>();
    for (a, b) in a.iter().zip(b) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    sums.iter().sum()
}
