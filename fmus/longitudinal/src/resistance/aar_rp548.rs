//! The modified Davis formula of the Association of American Railroads.
//!
//! ```text
//! r = 1.3 + 72.5/W + 0.015 V + 0.055 V²/W      lb per short ton
//! ```
//!
//! with the mass W in short tons and the speed V in mph.
//!
//! Source: AAR RP-548 as in F. Szanto, *Rolling resistance revisited*, Conference on Railway
//! Excellence, 2016, eq. 2. Range: freight cars on roller bearings.

use super::coefficients::{Coefficients, short_tons};

/// Coefficients for a mass, t.
pub fn coefficients(tonnes: f64) -> Coefficients {
    let tons = short_tons(tonnes);
    Coefficients::imperial(1.3 * tons + 72.5, 0.015 * tons, 0.055)
}

#[cfg(test)]
mod tests {
    use super::super::coefficients::tests::assert_newtons_per_tonne;

    #[test]
    fn benchmark_aar_rp548_for_a_wagon_of_134_t() {
        assert_newtons_per_tonne(super::coefficients(134.0), [8.78, 9.98, 11.74, 14.06, 16.95]);
    }

    /// Szanto 2016, eq. 3 gives the same in N, t and km/h: 6.5 + 320/m + 0.046 V + 0.096 V²/m, with
    /// g = 10 m/s², which is 2 % more, and coefficients of two figures.
    #[test]
    fn benchmark_aar_rp548_in_metric_units() {
        for mass in [30.0, 80.0, 134.0] {
            for speed in [0.0, 40.0, 80.0] {
                let c = super::coefficients(mass);
                let found = c.constant + speed * (c.linear + speed * c.quadratic);
                let szanto = 6.5 * mass + 320.0 + speed * (0.046 * mass + 0.096 * speed);
                assert!((found / szanto - 1.0).abs() < 0.02, "{found} N, Szanto {szanto} N");
            }
        }
    }
}
