//! Whether a linear system is stable, without its eigenvalues.
//!
//! Cayley's transform μ = (1 + h λ/2)/(1 - h λ/2) takes eigenvalues λ of the first-order matrix A with
//! a negative real part into the unit circle. The growth of the powers of P = (1 - h A/2)⁻¹ (1 + h A/2),
//! by repeated squaring, is that of the least stable mode; the QR algorithm of the library does not
//! converge on these matrices, which have several eigenvalues near zero.

use nalgebra::{Complex, DMatrix, DVector};

use super::system::System;

/// h, s: the transform is most distinct for modes of 2/h = 100 rad/s and less.
const STEP: f64 = 0.02;

/// Number of squarings: 4096 steps of 20 ms are 82 s.
const SQUARINGS: usize = 12;

/// The least stable mode of a system.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeastStable {
    /// Rate of its growth, 1/s; negative: it dies away.
    pub growth: f64,
    /// Its circular frequency, rad/s.
    pub frequency: f64,
}

impl System {
    /// The mode that grows fastest or dies away most slowly.
    pub(super) fn least_stable(&self) -> Option<LeastStable> {
        let matrix = 0.5 * STEP * self.first_order();
        let one = DMatrix::identity(matrix.nrows(), matrix.nrows());
        let once = (&one - &matrix).lu().solve(&(&one + &matrix))?;
        let mut power = once.clone();
        // Logarithms of the norms of the last power and the one before.
        let (mut last, mut before) = (0.0, 0.0);
        for _ in 0..SQUARINGS {
            power = &power * &power;
            let norm = power.norm();
            power /= norm;
            before = last;
            last = 2.0 * last + libm::log(norm);
        }
        let time = STEP * f64::from(1 << (SQUARINGS - 1));
        let start = DVector::from_fn(once.nrows(), |i, _| 1.0 + (i % 7) as f64);
        let frequency = frequency(&once, &(&power * start));
        Some(LeastStable { growth: (last - before) / time, frequency })
    }
}

/// Circular frequency of a vector that holds one mode alone: v2 = a v1 + b v0 gives μ² = a μ + b.
fn frequency(once: &DMatrix<f64>, v0: &DVector<f64>) -> f64 {
    let v1 = once * v0;
    let v2 = once * &v1;
    let (p, q, r) = (v1.dot(&v1), v1.dot(v0), v0.dot(v0));
    let (s, t) = (v1.dot(&v2), v0.dot(&v2));
    let determinant = p * r - q * q;
    let (a, b) = ((s * r - t * q) / determinant, (t * p - s * q) / determinant);
    let root = Complex::new(0.25 * a * a + b, 0.0).sqrt();
    let mu = Complex::new(0.5 * a, 0.0) + root;
    ((mu - 1.0) / (mu + 1.0) * (2.0 / STEP)).im.abs()
}
