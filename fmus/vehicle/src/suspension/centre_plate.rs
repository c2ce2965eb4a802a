//! Centre plate: a body (first) rests with a flat round plate on its bolster (second).
//!
//! Its vertical stiffness stands in four springs on the rim that push but do not pull, so that it
//! carries roll and pitch moments up to N R, at which it rocks; the ring around it is a spring in x
//! and y; it turns against the friction moment (2/3) μ N R of an evenly pressed disc, which sticks
//! as `grip.rs` says (eq. 32).

use nalgebra::Vector3;

use super::energy::ElementEnergy;
use super::grip::Grip;
use super::pair::{Between, Point};

/// Points on the rim, for a radius of one.
const RIM: [[f64; 2]; 4] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];

/// A centre plate.
#[derive(Clone, Debug)]
pub struct CentrePlate {
    /// The plate's middle, where it joins body and bolster.
    pub at: Point,
    /// Radius R, m.
    pub radius: f64,
    /// Stiffness in x, y, z, N/m.
    pub stiffness: Vector3<f64>,
    /// Damping in x, y, z, N s/m.
    pub damping: Vector3<f64>,
    /// Friction coefficient μ.
    pub friction: f64,
    /// How it sticks against yaw, N m/rad.
    pub grip: Grip,
    /// Horizontal forces on the bolster at rest, N.
    pub preload: [f64; 2],
    /// Vertical forces on the rim at rest, N.
    pub rim_preload: [f64; 4],
}

impl CentrePlate {
    /// Points on the rim, from the middle, m.
    pub fn rim(&self) -> [Vector3<f64>; 4] {
        RIM.map(|[x, y]| Vector3::new(self.radius * x, self.radius * y, 0.0))
    }

    /// Brings the friction moment on the bolster (`moment[0]`) to the end of the step and adds all forces.
    #[inline]
    pub fn apply(
        &self,
        between: &mut Between,
        moment: &mut [f64; 2],
        step: f64,
        energy: &mut ElementEnergy,
    ) {
        let stretch = between.stretch(&self.at.arm);
        let (turned, turning) = (between.turned, between.turning);

        let mut force = Vector3::zeros();
        for axis in [0, 1] {
            let (length, rate) = (stretch.length[axis], stretch.rate[axis]);
            let (elastic, viscous) = (self.stiffness[axis] * length, self.damping[axis] * rate);
            force[axis] = self.preload[axis] - elastic - viscous;
            energy.stored += length * (0.5 * elastic - self.preload[axis]);
            energy.dissipated += viscous * rate;
        }
        let mut tilting = Vector3::zeros();
        let stiffness = 0.25 * self.stiffness.z;
        for (arm, preload) in self.rim().iter().zip(self.rim_preload) {
            let gap = stretch.length.z + turned.cross(arm).z;
            let lift = gap.min(preload / stiffness);
            energy.stored += lift * (0.5 * stiffness * lift - preload);
            if lift < gap {
                continue;
            }
            let rate = stretch.rate.z + turning.cross(arm).z;
            let viscous = 0.25 * self.damping.z * rate;
            energy.dissipated += viscous * rate;
            let push = Vector3::new(0.0, 0.0, preload - stiffness * lift - viscous);
            force += push;
            tilting += arm.cross(&push);
        }
        let limit = 2.0 / 3.0 * self.friction * force.z.max(0.0) * self.radius;
        let trial = self.grip.trial(moment, [turning.z, 0.0], step);
        self.grip.hold(moment, trial, limit, step, energy);
        tilting.z += moment[0];

        between.push(&stretch, &force);
        between.moment += tilting;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::Seen;
    use crate::suspension::pair::Pair;

    fn plate() -> CentrePlate {
        CentrePlate {
            at: Point::TEST,
            radius: 0.19,
            stiffness: Vector3::new(175e6, 175e6, 875e6),
            damping: Vector3::zeros(),
            friction: 0.25,
            grip: Grip { stiffness: 1e7 },
            preload: [0.0; 2],
            rim_preload: [50e3; 4],
        }
    }

    /// Moment on the body after it turned by `rotation`.
    fn moment(rotation: Vector3<f64>) -> Vector3<f64> {
        let angular_velocity = Vector3::new(0.0, 0.0, rotation.z / 1e-3);
        let body = Seen { rotation, angular_velocity, ..Seen::default() };
        let mut between = Pair::TEST.between(&[body, Seen::default()]);
        plate().apply(&mut between, &mut [0.0; 2], 1e-3, &mut ElementEnergy::default());
        -between.moment
    }

    /// Small roll: stiffness k R²/2. A plate that tilts about its rim carries at most the load on
    /// it times R: 200 kN, three points of which one lies at R and two at 0.
    #[test]
    fn analytic_roll_stiffness_and_rocking() {
        let stiffness = 875e6 * 0.19 * 0.19 / 2.0;
        assert!((moment(Vector3::new(1e-5, 0.0, 0.0)).x + stiffness * 1e-5).abs() < 1e-6);
        // The lifted point is off its seat by 10 kN of its stiffness: the other one has 110 kN.
        let angle = 60e3 / (0.25 * 875e6 * 0.19);
        assert!((moment(Vector3::new(angle, 0.0, 0.0)).x + 110e3 * 0.19).abs() < 1e-3);
    }

    /// (2/3) 0.25 x 200 kN x 0.19 m = 6333 N m.
    #[test]
    fn analytic_friction_moment() {
        assert!((moment(Vector3::new(0.0, 0.0, 0.01)).z + 6333.33).abs() < 0.01);
        assert!((moment(Vector3::new(0.0, 0.0, 1e-4)).z + 1000.0).abs() < 1e-9);
    }
}
