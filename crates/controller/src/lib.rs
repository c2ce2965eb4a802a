//! The PID controller that keeps a vehicle model in step with the train model.
//!
//! It acts on the error of position (Bosomworth et al. 2018, eq. 5-7).
//!
//! The master and the FMU `synchronisation` use this one law, so that a system that is exported
//! for other tools cannot differ from a run of the master.

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

/// Gains and limit of a controller, in SI units.
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

    /// The integral of the error, m s: all that changes in a step.
    pub fn integral(&self) -> f64 {
        self.integral
    }

    /// Puts an integral of the error back, m s.
    pub fn restore(&mut self, integral: f64) {
        self.integral = integral;
    }

    /// The force on the vehicle, N, from both motions at the same instant.
    pub fn force(&self, vehicle: Motion, train: Motion) -> f64 {
        let error = vehicle.position - train.position;
        let error_rate = vehicle.velocity - train.velocity;
        let Gains { proportional, integral, derivative, limit } = self.gains;
        let force = -(proportional * error + integral * self.integral + derivative * error_rate);
        force.clamp(-limit, limit)
    }

    /// Advances the integral of the error by a step of this `length`, s, and gives the force, N.
    ///
    /// Both motions hold for the whole step; the force is that of [`force`](Self::force) at its
    /// beginning.
    pub fn step(&mut self, vehicle: Motion, train: Motion, length: f64) -> f64 {
        let force = self.force(vehicle, train);
        // The integral stands still at the limit, or it would wind up.
        if force.abs() < self.gains.limit {
            self.integral += (vehicle.position - train.position) * length;
        }
        force
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
        let controller = Controller::new(PAPER);
        let force = controller.force(motion(10.5, 16.0), motion(10.0, 16.1));
        assert!((force - (-1000.0 + 1000.0)).abs() < 1e-9);
        assert_eq!(controller.force(motion(11.0, 16.0), motion(10.0, 16.0)), -2000.0);
    }

    #[test]
    fn force_is_limited_and_the_integral_does_not_wind_up() {
        let gains = Gains { integral: 1e3, limit: 500.0, ..PAPER };
        let mut controller = Controller::new(gains);
        for _ in 0..1000 {
            assert_eq!(controller.step(motion(1.0, 0.0), motion(0.0, 0.0), 1.0), -500.0);
        }
        assert_eq!(controller.integral(), 0.0);
    }

    /// A constant error of 1 m for 3 s with Ki = 2 N/(m s) alone: F = −Ki e t.
    #[test]
    fn analytic_the_integral_term_grows_with_time() {
        let gains =
            Gains { proportional: 0.0, integral: 2.0, derivative: 0.0, limit: f64::INFINITY };
        let mut controller = Controller::new(gains);
        for _ in 0..3 {
            controller.step(motion(1.0, 0.0), motion(0.0, 0.0), 1.0);
        }
        assert_eq!(controller.force(motion(1.0, 0.0), motion(0.0, 0.0)), -6.0);
    }
}
