//! The modified Davis formula of the American railway engineers.
//!
//! ```text
//! r = 0.6 + 20/w + 0.01 V + K V²/W      lb per short ton
//! ```
//!
//! with the axle load w and the mass W in short tons and the speed V in mph; K = 0.07 for
//! conventional equipment, 0.0935 for containers, 0.16 for trailers on flat cars.
//!
//! Source: American Railway Engineering Association, *Manual for Railway Engineering*, 1970 (now of
//! AREMA), ch. 16. Range: freight cars on roller bearings.

use super::coefficients::{Coefficients, short_tons};

/// Coefficients for a mass, t, on axles, with the air coefficient K.
pub fn coefficients(tonnes: f64, axles: f64, air: f64) -> Coefficients {
    let tons = short_tons(tonnes);
    Coefficients::imperial(0.6 * tons + 20.0 * axles, 0.01 * tons, air)
}

#[cfg(test)]
mod tests {
    use super::super::coefficients::tests::assert_newtons_per_tonne;

    #[test]
    fn benchmark_arema_for_a_wagon_of_134_t() {
        let found = super::coefficients(134.0, 4.0, 0.07);
        assert_newtons_per_tonne(found, [5.60, 6.57, 8.25, 10.66, 13.78]);
    }
}
