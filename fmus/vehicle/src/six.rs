//! Small dense algebra of a wheelset's six velocities (vx, vy, vz, wx, wy, wz).

use nalgebra::Vector3;

/// Six velocities, or a row that multiplies them.
pub type Six = [f64; 6];

/// A symmetric matrix; only the lower triangle counts.
pub type SixBySix = [[f64; 6]; 6];

/// Scalar product.
#[inline]
pub fn dot(a: &Six, b: &Six) -> f64 {
    let mut sum = 0.0;
    for i in 0..6 {
        sum += a[i] * b[i];
    }
    sum
}

/// Adds `factor` times `row`.
#[inline]
pub fn add(vector: &mut Six, factor: f64, row: &Six) {
    for i in 0..6 {
        vector[i] += factor * row[i];
    }
}

/// Adds `factor` row rowᵀ to the lower triangle.
#[inline]
pub fn add_outer(matrix: &mut SixBySix, factor: f64, row: &Six) {
    for i in 0..6 {
        let scaled = factor * row[i];
        for j in 0..=i {
            matrix[i][j] += scaled * row[j];
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
    for j in 0..6 {
        // Below the diagonal, column j keeps L D.
        let column: Six = std::array::from_fn(|i| matrix[i][j]);
        let inverse = 1.0 / column[j];
        for i in j + 1..6 {
            let factor = column[i] * inverse;
            for (value, other) in matrix[i][..=i].iter_mut().zip(column).skip(j + 1) {
                *value -= factor * other;
            }
            right[i] -= factor * right[j];
        }
    }
    for i in (0..6).rev() {
        let below = i + 1..6;
        let known: f64 = below.map(|k| matrix[k][i] * right[k]).sum();
        right[i] = (right[i] - known) / matrix[i][i];
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
            add_outer(&mut matrix, 30.0, row);
        }
        let x = [1.0, -2.0, 3.0, 0.5, -0.25, 4.0];
        let mut b: Six =
            std::array::from_fn(|i| (0..6).map(|j| matrix[i.max(j)][i.min(j)] * x[j]).sum());
        solve(&mut matrix, &mut b);
        for i in 0..6 {
            assert!((b[i] - x[i]).abs() < 1e-12);
        }
    }
}
