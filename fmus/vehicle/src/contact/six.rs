//! Small dense algebra of a wheelset's six velocities (vx, vy, vz, wx, wy, wz).

use nalgebra::Vector3;

/// Six velocities, or forces and moments.
pub type Six = [f64; 6];

/// A symmetric matrix; only the lower triangle counts.
pub type SixBySix = [[f64; 6]; 6];

/// A row of which only the entries at `at` are not zero, times a vector.
#[inline]
pub fn dot<const N: usize>(at: [usize; N], row: &[f64; N], vector: &Six) -> f64 {
    (0..N).map(|k| row[k] * vector[at[k]]).sum()
}

/// Adds `factor` times such a row.
#[inline]
pub fn add<const N: usize>(at: [usize; N], row: &[f64; N], factor: f64, vector: &mut Six) {
    for k in 0..N {
        vector[at[k]] += factor * row[k];
    }
}

/// Adds `factor` row rowᵀ to the lower triangle; `at` rises.
///
/// It is compiled for each row, whose indices are known there; a call makes a vehicle's step 2 % longer.
#[inline(always)]
pub fn add_outer<const N: usize>(
    at: [usize; N],
    row: &[f64; N],
    factor: f64,
    matrix: &mut SixBySix,
) {
    for k in 0..N {
        let scaled = factor * row[k];
        for l in 0..=k {
            matrix[at[k]][at[l]] += scaled * row[l];
        }
    }
}

/// Both vectors one after the other.
#[inline]
pub fn join(linear: &Vector3<f64>, angular: &Vector3<f64>) -> Six {
    [linear.x, linear.y, linear.z, angular.x, angular.y, angular.z]
}

/// The two vectors of which `six` consists.
#[inline]
pub fn split(six: &Six) -> (Vector3<f64>, Vector3<f64>) {
    (Vector3::new(six[0], six[1], six[2]), Vector3::new(six[3], six[4], six[5]))
}

/// Solves for a positive definite matrix, in place: L D Lᵀ without square roots.
#[inline]
pub fn solve(matrix: &mut SixBySix, right: &mut Six) {
    let mut inverse = [0.0; 6];
    for j in 0..6 {
        // Below the diagonal, column j keeps L D.
        inverse[j] = 1.0 / matrix[j][j];
        for k in j + 1..6 {
            let factor = matrix[k][j] * inverse[j];
            right[k] -= factor * right[j];
            for row in &mut matrix[k..] {
                row[k] -= factor * row[j];
            }
        }
    }
    for i in (0..6).rev() {
        for k in i + 1..6 {
            right[i] -= matrix[k][i] * right[k];
        }
        right[i] *= inverse[i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A x = b for a matrix of outer products and a known x.
    #[test]
    fn analytic_solution_of_a_definite_system() {
        let rows: [Six; 3] = [
            [1.0, 0.2, 0.0, 0.0, 0.5, -0.75],
            [-0.01, 0.9, -0.1, -0.5, 0.0, 0.0],
            [0.0, 0.1, 0.9, 0.7, 0.0, 0.0],
        ];
        let mut matrix = [[0.0; 6]; 6];
        for (i, row) in matrix.iter_mut().enumerate() {
            row[i] = 1.0 + i as f64;
        }
        for row in &rows {
            add_outer([0, 1, 2, 3, 4, 5], row, 30.0, &mut matrix);
        }
        add_outer([1, 4], &[0.5, 2.0], 10.0, &mut matrix);
        let x = [1.0, -2.0, 3.0, 0.5, -0.25, 4.0];
        let mut b: Six =
            std::array::from_fn(|i| (0..6).map(|j| matrix[i.max(j)][i.min(j)] * x[j]).sum());
        solve(&mut matrix, &mut b);
        for i in 0..6 {
            assert!((b[i] - x[i]).abs() < 1e-12);
        }
    }
}
