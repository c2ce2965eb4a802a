//! Propulsion resistance of a vehicle on straight level track.
//!
//! A Davis formula with the coefficients of the vehicle file (theory, eq. 9):
//!
//! ```text
//! R = k (a m + b n + c m V + d V²)      m in t, n axles, V in km/h, R in N
//! ```
//!
//! Cole's form of the modified Davis formula, Ka [2.943 + 89.2/m_a + 0.0306 V +
//! 1.741 k_ad V²/(m_a n)] N/t with the axle load m_a (*Handbook of Railway Vehicle Dynamics*, 2006,
//! ch. 9), is a = 2.943, b = 89.2, c = 0.0306, d = 1.741 k_ad; the Canadian National, AREMA and
//! AAR formulas fit in the same way. Valid up to the speeds of freight trains, about 120 km/h.
//!
//! Validated by `benchmark_resistance_of_the_train_at_60_kmh`: 209.9 kN for the paper's train.

/// Kilometres per hour in a metre per second.
const KMH: f64 = 3.6;

/// Propulsion resistance `constant + linear v + quadratic v²`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resistance {
    /// N.
    constant: f64,
    /// N s/m.
    linear: f64,
    /// N s²/m².
    quadratic: f64,
}

impl Resistance {
    /// The resistance of a vehicle.
    pub fn new(vehicle: &stock::Vehicle) -> Self {
        let file = &vehicle.resistance;
        let tonnes = vehicle.mass_kg * 1e-3;
        let axles = f64::from(vehicle.axles);
        Self {
            constant: file.factor * (file.constant_n_per_t * tonnes + file.axle_n * axles),
            linear: file.factor * file.linear_n_per_t_kmh * tonnes * KMH,
            quadratic: file.factor * file.quadratic_n_per_kmh2 * KMH * KMH,
        }
    }

    /// Greatest force against the motion at a speed, m/s, in N; at standstill what it takes to
    /// set the vehicle in motion.
    pub fn force(&self, speed: f64) -> f64 {
        self.constant + speed * (self.linear + speed * self.quadratic)
    }
}
