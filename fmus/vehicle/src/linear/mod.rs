//! The vehicle linearised at rest on straight track: matrices of mass, stiffness and damping.
//!
//! | file | part |
//! |---|---|
//! | `system.rs` | M d²q/dt² + C dq/dt + K q + dampers with stiffness in series = 0 |
//! | `modes.rs` | its eigenvalues and shapes |
//!
//! Coordinates are displacement and rotation of each body in turn (six each). Elements count with
//! their tangents at the static load, without weight and static load themselves; stops within
//! their play do nothing.

mod modes;
mod system;

pub use modes::{Mode, Modes};
pub use system::System;

use nalgebra::{DMatrix, SymmetricEigen, Vector3};

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

/// Stiffness matrix of all springs, N/m, N, N m.
pub fn stiffness(structure: &Structure) -> DMatrix<f64> {
    System::new(structure).stiffness
}

/// Undamped natural frequencies in Hz, rising, of the bodies on their suspension while the
/// wheelsets are held.
pub fn natural_frequencies(structure: &Structure) -> Vec<f64> {
    let held = System::new(structure).with_wheelsets_held(structure);
    let squares = SymmetricEigen::new(held.scaled(&held.stiffness)).eigenvalues;
    let mut frequencies: Vec<f64> =
        squares.iter().map(|square| square.max(0.0).sqrt() / std::f64::consts::TAU).collect();
    frequencies.sort_by(f64::total_cmp);
    frequencies
}
