//! Static load of the springs: they are so long that the vehicle stands at its given heights.

use nalgebra::{DMatrix, DVector, Vector3};

use crate::body::Seen;
use crate::frame::GRAVITY;
use crate::linear;
use crate::structure::Structure;

/// Gives every spring the force with which it carries its share of the weight on straight level
/// track, as unstressed springs would share it: K q = weight with the wheelsets held.
///
/// Nothing if a body is not held in all directions.
pub(crate) fn preload(structure: &mut Structure) -> Option<()> {
    let free = structure.bodies.iter().filter(|body| !body.turns).count();
    let stiffness = linear::stiffness(structure);
    let held = DMatrix::from(stiffness.view((0, 0), (6 * free, 6 * free)));
    let mut weight = DVector::zeros(6 * free);
    for (i, body) in structure.bodies[..free].iter().enumerate() {
        weight[6 * i + 2] = body.mass * GRAVITY;
    }
    let displaced = held.cholesky()?.solve(&weight);
    let mut seen = vec![Seen::default(); structure.bodies.len()];
    for (i, seen) in seen[..free].iter_mut().enumerate() {
        let at = |j: usize| Vector3::new(displaced[j], displaced[j + 1], displaced[j + 2]);
        seen.displacement = at(6 * i);
        seen.rotation = at(6 * i + 3);
    }
    for spring in &mut structure.suspension.springs {
        let stretch = linear::stretch(&spring.ends, &seen);
        spring.preload = -spring.stiffness.component_mul(&stretch);
    }
    Some(())
}
