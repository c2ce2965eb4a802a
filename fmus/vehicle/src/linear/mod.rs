//! The vehicle linearised at rest on straight track: matrices of mass, stiffness and damping.
//!
//! | file | part |
//! |---|---|
//! | `system.rs` | M d²q/dt² + C dq/dt + K q + dampers with stiffness in series = 0 |
//! | `modes.rs` | its eigenvalues and shapes |
//! | `rolling.rs` | wheelsets that roll; the critical speed |
//! | `stability.rs` | whether a system is stable |
//!
//! Coordinates are displacement and rotation of each body in turn (six each). Elements count with
//! their tangents at the static load, without weight and static load themselves; stops within
//! their play do nothing.

mod modes;
mod rolling;
mod stability;
mod system;

pub use modes::{Mode, Modes};
pub use rolling::{CriticalSpeed, Rolling};
pub use system::{Surfaces, System};

use nalgebra::{DMatrix, SymmetricEigen};

use crate::structure::Structure;

/// Stiffness of a contact, N/m, under a load, N, with whose cube root it grows.
///
/// Hertz for a wheel of 0.508 m radius on a rail head of 0.3 m.
const CONTACT_STIFFNESS: (f64, f64) = (1.5e9, 109.5e3);

/// Greatest natural circular frequency, rad/s, of the vehicle on its wheels with all friction
/// sticking: what an explicit step must resolve.
pub(crate) fn highest_frequency(structure: &Structure) -> f64 {
    let mut system = System::new(structure, Surfaces::Stick);
    for data in &structure.wheelsets {
        let (stiffness, load) = CONTACT_STIFFNESS;
        let both = 2.0 * stiffness * libm::cbrt(data.static_wheel_load / load);
        let at = system::COORDINATES * data.body;
        let half = data.wheel.half_distance;
        system.stiffness[(at + 2, at + 2)] += both;
        system.stiffness[(at + 3, at + 3)] += both * half * half;
    }
    SymmetricEigen::new(system.scaled(&system.stiffness)).eigenvalues.max().sqrt()
}

/// Stiffness matrix of all springs, N/m, N, N m.
pub fn stiffness(structure: &Structure) -> DMatrix<f64> {
    System::new(structure, Surfaces::Slide).stiffness
}

/// Undamped natural frequencies in Hz, rising, of the bodies on held wheelsets.
pub fn natural_frequencies(structure: &Structure) -> Vec<f64> {
    let held = System::new(structure, Surfaces::Slide).with_wheelsets_held(structure);
    let squares = SymmetricEigen::new(held.scaled(&held.stiffness)).eigenvalues;
    let mut frequencies: Vec<f64> =
        squares.iter().map(|square| square.max(0.0).sqrt() / std::f64::consts::TAU).collect();
    frequencies.sort_by(f64::total_cmp);
    frequencies
}
