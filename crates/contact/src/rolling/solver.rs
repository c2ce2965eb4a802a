//! Tractions of steady rolling on the grid, column by column from the leading edge.
//!
//! The derivative in C12 is the difference over one element towards the leading edge, as in Kalker's
//! algorithm. Columns across the rolling direction are solved one after the other from the leading edge
//! on, and the whole is repeated until nothing changes: a block Gauss-Seidel iteration in the order of
//! Vollebregt's SteadyGS (A Gauss-Seidel type solver for special convex optimization problems, with
//! application to frictional contact mechanics, 2010).
//!
//! For what a column changes in itself the displacement of the next one ahead counts as given, as in a
//! step of time. The column's own matrix then is A, which is symmetric and positive; with the difference
//! itself, whose diagonal is weaker than what comes from upstream, the iteration would run away. Found: 15
//! to 50 iterations, slightly more on finer grids.

use super::flash;
use super::grid::{Cells, Grid};
use super::influence::Influence;
use std::f64::consts::PI;

/// Change of the tractions by which an iteration ends, by their sum.
const TOLERANCE: f64 = 2e-5;

/// Most iterations; 15 to 60 are needed.
const ITERATIONS: usize = 1000;

/// Sweeps through a column before the next one is solved.
const SWEEPS: usize = 6;

/// Where the lateral slip by spin counts: ahead of the middle of an element, by its length.
///
/// The middle between this element and the next, where the derivative is taken, and the middle of the
/// element, where the bound is, differ by half an element: an error of first order either way, of
/// opposite sign. Kalker's and CONTACT's programs take places between 0 and 1/6.
pub(super) const SPIN_AHEAD: f64 = 1.0 / 24.0;

/// Values that are added up side by side; grids have whole multiples along.
pub(super) const LANES: usize = 8;

/// Creepages and spin with a b = 1, G = 1 and mu times the largest pressure 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RollingMotion {
    /// Longitudinal creepage.
    pub longitudinal: f64,
    /// Lateral creepage.
    pub lateral: f64,
    /// Spin.
    pub spin: f64,
}

/// Forces in the direction of the motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RollingForces {
    /// Longitudinal force by mu N.
    pub longitudinal: f64,
    /// Lateral force by mu N.
    pub lateral: f64,
    /// Moment of the tractions about the normal by mu N sqrt(a b).
    pub moment: f64,
    /// Highest flash temperature, by that of the same power spread as Hertz's pressure.
    pub flash: f64,
    /// Share of the power that is found as traction times slip; the rest is lost to the grid.
    pub resolved: f64,
    /// Iterations taken.
    pub iterations: usize,
}

/// An ellipse and its elements; tractions of the last motion are the start for the next one.
pub struct RollingContact {
    grid: Grid,
    influence: Influence,
    /// Semi-axes.
    axes: [f64; 2],
    /// Tractions along x and y, row by row.
    tractions: [Vec<f32>; 2],
    /// Slip along x and y of the elements of one column.
    slip: [Vec<f64>; 2],
}

impl RollingContact {
    /// An ellipse with the ratio a/b of its semi-axes; the elements along count as whole eights.
    pub fn new(a_over_b: f64, poisson_ratio: f64, cells: Cells) -> Self {
        let a = a_over_b.sqrt();
        let cells = Cells { along: cells.along.next_multiple_of(LANES), ..cells };
        let grid = Grid::new(a, 1.0 / a, cells);
        let influence = Influence::new(grid.size, cells, poisson_ratio);
        let elements = cells.along * cells.across;
        Self {
            influence,
            axes: [a, 1.0 / a],
            tractions: [vec![0.0; elements], vec![0.0; elements]],
            slip: [vec![0.0; cells.across], vec![0.0; cells.across]],
            grid,
        }
    }

    /// Forces in steady rolling.
    pub fn solve(&mut self, motion: &RollingMotion) -> RollingForces {
        let mut iterations = 0;
        loop {
            iterations += 1;
            let (mut change, mut sum) = (0.0, f64::MIN_POSITIVE);
            for column in (0..self.grid.cells.along).rev() {
                let (of_column, all) = self.solve_column(motion, column);
                change += of_column;
                sum += all;
            }
            if change <= TOLERANCE * sum || iterations == ITERATIONS {
                return self.forces(motion, iterations);
            }
        }
    }

    /// Solves one column with all others as they are; change and sum of its tractions.
    fn solve_column(&mut self, motion: &RollingMotion, column: usize) -> (f64, f64) {
        let along = self.grid.cells.along;
        let rows = self.rows_of(column);
        for row in rows.clone() {
            let [x, y] = self.slip_at(motion, column, row);
            self.slip[0][row] = x;
            self.slip[1][row] = y;
        }
        let stiffness = self.influence.in_column(0);
        let (mut change, mut sum) = (0.0, 0.0);
        for sweep in 0..SWEEPS {
            for step in 0..rows.len() {
                let row = if sweep % 2 == 0 { rows.start + step } else { rows.end - 1 - step };
                let at = row * along + column;
                let before = [0, 1].map(|i| f64::from(self.tractions[i][at]));
                let free = [0, 1].map(|i| self.slip[i][row] + stiffness[i] * before[i]);
                let after = traction(free, stiffness, self.grid.bound[at]);
                let moved = [after[0] - before[0], after[1] - before[1]];
                for other in rows.clone() {
                    let [xx, yy] = self.influence.in_column(other.abs_diff(row));
                    self.slip[0][other] -= xx * moved[0];
                    self.slip[1][other] -= yy * moved[1];
                }
                self.tractions[0][at] = after[0] as f32;
                self.tractions[1][at] = after[1] as f32;
                change += moved[0].abs() + moved[1].abs();
                if sweep == 0 {
                    sum += after[0].abs() + after[1].abs();
                }
            }
        }
        (change, sum)
    }

    /// Rows that have an element in this column.
    fn rows_of(&self, column: usize) -> std::ops::Range<usize> {
        let inside = |rows: &(usize, usize)| (rows.0..rows.1).contains(&column);
        let first = self.grid.rows.iter().position(inside).unwrap_or(0);
        first..self.grid.cells.across - first
    }

    /// Slip of an element with all tractions as they are (C12).
    fn slip_at(&self, motion: &RollingMotion, column: usize, row: usize) -> [f64; 2] {
        let (x, y) = self.grid.middle(column, row);
        let mut slip = [
            motion.longitudinal - motion.spin * y,
            motion.lateral + motion.spin * (x + SPIN_AHEAD * self.grid.size[0]),
        ];
        let mut sums = [[0.0_f32; LANES]; 4];
        for source in (row + 1..self.grid.cells.across).rev() {
            self.add_row(&mut sums, column, row, source);
        }
        // What is across changes sign where the source lies on the other side.
        for sum in &mut sums[1..3] {
            sum.iter_mut().for_each(|value| *value = -*value);
        }
        for source in (0..=row).rev() {
            self.add_row(&mut sums, column, row, source);
        }
        let [xx, x_by_y, y_by_x, yy] = sums.map(|lanes| f64::from(lanes.iter().sum::<f32>()));
        slip[0] += xx + x_by_y;
        slip[1] += yy + y_by_x;
        slip
    }

    /// Adds what the tractions of the row `source` do at an element: xx qx, xy qy, xy qx and yy qy.
    fn add_row(&self, sums: &mut [[f32; LANES]; 4], column: usize, row: usize, source: usize) {
        let along = self.grid.cells.along;
        let [xx, xy, yy] = self.influence.by_row(column, source.abs_diff(row));
        let range = source * along..(source + 1) * along;
        let [qx, qy] = [&self.tractions[0][range.clone()], &self.tractions[1][range]];
        let (xx, xy, yy, qy) = (&xx[..along], &xy[..along], &yy[..along], &qy[..along]);
        for begin in (0..along).step_by(LANES) {
            let part = |values: &[f32]| -> [f32; LANES] {
                *values[begin..].first_chunk().expect("rows are whole chunks")
            };
            let (xx, xy, yy, qx, qy) = (part(xx), part(xy), part(yy), part(qx), part(qy));
            for lane in 0..LANES {
                sums[0][lane] += xx[lane] * qx[lane];
                sums[1][lane] += xy[lane] * qy[lane];
                sums[2][lane] += xy[lane] * qx[lane];
                sums[3][lane] += yy[lane] * qy[lane];
            }
        }
    }

    /// Sums over all elements.
    fn forces(&self, motion: &RollingMotion, iterations: usize) -> RollingForces {
        let along = self.grid.cells.along;
        let [mut longitudinal, mut lateral, mut moment] = [0.0; 3];
        let mut flux = vec![0.0; self.grid.bound.len()];
        for (row, &(first, end)) in self.grid.rows.iter().enumerate() {
            for column in first..end {
                let at = row * along + column;
                let (x, y) = self.grid.middle(column, row);
                let [qx, qy] = [0, 1].map(|i| f64::from(self.tractions[i][at]));
                longitudinal += qx;
                lateral += qy;
                moment += x * qy - y * qx;
                if libm::hypot(qx, qy) > (1.0 - 1e-6) * self.grid.bound[at] {
                    let slip = self.slip_at(motion, column, row);
                    flux[at] = (qx * slip[0] + qy * slip[1]).max(0.0);
                }
            }
        }
        let share = self.grid.size[0] * self.grid.size[1] / (2.0 / 3.0 * PI);
        let power = longitudinal * motion.longitudinal + lateral * motion.lateral;
        let power = power + moment * motion.spin;
        // Both on the same grid, so that its error falls out.
        let peak = |flux: &[f64]| flash::peak(&self.grid, self.axes[0], flux);
        RollingForces {
            longitudinal: share * longitudinal,
            lateral: share * lateral,
            moment: share * moment,
            flash: peak(&flux) / peak(&self.grid.bound),
            resolved: flux.iter().sum::<f64>() / power,
            iterations,
        }
    }
}

/// The traction of one element where slip is `free` less stiffness times traction (C13).
fn traction(free: [f64; 2], stiffness: [f64; 2], bound: f64) -> [f64; 2] {
    let at = |resistance: f64| [0, 1].map(|i| free[i] / (stiffness[i] + resistance));
    let stuck = at(0.0);
    let size = libm::hypot(stuck[0], stuck[1]);
    if size <= bound {
        return stuck;
    }
    // Slip is `resistance` times traction; the bound tells how much, by Newton's method on 1/|q|.
    let mut resistance = 0.0;
    let (mut q, mut size) = (stuck, size);
    for _ in 0..8 {
        let slope =
            q[0] * q[0] / (stiffness[0] + resistance) + q[1] * q[1] / (stiffness[1] + resistance);
        resistance += size * size / slope * (size / bound - 1.0);
        q = at(resistance);
        size = libm::hypot(q[0], q[1]);
        if (size - bound).abs() <= 1e-12 * bound {
            break;
        }
    }
    [q[0] * bound / size, q[1] * bound / size]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kalker::CreepCoefficients;

    const NU: f64 = 0.28;

    fn solved(a_over_b: f64, cells: (usize, usize), motion: RollingMotion) -> RollingForces {
        let cells = Cells { along: cells.0, across: cells.1 };
        RollingContact::new(a_over_b, NU, cells).solve(&motion)
    }

    fn longitudinal(creepage: f64) -> RollingMotion {
        RollingMotion { longitudinal: creepage, ..RollingMotion::default() }
    }

    /// A contact that is far wider than long is Carter's plane one on each of its strips, with the largest
    /// pressure p of the strip: F = mu N (1 - (1 - xi/xi_s)²), xi_s = 2 (1 - nu) mu p/G (Carter 1926).
    ///
    /// Tolerance 3 %: ellipse of 1:50, 32 elements along.
    #[test]
    fn analytic_rolling_of_a_wide_contact_is_carters() {
        for share in [0.2, 0.5, 0.8, 1.2] {
            let found = solved(0.02, (32, 40), longitudinal(2.0 * (1.0 - NU) * share));
            let strips = (0..1000).map(|strip| {
                let y = (f64::from(strip) + 0.5) / 1000.0;
                let pressure = (1.0 - y * y).sqrt();
                1.5e-3 * pressure * pressure * (1.0 - (1.0 - share / pressure).max(0.0).powi(2))
            });
            let expected: f64 = strips.sum();
            let error = found.longitudinal / expected - 1.0;
            assert!(error.abs() < 0.03, "{share}: {} for {expected}", found.longitudinal);
        }
    }

    /// Without slip the forces are Kalker's linear ones (1990, table E.3), and lateral force by spin and
    /// moment by lateral creepage are one coefficient. Tolerance 3 %, 5 % for C23: 24 elements along.
    #[test]
    fn benchmark_rolling_without_slip_is_kalkers() {
        let creepage = 1e-4;
        let unit = 2.0 / 3.0 * PI / creepage;
        for (a_over_b, cells) in [(0.5, (16, 24)), (1.0, (24, 24)), (2.0, (32, 24))] {
            let kalker = CreepCoefficients::new(a_over_b, NU);
            let along = solved(a_over_b, cells, longitudinal(creepage)).longitudinal;
            let lateral = RollingMotion { lateral: creepage, ..RollingMotion::default() };
            let lateral = solved(a_over_b, cells, lateral);
            let spin = RollingMotion { spin: creepage, ..RollingMotion::default() };
            let spin = solved(a_over_b, cells, spin);
            for (name, found, expected, within) in [
                ("C11", along, kalker.c11, 0.03),
                ("C22", lateral.lateral, kalker.c22, 0.03),
                ("C23 by spin", spin.lateral, kalker.c23, 0.05),
                ("-C23 of the moment", -lateral.moment, kalker.c23, 0.05),
            ] {
                let found = unit * found;
                assert!((found / expected - 1.0).abs() < within, "{name}: {found} for {expected}");
            }
        }
    }

    /// Twice as many elements change the force by less than 2 %: from 16 to 32 along and across.
    #[test]
    fn property_rolling_hardly_depends_on_the_grid() {
        let motion = RollingMotion { longitudinal: 0.0, lateral: 0.48, spin: 0.0 };
        let [coarse, fine] = [16, 32].map(|cells| solved(1.0, (cells, cells), motion).lateral);
        assert!((coarse / fine - 1.0).abs() < 0.02, "{coarse}, {fine}");
    }
}
