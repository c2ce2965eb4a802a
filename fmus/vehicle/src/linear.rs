//! The vehicle linearised at rest on straight track, for modes and static loads.
//!
//! Coordinates are displacement and rotation of each body in turn (six each). Elements count with
//! their elastic stiffness alone: without damping, weight and static load, and stops within their
//! play do nothing.

use nalgebra::{DMatrix, Matrix3x6, SymmetricEigen, Vector3};

use crate::body::Seen;
use crate::structure::Structure;
use crate::suspension::ends::Ends;

/// Stretch of an element to first order in displacements and rotations.
pub(crate) fn stretch(ends: &Ends, seen: &[Seen]) -> Vector3<f64> {
    let moved = |end: usize| {
        let body = &seen[ends.bodies[end]];
        body.displacement + body.rotation.cross(&ends.arms[end])
    };
    moved(1) - moved(0)
}

/// Derivative of a point's displacement by its body's displacement and rotation.
fn jacobian(arm: &Vector3<f64>) -> Matrix3x6<f64> {
    let mut jacobian = Matrix3x6::identity();
    let turn = -arm.cross_matrix();
    jacobian.fixed_view_mut::<3, 3>(0, 3).copy_from(&turn);
    jacobian
}

/// Stiffness matrix of all springs, N/m, N, N m.
pub fn stiffness(structure: &Structure) -> DMatrix<f64> {
    let size = 6 * structure.bodies.len();
    let mut matrix = DMatrix::zeros(size, size);
    for spring in &structure.suspension.springs {
        let diagonal = nalgebra::Matrix3::from_diagonal(&spring.stiffness);
        for (i, side) in [-1.0, 1.0].into_iter().enumerate() {
            for (j, other) in [-1.0, 1.0].into_iter().enumerate() {
                let rows = jacobian(&spring.ends.arms[i]).transpose();
                let block = side * other * rows * diagonal * jacobian(&spring.ends.arms[j]);
                let place = (6 * spring.ends.bodies[i], 6 * spring.ends.bodies[j]);
                let mut view = matrix.view_mut(place, (6, 6));
                view += block;
            }
        }
    }
    matrix
}

/// Masses and moments of inertia on the diagonal of the mass matrix.
pub fn inertia(structure: &Structure) -> Vec<f64> {
    let of = |body: &crate::body::RigidBody| {
        let m = body.mass;
        [m, m, m, body.inertia.x, body.inertia.y, body.inertia.z]
    };
    structure.bodies.iter().flat_map(of).collect()
}

/// Undamped natural frequencies in Hz, rising, of the bodies on their suspension while the
/// wheelsets are held.
pub fn natural_frequencies(structure: &Structure) -> Vec<f64> {
    let size = 6 * structure.bodies.iter().filter(|body| !body.turns).count();
    let stiffness = stiffness(structure);
    let inertia = inertia(structure);
    let scaled =
        DMatrix::from_fn(size, size, |i, j| stiffness[(i, j)] / (inertia[i] * inertia[j]).sqrt());
    let squares = SymmetricEigen::new(scaled).eigenvalues;
    let mut frequencies: Vec<f64> =
        squares.iter().map(|square| square.max(0.0).sqrt() / std::f64::consts::TAU).collect();
    frequencies.sort_by(f64::total_cmp);
    frequencies
}
