//! Force elements between two bodies.
//!
//! | file | element |
//! |---|---|
//! | `ends.rs` | what all have in common: two bodies, two points, stretch and rate |
//! | `spring.rs` | spring with parallel damping and static load |
//! | `damper.rs` | hydraulic damper, rigid or with stiffness in series, with blow-off |
//! | `stop.rs` | stop with free play |

pub mod damper;
pub mod ends;
pub mod spring;
pub mod stop;

use crate::body::{Seen, Wrench};
use damper::Damper;
use spring::Spring;
use stop::Stop;

/// All elements of a vehicle, by kind.
#[derive(Clone, Debug, Default)]
pub struct Suspension {
    /// Springs.
    pub springs: Vec<Spring>,
    /// Dampers.
    pub dampers: Vec<Damper>,
    /// Stops.
    pub stops: Vec<Stop>,
}

/// Energy in the elements.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ElementEnergy {
    /// Stored in springs, stops and series stiffnesses, J.
    pub stored: f64,
    /// Power turned into heat, W.
    pub dissipated: f64,
}

impl Suspension {
    /// Adds the forces of all elements to `wrenches`. The forces of the dampers with stiffness in
    /// series, `damper_forces`, are brought to the end of the step for which `decay` holds.
    pub fn apply(
        &self,
        seen: &[Seen],
        damper_forces: &mut [f64],
        decay: &[f64],
        wrenches: &mut [Wrench],
    ) -> ElementEnergy {
        let mut energy = ElementEnergy::default();
        for spring in &self.springs {
            spring.apply(seen, wrenches, &mut energy);
        }
        let states = damper_forces.iter_mut().zip(decay);
        for (damper, (force, &decay)) in self.dampers.iter().zip(states) {
            damper.apply(seen, force, decay, wrenches, &mut energy);
        }
        for stop in &self.stops {
            stop.apply(seen, wrenches, &mut energy);
        }
        energy
    }
}
