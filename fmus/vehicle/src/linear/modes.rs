//! Modes of the linear system: eigenvalues of its first-order form, and a shape for each.
//!
//! With coordinates of unit inertia p = M^1/2 q, the state (dp/dt, f, p) follows
//! -K p - C dp/dt - Σ b f, k (bᵀ dp/dt - f/c), and dp/dt. Coordinates that no spring acts on, such
//! as the rotation of a rolling wheelset, are no part of p: they would only add eigenvalues of zero.

use nalgebra::{Complex, DMatrix, DVector};

use super::system::System;

/// Sweeps of inverse iteration for a shape: each gains the ratio of the shift's error to the
/// distance of the next eigenvalue, so that two are ample.
const SWEEPS: usize = 3;

/// Share of an eigenvalue by which the shift of the inverse iteration misses it.
const MISS: f64 = 1e-9;

/// Circular frequency by which displacements are scaled, rad/s.
const UNIT: f64 = 50.0;

/// Frequency, rad/s, below which a mode is that of a body that nothing holds.
const FREE: f64 = 1e-3;

/// One mode.
#[derive(Clone, Debug)]
pub struct Mode {
    /// Eigenvalue, 1/s; the imaginary part is not negative.
    pub eigenvalue: Complex<f64>,
    /// Displacement and rotation of each body in turn, m and rad.
    ///
    /// For one joule of kinetic energy at its greatest; the largest component has no phase.
    pub shape: DVector<Complex<f64>>,
    /// Share of each coordinate in the kinetic energy.
    pub energy: DVector<f64>,
}

/// All modes of a system.
#[derive(Clone, Debug)]
pub struct Modes {
    /// Those that oscillate, rising in frequency.
    pub oscillating: Vec<Mode>,
    /// Eigenvalues, 1/s, of what creeps back, or away, without oscillating.
    pub monotonic: Vec<f64>,
}

impl Mode {
    /// Frequency of the damped oscillation, Hz.
    pub fn frequency(&self) -> f64 {
        self.eigenvalue.im / std::f64::consts::TAU
    }

    /// Share of the critical damping; negative: the mode grows.
    pub fn damping_ratio(&self) -> f64 {
        -self.eigenvalue.re / self.eigenvalue.norm()
    }
}

impl System {
    /// Modes of the system.
    pub fn modes(&self) -> Modes {
        let matrix = self.first_order();
        let eigenvalues = matrix.complex_eigenvalues();
        let mut oscillating: Vec<Mode> = eigenvalues
            .iter()
            .filter(|value| value.im > FREE)
            .map(|&value| self.mode(&matrix, value))
            .collect();
        oscillating.sort_by(|a, b| a.eigenvalue.im.total_cmp(&b.eigenvalue.im));
        let monotonic = eigenvalues.iter().filter(|value| value.im.abs() <= FREE);
        Modes { oscillating, monotonic: monotonic.map(|value| value.re).collect() }
    }

    /// Matrix of the first-order form in coordinates of unit inertia.
    pub(super) fn first_order(&self) -> DMatrix<f64> {
        let (size, extra) = (self.inertia.len(), self.series.len());
        let (stiffness, damping) = (self.scaled(&self.stiffness), self.scaled(&self.damping));
        let held: Vec<usize> = (0..size).filter(|&j| stiffness.column(j).amax() > 0.0).collect();
        let first = size + extra;
        let mut matrix = DMatrix::zeros(first + held.len(), first + held.len());
        matrix.view_mut((0, 0), (size, size)).copy_from(&-damping);
        for (i, &j) in held.iter().enumerate() {
            // Displacements are scaled so that both couplings are alike.
            matrix.view_mut((0, first + i), (size, 1)).copy_from(&(-stiffness.column(j) / UNIT));
            matrix[(first + i, j)] = UNIT;
        }
        for (i, series) in self.series.iter().enumerate() {
            let at = size + i;
            let unit = series.stiffness.sqrt();
            for (j, value) in series.row.iter().enumerate() {
                let coupling = unit * value / self.inertia[j].sqrt();
                matrix[(j, at)] = -coupling;
                matrix[(at, j)] = coupling;
            }
            matrix[(at, at)] = -series.stiffness / series.damping;
        }
        matrix
    }

    /// The mode of an eigenvalue, its shape by inverse iteration.
    fn mode(&self, matrix: &DMatrix<f64>, eigenvalue: Complex<f64>) -> Mode {
        let mut shifted = matrix.map(|value| Complex::new(value, 0.0));
        for i in 0..matrix.nrows() {
            shifted[(i, i)] -= eigenvalue * (1.0 + MISS);
        }
        let factors = shifted.lu();
        let mut vector =
            DVector::from_fn(matrix.nrows(), |i, _| Complex::new(1.0, 0.1 * (i % 7) as f64));
        for _ in 0..SWEEPS {
            if let Some(next) = factors.solve(&vector) {
                vector = next.unscale(next.norm());
            }
        }
        let motion = vector.rows(0, self.inertia.len());
        let energy = motion.map(|value| value.norm_sqr()) / motion.norm_squared();
        let displacement = motion.map(|speed| speed / eigenvalue);
        let largest = displacement[displacement.icamax()];
        let turn = largest.conj() / largest.norm() * (2.0_f64.sqrt() / motion.norm());
        let inertia = &self.inertia;
        let shape = displacement.map_with_location(|i, _, value| value * turn / inertia[i].sqrt());
        Mode { eigenvalue, shape, energy }
    }
}
