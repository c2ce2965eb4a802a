//! Davis' formula.
//!
//! ```text
//! r = 1.3 + 29/w + 0.045 V + C A V²/W      lb per short ton
//! ```
//!
//! with the axle load w and the mass W in short tons, the speed V in mph, the frontal area A in ft²
//! and the air coefficient C; C = 0.0005 and A = 90 ft² for freight cars.
//!
//! Source: W. J. Davis, *The tractive resistance of electric locomotives and cars*, General Electric
//! Review 29, 1926. Range: plain bearings, up to about 60 km/h; modern trains need less.

use super::coefficients::{Coefficients, short_tons, square_feet};

/// Coefficients for a mass, t, on axles, with the air coefficient and the area, m².
pub fn coefficients(tonnes: f64, axles: f64, air: f64, area: f64) -> Coefficients {
    let tons = short_tons(tonnes);
    Coefficients::imperial(1.3 * tons + 29.0 * axles, 0.045 * tons, air * square_feet(area))
}

#[cfg(test)]
mod tests {
    use super::super::coefficients::tests::assert_newtons_per_tonne;

    #[test]
    fn benchmark_davis_for_a_wagon_of_134_t() {
        let area = 90.0 * 0.3048 * 0.3048;
        let found = super::coefficients(134.0, 4.0, 0.0005, area);
        assert_newtons_per_tonne(found, [10.23, 13.20, 16.63, 20.53, 24.88]);
    }
}
