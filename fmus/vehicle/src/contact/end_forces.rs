//! Forces of a contact at the end of a step, and the heat that arises with them.

use contact::{SlipVelocity, TangentialForce};

use super::rows::{ContactMotion, Linearised};

/// Forces of a contact at the end of a step, N.
pub(super) struct EndForces {
    /// Creep force on the wheel.
    pub creep: TangentialForce,
    /// Normal force.
    pub normal: f64,
    /// Moment of creep on the wheel about the normal, N m.
    pub spin_moment: f64,
}

impl EndForces {
    /// The forces after a `change` of the motion.
    pub fn new(forces: &Linearised, change: &ContactMotion) -> Self {
        let creep = &forces.creep;
        Self {
            creep: TangentialForce {
                longitudinal: creep.force.longitudinal
                    + creep.damping.longitudinal * change.slip.longitudinal,
                lateral: creep.force.lateral - creep.damping.lateral * change.slip.lateral,
            },
            normal: forces.normal + forces.normal_damping * change.approach,
            spin_moment: creep.spin_moment,
        }
    }

    /// Power that creep takes from the wheelset at this slip, W.
    pub fn heat(&self, slip: &SlipVelocity) -> f64 {
        let Self { creep, spin_moment, .. } = self;
        creep.longitudinal * slip.longitudinal
            - creep.lateral * slip.lateral
            - spin_moment * slip.spin
    }
}

/// Heat that arises in a step's contacts, W: by creep, and by damping along the normals.
#[derive(Clone, Copy, Debug, Default)]
pub struct ContactHeat {
    /// By creep.
    pub friction: f64,
    /// By damping.
    pub damping: f64,
}

#[cfg(test)]
mod tests {
    use contact::{CreepDamping, CreepForces};

    use super::*;

    /// More traction slip raises the driving force, more lateral slip the force against it, and a faster
    /// approach the normal force; the heat is what force and moment take from the slip.
    #[test]
    fn analytic_forces_after_a_change_of_motion() {
        let force = TangentialForce { longitudinal: 1000.0, lateral: -200.0 };
        let damping = CreepDamping { longitudinal: 1e5, lateral: 2e5 };
        let creep = CreepForces { force, damping, spin_moment: 5.0, ..CreepForces::default() };
        let forces =
            Linearised { normal: 1e5, normal_damping: 1e4, creep, ..Linearised::default() };
        let slip = SlipVelocity { longitudinal: 1e-3, lateral: 2e-3, spin: 0.0 };
        let end = EndForces::new(&forces, &ContactMotion { slip, approach: 0.01 });
        assert!((end.creep.longitudinal - 1100.0).abs() < 1e-9);
        assert!((end.creep.lateral + 600.0).abs() < 1e-9);
        assert!((end.normal - 100_100.0).abs() < 1e-9);
        let slip = SlipVelocity { longitudinal: 0.01, lateral: 0.02, spin: -0.1 };
        // 11 W along, 12 W across, 0.5 W about the normal.
        assert!((end.heat(&slip) - 23.5).abs() < 1e-12, "{} W", end.heat(&slip));
    }
}
