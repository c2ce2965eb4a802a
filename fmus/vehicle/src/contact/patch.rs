//! One contact of a wheel with its rail: how hard it presses, and how it slips.

use contact::{CreepLaw, PressedPatch};

use super::rows::{ContactMotion, Linearised, Rows};
use super::wheel_motion::WheelMotion;

/// A contact that presses, and its forces at the beginning of a step.
#[derive(Clone, Copy, Debug)]
pub struct Patch {
    /// Number of the patch in the table, from 0.
    pub number: usize,
    /// Elastic approach along the normal, m, positive (eq. 17).
    pub approach: f64,
    /// Elastic energy, J.
    pub elastic_energy: f64,
    /// Normal force without damping, N (eq. 18).
    pub elastic_force: f64,
    /// How it moves with the wheelset.
    pub rows: Rows,
    /// How it moves at the beginning of the step.
    pub motion: ContactMotion,
    /// Its forces then; all vanish where the wheel rebounds faster than the contact can follow.
    pub forces: Linearised,
    /// Lateral coordinate on the rail head, m from its top, negative towards the gauge side.
    pub rail_lateral: f64,
    slope: f64,
}

impl Patch {
    /// The contact `number` of the table, pressed by a wheel in this motion.
    #[inline]
    pub fn new(
        number: usize,
        pressed: &PressedPatch,
        wheel: &WheelMotion,
        creep: &CreepLaw,
    ) -> Self {
        let PressedPatch { point, approach, .. } = pressed;
        let (data, approach) = (wheel.data, *approach);
        let rows = Rows::new(pressed, wheel);
        let motion = rows.motion(wheel.velocities);
        let elastic_force = point.hertz.normal_force(approach);
        let normal_damping = elastic_force * data.damping;
        let normal = elastic_force + normal_damping * motion.approach;
        let mut forces = Linearised::default();
        if normal > 0.0 {
            let patch = point.pressed(approach, normal);
            let creep = creep.force(&patch, &motion.slip, wheel.speed);
            forces = Linearised { normal, normal_damping, creep, a: patch.a, b: patch.b };
        }
        Self {
            number,
            approach,
            elastic_energy: pressed.energy,
            elastic_force,
            rows,
            motion,
            forces,
            rail_lateral: point.rail_lateral,
            slope: point.slope,
        }
    }

    /// Contact angle, rad, positive as on a tread.
    pub fn angle(&self) -> f64 {
        -libm::atan(self.slope)
    }
}
