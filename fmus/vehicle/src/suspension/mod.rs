//! Force elements between two bodies.
//!
//! | file | element |
//! |---|---|
//! | `pair.rs` | what all have in common: two bodies, a point, stretch and rate |
//! | `energy.rs` | energy that elements store and turn into heat |
//! | `spring.rs` | spring with parallel damping and static load |
//! | `damper.rs` | hydraulic damper, rigid or with stiffness in series, with blow-off |
//! | `stop.rs` | stop with free play |
//! | `tabulated.rs` | spring with a table of force over displacement |
//! | `rotational.rs` | spring against rotation: anti-roll bar |
//! | `rod.rs` | rod with a length: traction rod |
//! | `grip.rs` | dry friction that sticks, the common part of the next four |
//! | `friction.rs` | friction with a constant limit |
//! | `wedge.rs` | friction wedge |
//! | `centre_plate.rs` | centre plate |
//! | `side_bearer.rs` | constant-contact side bearer |

pub mod centre_plate;
pub mod damper;
pub mod energy;
pub mod friction;
pub mod grip;
pub mod pair;
pub mod rod;
pub mod rotational;
pub mod side_bearer;
pub mod spring;
pub mod stop;
pub mod tabulated;
pub mod wedge;

use serde::{Deserialize, Serialize};

use crate::body::{Seen, Wrench};
use centre_plate::CentrePlate;
use damper::Damper;
use energy::ElementEnergy;
use friction::Friction;
use pair::{Between, Pair};
use rod::Rod;
use rotational::RotationalSpring;
use side_bearer::SideBearer;
use spring::Spring;
use stop::Stop;
use tabulated::TabulatedSpring;
use wedge::Wedge;

/// All elements of a vehicle, by kind.
#[derive(Clone, Debug, Default)]
pub struct Suspension {
    /// Bodies that elements join.
    pub pairs: Vec<Pair>,
    /// Springs.
    pub springs: Vec<Spring>,
    /// Dampers.
    pub dampers: Vec<Damper>,
    /// Stops.
    pub stops: Vec<Stop>,
    /// Springs with a table.
    pub tabulated_springs: Vec<TabulatedSpring>,
    /// Springs against rotation.
    pub rotational_springs: Vec<RotationalSpring>,
    /// Rods.
    pub rods: Vec<Rod>,
    /// Dry friction.
    pub frictions: Vec<Friction>,
    /// Friction wedges.
    pub wedges: Vec<Wedge>,
    /// Centre plates.
    pub centre_plates: Vec<CentrePlate>,
    /// Side bearers.
    pub side_bearers: Vec<SideBearer>,
}

/// What elements remember from step to step.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ElementState {
    /// Force of each damper on its second body, N.
    pub dampers: Vec<f64>,
    /// Friction force, in one or two directions, or moment, on the second body: of frictions,
    /// wedges, centre plates, side bearers.
    pub friction: Vec<[f64; 2]>,
}

impl Suspension {
    /// The memory of elements at rest without friction forces.
    pub fn at_rest(&self) -> ElementState {
        let friction = self.frictions.len()
            + self.wedges.len()
            + self.centre_plates.len()
            + self.side_bearers.len();
        ElementState { dampers: vec![0.0; self.dampers.len()], friction: vec![[0.0; 2]; friction] }
    }

    /// How the bodies of each pair move against each other.
    pub fn between<'a>(&'a self, seen: &'a [Seen]) -> impl Iterator<Item = Between> + use<'a> {
        self.pairs.iter().map(|pair| pair.between(seen))
    }

    /// Adds the forces of all elements to those `between` the pairs; gives the elements' energy.
    ///
    /// Their memory comes to the end of the step, for which each damper's `decay` holds.
    pub fn apply(
        &self,
        between: &mut [Between],
        state: &mut ElementState,
        decay: &[f64],
        step: f64,
    ) -> ElementEnergy {
        let mut energy = ElementEnergy::default();
        for spring in &self.springs {
            spring.apply(&mut between[spring.at.pair], &mut energy);
        }
        let dampers = state.dampers.iter_mut().zip(decay);
        for (damper, (force, &decay)) in self.dampers.iter().zip(dampers) {
            damper.apply(&mut between[damper.at.pair], force, decay, &mut energy);
        }
        for stop in &self.stops {
            stop.apply(&mut between[stop.at.pair], &mut energy);
        }
        for spring in &self.tabulated_springs {
            spring.apply(&mut between[spring.at.pair], &mut energy);
        }
        for spring in &self.rotational_springs {
            spring.apply(&mut between[spring.pair], &mut energy);
        }
        for rod in &self.rods {
            rod.apply(&mut between[rod.at.pair], &mut energy);
        }
        let mut memory = state.friction.iter_mut();
        for (friction, force) in self.frictions.iter().zip(&mut memory) {
            friction.apply(&mut between[friction.at.pair], force, step, &mut energy);
        }
        for (wedge, force) in self.wedges.iter().zip(&mut memory) {
            wedge.apply(&mut between[wedge.at.pair], force, step, &mut energy);
        }
        for (plate, moment) in self.centre_plates.iter().zip(&mut memory) {
            plate.apply(&mut between[plate.at.pair], moment, step, &mut energy);
        }
        for (bearer, force) in self.side_bearers.iter().zip(&mut memory) {
            bearer.apply(&mut between[bearer.at.pair], force, step, &mut energy);
        }
        energy
    }

    /// Adds to all bodies what passes between them.
    pub fn pass_on(&self, between: &[Between], wrenches: &mut [Wrench]) {
        for (pair, between) in self.pairs.iter().zip(between) {
            pair.pass_on(between, wrenches);
        }
    }
}
