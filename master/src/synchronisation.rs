//! Keeps each vehicle at its place in the train: a PID controller on the position error
//! (Bosomworth et al. 2018, eq. 5-7).

use crate::scenario::Synchronisation;

/// Controller of one vehicle.
///
/// With the error e = x_vehicle − x_train, the force on the vehicle is
/// F = −(Kp e + Ki ∫e dt + Kd ė), limited in magnitude. Velocity-only control
/// (Bosomworth et al. 2018, eq. 4) is Kp = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Controller {
    gains: Gains,
    /// ∫e dt, m s.
    integral: f64,
}

/// Gains and limit of the controllers, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gains {
    /// Kp, N/m.
    pub proportional: f64,
    /// Ki, N/(m s).
    pub integral: f64,
    /// Kd, N s/m.
    pub derivative: f64,
    /// Largest magnitude of the force, N.
    pub limit: f64,
}

impl From<&Synchronisation> for Gains {
    fn from(file: &Synchronisation) -> Self {
        Self {
            proportional: file.kp_kn_per_m * 1e3,
            integral: file.ki_kn_per_m_s * 1e3,
            derivative: file.kd_kn_s_per_m * 1e3,
            limit: file.limit_kn * 1e3,
        }
    }
}

/// Position and velocity at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// Chainage, m.
    pub position: f64,
    /// Speed along the track, m/s.
    pub velocity: f64,
}

impl Controller {
    /// A controller at rest.
    pub fn new(gains: Gains) -> Self {
        Self { gains, integral: 0.0 }
    }

    /// The force on the vehicle, N, from both motions at the same instant; it acts for
    /// `length`, s.
    pub fn force(&mut self, vehicle: Motion, train: Motion, length: f64) -> f64 {
        let error = vehicle.position - train.position;
        let error_rate = vehicle.velocity - train.velocity;
        let Gains { proportional, integral, derivative, limit } = self.gains;
        let force = -(proportional * error + integral * self.integral + derivative * error_rate);
        // The integral stands still at the limit, or it would wind up.
        if force.abs() < limit {
            self.integral += error * length;
        }
        force.clamp(-limit, limit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAPER: Gains =
        Gains { proportional: 2e3, integral: 0.0, derivative: 10e3, limit: f64::INFINITY };

    fn motion(position: f64, velocity: f64) -> Motion {
        Motion { position, velocity }
    }

    /// Bosomworth et al. 2018, eq. 7 with 2 kN/m and 10 kN/(m/s).
    #[test]
    fn benchmark_gains_of_the_paper() {
        let mut controller = Controller::new(PAPER);
        let force = controller.force(motion(10.5, 16.0), motion(10.0, 16.1), 1e-3);
        assert!((force - (-1000.0 + 1000.0)).abs() < 1e-9);
        assert_eq!(controller.force(motion(11.0, 16.0), motion(10.0, 16.0), 1e-3), -2000.0);
    }

    #[test]
    fn force_is_limited_and_the_integral_does_not_wind_up() {
        let gains = Gains { integral: 1e3, limit: 500.0, ..PAPER };
        let mut controller = Controller::new(gains);
        for _ in 0..1000 {
            assert_eq!(controller.force(motion(1.0, 0.0), motion(0.0, 0.0), 1.0), -500.0);
        }
        assert_eq!(controller.integral, 0.0);
    }
}
