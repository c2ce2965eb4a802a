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
