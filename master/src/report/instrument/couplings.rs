//! Power that is lost or made where train and vehicle are coupled: the co-simulation's own error.
//!
//! The train gives a vehicle its coupler forces, traction, brake and resistance at the speed of the
//! train model; the vehicle takes them, and the synchronisation force, at its own speed. What the train
//! gives less what the vehicle takes is zero where both move as one:
//!
//! ΔP = F v_train − (F + F_sync) v_vehicle

/// What of a vehicle is exchanged at one record: forces, N, forward positive but for tension and brake,
/// and speeds, m/s.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Exchanged {
    pub coupler_front: f64,
    pub coupler_rear: f64,
    pub traction: f64,
    pub brake: f64,
    pub resistance: f64,
    pub synchronisation: f64,
    pub train_speed: f64,
    pub vehicle_speed: f64,
}

impl Exchanged {
    /// What the train gives less what the vehicle takes, W.
    pub fn residual(&self) -> f64 {
        let brake = match self.train_speed == 0.0 {
            true => 0.0,
            false => self.brake.copysign(self.train_speed),
        };
        let couplers = self.coupler_front - self.coupler_rear;
        let force = couplers + self.traction + self.resistance - brake;
        force * self.train_speed - (force + self.synchronisation) * self.vehicle_speed
    }
}

/// The largest residual of a run, and what remains over all vehicles and all of its time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residual {
    /// The residual farthest from zero, W.
    pub power: f64,
    /// Number of its vehicle, from 1.
    pub vehicle: usize,
    /// Its time, s.
    pub time: f64,
    /// Integral over time of the residuals of all vehicles, J.
    pub energy: f64,
}

impl Residual {
    /// Of the residuals of so many vehicles, record by record; `None` without a finite one.
    pub fn of(time: &[f64], vehicles: usize, residuals: &[f64]) -> Option<Self> {
        let finite = residuals.iter().enumerate().filter(|(_, power)| power.is_finite());
        let (row, &power) = finite.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
        let sums: Vec<f64> = residuals.chunks(vehicles).map(|row| row.iter().sum()).collect();
        let intervals = time.windows(2).zip(sums.windows(2));
        let energy =
            intervals.map(|(time, power)| 0.5 * (power[0] + power[1]) * (time[1] - time[0]));
        Some(Self {
            power,
            vehicle: row % vehicles + 1,
            time: time[row / vehicles],
            energy: energy.sum(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 10 kN of traction and 4 kN of brake at 10 m/s, with couplers that pull forward with 1 kN more than
    /// back and 2 kN of resistance: 5 kN. The vehicle is 0.1 m/s slower and gets 500 N: it takes
    /// 5.5 kN × 9.9 m/s = 54.45 kW of 50 kW.
    #[test]
    fn analytic_what_the_train_gives_less_what_the_vehicle_takes() {
        let exchanged = Exchanged {
            coupler_front: 21e3,
            coupler_rear: 20e3,
            traction: 10e3,
            brake: 4e3,
            resistance: -2e3,
            synchronisation: 500.0,
            train_speed: 10.0,
            vehicle_speed: 9.9,
        };
        assert!((exchanged.residual() + 4450.0).abs() < 1e-9, "{}", exchanged.residual());
        let together = Exchanged { synchronisation: 0.0, vehicle_speed: 10.0, ..exchanged };
        assert_eq!(together.residual(), 0.0);
    }

    /// Two vehicles over 2 s: sums 3, 1, -1 W, whose integral by trapezia is 2 J.
    #[test]
    fn analytic_largest_residual_and_its_energy() {
        let residual = Residual::of(&[0.0, 1.0, 2.0], 2, &[1.0, 2.0, 6.0, -5.0, 0.0, -1.0]);
        let expected = Residual { power: 6.0, vehicle: 1, time: 1.0, energy: 2.0 };
        assert_eq!(residual, Some(expected));
        assert_eq!(Residual::of(&[], 2, &[]), None);
    }
}
