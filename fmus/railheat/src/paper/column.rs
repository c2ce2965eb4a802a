//! Heat conduction over the depth: one-dimensional explicit finite differences.
//!
//! Equation 1 of the paper (`docs/theory/railheat/paper.md#eq-1`), with the diffusivity α where the
//! paper prints k:
//!
//! ```text
//! u_j' = u_j + s (u_{j+1} - 2 u_j + u_{j-1}),    s = α Δt / Δx²
//! ```
//!
//! Written with the heat that flows from cell to cell, no heat is lost to rounding. Nothing flows
//! through the top (the weather acts before) and the foot. Stable for s ≤ 1/2. The error is of
//! order Δt and Δx²; validated by `analytic_slab_…` against closed forms.
//!
//! Columns are worked on in blocks of [`LANES`], with the cells of one depth side by side, so that
//! the compiler makes vector instructions of it.

use crate::contact::Material;

/// Number of columns of a block: one block of 34 cells fits into the first-level cache.
pub const LANES: usize = 64;

/// Why the conduction cannot be computed with a grid and a step.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "conduction.interval = {interval} s is too long for cells of {cell_size} m: the explicit scheme \
     needs s = diffusivity * interval / cell size² <= 0.5, but s = {number:.4}; with this cell size the \
     interval must be at most {longest:.6} s"
)]
pub struct Unstable {
    /// Step of the conduction, s.
    pub interval: f64,
    /// Cell size, m.
    pub cell_size: f64,
    /// The number s.
    pub number: f64,
    /// Longest stable interval, s.
    pub longest: f64,
}

/// The number s = α Δt / Δx² of the conduction.
///
/// # Errors
/// When it is over the limit of stability, 1/2.
pub fn fourier_number(material: &Material, interval: f64, cell_size: f64) -> Result<f64, Unstable> {
    let number = material.diffusivity() * interval / (cell_size * cell_size);
    if number <= 0.5 {
        return Ok(number);
    }
    Err(Unstable {
        interval,
        cell_size,
        number,
        longest: 0.5 * cell_size * cell_size / material.diffusivity(),
    })
}

/// Takes a block of columns over one step and gives the sum over the depth of each.
///
/// `cells` has the depths one after the other, each with [`LANES`] columns.
pub fn conduct(cells: &mut [f64], number: f64) -> [f64; LANES] {
    let (mut rows, _) = cells.as_chunks_mut::<LANES>();
    let mut inflow = [0.0; LANES];
    let mut sum = [0.0; LANES];
    while let [here, below @ ..] = std::mem::take(&mut rows) {
        if let Some(below) = below.first() {
            for lane in 0..LANES {
                let outflow = number * (here[lane] - below[lane]);
                here[lane] += inflow[lane] - outflow;
                inflow[lane] = outflow;
                sum[lane] += here[lane];
            }
        } else {
            for lane in 0..LANES {
                here[lane] += inflow[lane];
                sum[lane] += here[lane];
            }
        }
        rows = below;
    }
    sum
}
