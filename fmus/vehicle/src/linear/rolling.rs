//! The linear system of a vehicle on straight rails, and the speed at which it becomes unstable.
//!
//! For the wheel on side s = ±1 of a wheelset, with the half distance e of the contacts, radius r,
//! conicity λ and Kalker's coefficients f11, f22 (eq. 35):
//!
//!   longitudinal creepage  s λ y/r - (dx/dt + r dθ/dt - s e dψ/dt)/V,   force f11 times that
//!   lateral creepage       (dy/dt - r dφ/dt)/V - ψ,                     force -f22 times that
//!
//! and a vertical spring with damping. Without gravity stiffness, spin and gyroscopic moments.

use contact::STEEL;
use contact::hertz::UnitContact;
use contact::kalker::CreepCoefficients;
use nalgebra::DVector;

use super::system::{COORDINATES, Surfaces, System};
use crate::structure::Structure;

/// Vertical stiffness of a contact with what is below it, N/m, and its damping, N s/m.
const VERTICAL: (f64, f64) = (0.2e9, 100e3);

/// Rate of growth, 1/s, above which the vehicle counts as unstable: it doubles in 70 s.
const GROWING: f64 = 0.01;

/// Stiffness that holds the first body along the track, N/m, so that the vehicle does not drift: 0.04 Hz
/// for a heavy locomotive.
const HOLDING: f64 = 1e4;

/// Steps of the search for the first unstable speed, m/s.
///
/// A narrower range of unstable speeds, such as that of a body that sways with its wheelsets, may be
/// missed.
const SEARCH_STEP: f64 = 4.0;

/// How exactly the speed is found, m/s.
const EXACTNESS: f64 = 0.1;

/// How far above it the frequency is read, m/s, where the growing mode outweighs all others.
const BEYOND: f64 = 3.0;

/// Wheels and rails of the linear system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rolling {
    /// Conicity λ.
    pub conicity: f64,
    /// Half distance e of the contacts, m.
    pub half_distance: f64,
    /// Radius of the rail head, m.
    pub rail_radius: f64,
}

/// Where a vehicle becomes unstable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalSpeed {
    /// Speed, m/s.
    pub speed: f64,
    /// Frequency of the mode that begins to grow, Hz.
    pub frequency: f64,
}

impl Rolling {
    /// Kalker's f11 and f22 of a wheel of this radius under `load`, N: G a b C11 and G a b C22.
    pub fn creep_coefficients(&self, radius: f64, load: f64) -> [f64; 2] {
        let unit = UnitContact::new(0.5 / radius, 0.5 / self.rail_radius, &STEEL);
        let (a, b) = (unit.semi_axis_rolling, unit.semi_axis_lateral);
        let kalker = CreepCoefficients::new(a / b, STEEL.poisson_ratio);
        let area = a * b * libm::pow(load, 2.0 / 3.0);
        [kalker.c11, kalker.c22].map(|c| STEEL.shear_modulus * area * c)
    }

    /// The speed up to `greatest` at which the first oscillation begins to grow, if there is one.
    pub fn critical_speed(&self, structure: &Structure, greatest: f64) -> Option<CriticalSpeed> {
        let suspension = System::new(structure, Surfaces::Slide);
        let at = |speed: f64| self.system(&suspension, structure, speed).least_stable();
        let grows = |speed: f64| at(speed).is_some_and(|mode| mode.growth > GROWING);
        let (mut stable, mut unstable) = (0.0, SEARCH_STEP.min(greatest));
        while !grows(unstable) {
            if unstable >= greatest {
                return None;
            }
            stable = unstable;
            unstable = (stable + SEARCH_STEP).min(greatest);
        }
        while unstable - stable > EXACTNESS {
            let middle = 0.5 * (stable + unstable);
            if grows(middle) {
                unstable = middle;
            } else {
                stable = middle;
            }
        }
        let frequency = at(unstable + BEYOND)?.frequency / std::f64::consts::TAU;
        Some(CriticalSpeed { speed: unstable, frequency })
    }

    /// The suspension with its wheelsets on the rails at `speed`.
    fn system(&self, suspension: &System, structure: &Structure, speed: f64) -> System {
        let mut system = suspension.clone();
        let size = system.inertia.len();
        system.stiffness[(0, 0)] += HOLDING;
        for data in &structure.wheelsets {
            let radius = data.wheel.radius;
            let [f11, f22] = self.creep_coefficients(radius, data.static_wheel_load);
            let at = COORDINATES * data.body;
            let row = |entries: &[(usize, f64)]| {
                let mut row = DVector::zeros(size);
                entries.iter().for_each(|(i, value)| row[at + i] = *value);
                row
            };
            let (across, yaw) = (row(&[(1, 1.0)]), row(&[(5, 1.0)]));
            for side in [-1.0, 1.0] {
                let vertical = row(&[(2, 1.0), (3, side * self.half_distance)]);
                system.stiffness += VERTICAL.0 * &vertical * vertical.transpose();
                system.damping += VERTICAL.1 * &vertical * vertical.transpose();
                let along = row(&[(0, 1.0), (4, radius), (5, -side * self.half_distance)]);
                system.damping += f11 / speed * &along * along.transpose();
                let steering = f11 * side * self.conicity / radius;
                system.stiffness -= steering * &along * across.transpose();
                let sideways = row(&[(1, 1.0), (3, -radius)]);
                system.damping += f22 / speed * &sideways * sideways.transpose();
                system.stiffness -= f22 * &sideways * yaw.transpose();
            }
        }
        system
    }
}
