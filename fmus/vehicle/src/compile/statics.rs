//! Static load of the springs: they are so long that the vehicle stands at its given heights.

use nalgebra::{DMatrix, DVector, SymmetricEigen, Vector3};
use numerics::constants::STANDARD_GRAVITY;

use crate::body::{Seen, Wrench};
use crate::linear::System;
use crate::structure::Structure;
use crate::suspension::energy::ElementEnergy;
use crate::suspension::pair::Point;

/// Names of a body's coordinates.
const COORDINATES: [&str; 6] = ["x", "y", "z", "roll", "pitch", "yaw"];

/// What no spring holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Loose {
    /// Name of the body.
    pub body: String,
    /// Coordinate in which it can move.
    pub coordinate: &'static str,
}

/// Gives every spring its force at rest on straight level track.
///
/// It is its share of the weight as unstressed springs would share it: K q = weight with the wheelsets
/// held. Elements
/// whose force at rest is given (tables, wedges, side bearers) carry that; the others the rest.
///
/// # Errors
/// When a body is not held in all directions.
pub(super) fn preload(structure: &mut Structure) -> Result<(), Loose> {
    let held = System::of_load_bearing_elements(structure).with_wheelsets_held(structure).stiffness;
    let free = held.nrows() / 6;
    let load = load(structure, free);
    let Some(factors) = held.clone().cholesky() else {
        return Err(loose(structure, held));
    };
    let displaced = factors.solve(&load);
    let mut seen = vec![Seen::default(); structure.bodies.len()];
    for (i, seen) in seen[..free].iter_mut().enumerate() {
        let at = |j: usize| Vector3::new(displaced[j], displaced[j + 1], displaced[j + 2]);
        seen.displacement = at(6 * i);
        seen.rotation = at(6 * i + 3);
    }
    set_forces(structure, &seen);
    set_wheel_loads(structure);
    Ok(())
}

/// The wheels carry the weight of their wheelset and what all elements press on it at rest.
fn set_wheel_loads(structure: &mut Structure) {
    let mut wrenches = vec![Wrench::default(); structure.bodies.len()];
    let at_rest = vec![Seen::default(); structure.bodies.len()];
    let suspension = &structure.suspension;
    let decay = vec![0.0; suspension.dampers.len()];
    let mut between: Vec<_> = suspension.between(&at_rest).collect();
    suspension.apply(&mut between, &mut suspension.at_rest(), &decay, 1.0);
    suspension.pass_on(&between, &mut wrenches);
    for data in &mut structure.wheelsets {
        let pressed = wrenches[data.body].force.z;
        data.static_wheel_load =
            0.5 * (pressed + structure.bodies[data.body].mass * STANDARD_GRAVITY);
    }
}

/// Weight, and the forces of the elements whose force at rest is given.
fn load(structure: &Structure, free: usize) -> DVector<f64> {
    let mut wrenches = vec![Wrench::default(); structure.bodies.len()];
    let at_rest = vec![Seen::default(); structure.bodies.len()];
    let (suspension, energy) = (&structure.suspension, &mut ElementEnergy::default());
    let mut between: Vec<_> = suspension.between(&at_rest).collect();
    for spring in &suspension.tabulated_springs {
        spring.apply(&mut between[spring.at.pair], energy);
    }
    for wedge in &suspension.wedges {
        wedge.apply(&mut between[wedge.at.pair], &mut [0.0; 2], 1.0, energy);
    }
    for bearer in &suspension.side_bearers {
        bearer.apply(&mut between[bearer.at.pair], &mut [0.0; 2], 1.0, energy);
    }
    suspension.pass_on(&between, &mut wrenches);
    let bodies = structure.bodies.iter().zip(wrenches).take(free);
    let parts = bodies.flat_map(|(body, Wrench { mut force, moment })| {
        force.z += body.mass * STANDARD_GRAVITY;
        [force.x, force.y, force.z, moment.x, moment.y, moment.z]
    });
    DVector::from_iterator(6 * free, parts)
}

/// Sets the springs' forces to those of a vehicle that has sunk as `seen` says.
fn set_forces(structure: &mut Structure, seen: &[Seen]) {
    let suspension = &mut structure.suspension;
    let between: Vec<_> = suspension.between(seen).collect();
    let stretch = |at: &Point| between[at.pair].displacement_at(&at.arm);
    for spring in &mut suspension.springs {
        spring.preload = -spring.stiffness.component_mul(&stretch(&spring.at));
    }
    for spring in &mut suspension.rotational_springs {
        spring.preload = -spring.stiffness.component_mul(&between[spring.pair].turned);
    }
    for rod in &mut suspension.rods {
        let stretch = between[rod.at.pair].displacement_at(&(rod.at.arm + rod.line));
        rod.preload = rod.stiffness * stretch.dot(&rod.line.normalize());
    }
    for plate in &mut suspension.centre_plates {
        let (stretch, turned) = (stretch(&plate.at), between[plate.at.pair].turned);
        plate.preload = [0, 1].map(|axis| -plate.stiffness[axis] * stretch[axis]);
        let stiffness = 0.25 * plate.stiffness.z;
        plate.rim_preload = plate.rim().map(|arm| -stiffness * (stretch.z + turned.cross(&arm).z));
    }
}

/// The body and the coordinate that move most in the direction that costs the least energy.
fn loose(structure: &Structure, stiffness: DMatrix<f64>) -> Loose {
    let eigen = SymmetricEigen::new(stiffness);
    let softest = eigen.eigenvectors.column(eigen.eigenvalues.imin());
    let index = softest.iamax();
    Loose { body: structure.bodies[index / 6].name.clone(), coordinate: COORDINATES[index % 6] }
}
