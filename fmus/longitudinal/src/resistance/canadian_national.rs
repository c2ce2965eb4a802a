//! The formula of Canadian National.
//!
//! ```text
//! r = 1.5 + 18 n/W + 0.03 V + C A V²/(10⁴ W)      lb per short ton
//! ```
//!
//! with n axles, the mass W in short tons, the speed V in mph, the frontal area A in ft² and the air
//! coefficient C: 105 ft² and 4.2 for a loaded gondola, 160 ft² and 24 for a leading locomotive.
//!
//! Source: Canadian National, 1992, as in the manual of the Train Propulsion Simulator, eq. 7 and
//! table 22. Range: freight trains on roller bearings.

use super::coefficients::{Coefficients, short_tons, square_feet};

/// Coefficients for a mass, t, on axles, with the air coefficient and the area, m².
pub fn coefficients(tonnes: f64, axles: f64, air: f64, area: f64) -> Coefficients {
    let tons = short_tons(tonnes);
    let quadratic = air * square_feet(area) * 1e-4;
    Coefficients::imperial(1.5 * tons + 18.0 * axles, 0.03 * tons, quadratic)
}

#[cfg(test)]
mod tests {
    use super::super::coefficients::tests::assert_newtons_per_tonne;

    #[test]
    fn benchmark_canadian_national_for_a_loaded_gondola_of_134_t() {
        let area = 105.0 * 0.3048 * 0.3048;
        let found = super::coefficients(134.0, 4.0, 4.2, area);
        assert_newtons_per_tonne(found, [9.75, 11.80, 14.31, 17.26, 20.67]);
    }
}
