//! The modes in which the section conducts heat along itself and gives it to the air.
//!
//! The temperatures u of the cells above their surroundings obey
//! (`docs/theory/railheat/energy.md#eq-9`)
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
//! which are solved exactly for any step as long as s is constant.
//!
//! A rail's section is symmetric. So each mode is equal (even) or opposite (odd) on both sides of its middle, and
//! the two kinds are found by themselves, in half as many unknowns. Odd modes hold no heat, lose none and are zero on the
//! middle line: whoever reads nothing but these needs the even ones only, which come first.

use std::f64::consts::FRAC_1_SQRT_2;

use nalgebra::{DMatrix, DVectorView, SymmetricEigen};

use super::cells::Cells;
use crate::contact::Material;

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
const MOST_CELLS: usize = 2400;

/// A mode holds most of the heat of a uniform section if it holds more than this share.
const MOST_OF_THE_HEAT: f64 = 0.5;

/// The modes of a section.
#[derive(Clone, Debug, PartialEq)]
pub struct Modes {
    /// λ of each mode, 1/s: the even ones slowest first, the odd ones slowest first, zeros as padding.
    pub rates: Vec<f64>,
    /// Number of modes without the padding.
    pub count: usize,
    /// Number of even modes.
    pub even: usize,
    /// Heat in the rail by an amplitude of one, 1ᵀ C φ, J/m.
    pub content: Vec<f64>,
    /// Heat per time to the surroundings by an amplitude of one, summed over the surface, W/m.
    pub loss: Vec<f64>,
    /// φ, cell after cell.
    shapes: Vec<f64>,
}

impl Modes {
    /// The modes of cells of a material.
    ///
    /// `surface` is the conductance of each facet to the surroundings in W/(m²·K), `size` that of
    /// the cells in m.
    ///
    /// # Errors
    /// When there are fewer than two cells, or too many.
    pub fn new(
        cells: &Cells,
        material: &Material,
        surface: &[f64],
        size: f64,
    ) -> Result<Self, NoModes> {
        let n = cells.cells.len();
        if !(2..=MOST_CELLS).contains(&n) {
            return Err(NoModes { cells: n, most: MOST_CELLS, size });
        }
        let section = Conductances::new(cells, material, surface);
        let mut found = section.modes(EVEN);
        let even = found.len();
        found.extend(section.modes(ODD));
        let count = found.len();
        let width = count.next_multiple_of(LANES);
        let mut modes = Self {
            rates: vec![0.0; width],
            count,
            even,
            content: vec![0.0; width],
            loss: vec![0.0; width],
            shapes: vec![0.0; width * n],
        };
        for (k, mode) in found.into_iter().enumerate() {
            modes.rates[k] = mode.rate;
            for (cell, shape) in mode.shape.into_iter().enumerate() {
                modes.shapes[cell * width + k] = shape;
                modes.content[k] += section.root[cell] * section.root[cell] * shape;
                modes.loss[k] += section.to_air[cell] * shape;
            }
            // Eigenvalues are rounded to the fastest of them. The rate of the mode that holds most of the heat is what it
            // loses over what it holds, so that the audit closes.
            if modes.content[k].powi(2) > MOST_OF_THE_HEAT * section.capacity() {
                modes.rates[k] = modes.loss[k] / modes.content[k];
            }
        }
        Ok(modes)
    }

    /// Number of amplitudes of a section of which all is read, with the padding.
    pub fn width(&self) -> usize {
        self.rates.len()
    }

    /// Number of amplitudes of a section of which only the middle line and sums are read.
    ///
    /// These are the even modes, with some odd ones as padding.
    pub fn even_width(&self) -> usize {
        self.even.next_multiple_of(LANES)
    }

    /// Number of amplitudes that hold all even modes slower than `fastest` in 1/s.
    ///
    /// The next ones are the padding.
    pub fn width_below(&self, fastest: f64) -> usize {
        let slower = self.rates[..self.even].partition_point(|rate| *rate < fastest);
        slower.max(1).next_multiple_of(LANES)
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.shapes.len() / self.width()
    }

    /// The shapes of all modes at one cell.
    ///
    /// They are the temperature by an amplitude of one, K, and the amplitude by heat of 1 J/m in
    /// the cell.
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

/// What is equal on both sides of the middle.
const EVEN: f64 = 1.0;

/// What is opposite on both sides of the middle.
const ODD: f64 = -1.0;

/// One mode before its number among the others is known.
struct Mode {
    /// λ, 1/s.
    rate: f64,
    /// φ of each cell.
    shape: Vec<f64>,
}

/// The matrices of `docs/theory/railheat/energy.md#eq-9`.
struct Conductances<'c> {
    cells: &'c Cells,
    /// Root of the capacity of each cell.
    root: Vec<f64>,
    /// Conductance of each link, W/(m·K).
    links: Vec<f64>,
    /// Conductance of each cell to the surroundings, W/(m·K).
    to_air: Vec<f64>,
}

impl<'c> Conductances<'c> {
    fn new(cells: &'c Cells, material: &Material, surface: &[f64]) -> Self {
        let capacity = |area: f64| material.heat_capacity() * area;
        let mut to_air = vec![0.0; cells.cells.len()];
        for (facet, conductance) in cells.facets.iter().zip(surface) {
            to_air[facet.cell] += conductance * facet.length;
        }
        Self {
            root: cells.cells.iter().map(|cell| capacity(cell.area).sqrt()).collect(),
            links: cells.links.iter().map(|link| material.conductivity * link.ratio).collect(),
            to_air,
            cells,
        }
    }

    /// Heat capacity of the section, J/(m·K).
    fn capacity(&self) -> f64 {
        self.root.iter().map(|root| root * root).sum()
    }

    /// The even or odd modes, slowest first.
    fn modes(&self, parity: f64) -> Vec<Mode> {
        let (unknowns, count) = self.unknowns(parity);
        if count == 0 {
            return vec![];
        }
        let mut matrix = DMatrix::<f64>::zeros(count, count);
        for (link, conductance) in self.cells.links.iter().zip(&self.links) {
            let [(p, a), (q, b)] = link.cells.map(|cell| unknowns[cell]);
            matrix[(p, p)] += conductance * a * a;
            matrix[(q, q)] += conductance * b * b;
            matrix[(p, q)] -= conductance * a * b;
            matrix[(q, p)] -= conductance * a * b;
        }
        for ((p, a), conductance) in unknowns.iter().zip(&self.to_air) {
            matrix[(*p, *p)] += conductance * a * a;
        }
        let eigen = SymmetricEigen::new(matrix);
        let mode = |(rate, vector): (&f64, DVectorView<'_, f64>)| Mode {
            // Rounding may leave the rate of the uniform mode of an insulated section negative.
            rate: rate.max(0.0),
            shape: unknowns.iter().map(|(p, a)| vector[*p] * a).collect(),
        };
        let mut modes: Vec<Mode> =
            eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()).map(mode).collect();
        modes.sort_by(|a, b| a.rate.total_cmp(&b.rate));
        modes
    }

    /// For each cell its unknown and the cell's temperature by it; and the number of unknowns. A pair of
    /// cells has one; odd temperatures are zero on the middle.
    fn unknowns(&self, parity: f64) -> (Vec<(usize, f64)>, usize) {
        let mut unknowns = vec![(0, 0.0); self.root.len()];
        let mut count = 0;
        for (cell, &opposite) in self.cells.mirror.iter().enumerate() {
            let per_root = 1.0 / self.root[cell];
            if cell < opposite {
                unknowns[cell] = (count, FRAC_1_SQRT_2 * per_root);
                unknowns[opposite] = (count, parity * FRAC_1_SQRT_2 * per_root);
            } else if cell == opposite && parity == EVEN {
                unknowns[cell] = (count, per_root);
            } else {
                continue;
            }
            count += 1;
        }
        (unknowns, count)
    }
}

/// `sum += factor · values`
#[inline]
pub fn add(sum: &mut [f64], factor: f64, values: &[f64]) {
    for (sum, value) in sum.iter_mut().zip(values) {
        *sum += factor * value;
    }
}

/// The product of two rows of amplitudes, summed in a fixed order.
///
/// The sum has `LANES` parts, which the compiler makes vector instructions of.
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
