//! Cole's modified Davis formula.
//!
//! ```text
//! r = K_a (2.943 + 89.2/m_a + 0.0306 V + 1.741 K V²/m)      N/t
//! ```
//!
//! with the axle load m_a and the mass m in t and the speed V in km/h; K as in `arema.rs`, whose
//! formula this is in metric units. The factor K_a is `factor` in the vehicle file: 1 for equipment
//! built before 1950, 0.85 after, 1.05 for hoppers, 1.9 for empty auto racks.
//!
//! Source: C. Cole, *Longitudinal train dynamics*, in S. Iwnicki (ed.), Handbook of Railway Vehicle
//! Dynamics, 2006, ch. 9. Range: freight trains on roller bearings.

use super::coefficients::Coefficients;

/// Coefficients for a mass, t, on axles, with the air coefficient K; without K_a.
pub fn coefficients(tonnes: f64, axles: f64, air: f64) -> Coefficients {
    Coefficients {
        constant: 2.943 * tonnes + 89.2 * axles,
        linear: 0.0306 * tonnes,
        quadratic: 1.741 * air,
    }
}

#[cfg(test)]
mod tests {
    use super::super::arema;
    use super::super::coefficients::tests::assert_newtons_per_tonne;

    #[test]
    fn benchmark_cole_for_a_wagon_of_134_t() {
        let found = super::coefficients(134.0, 4.0, 0.07);
        assert_newtons_per_tonne(found, [5.61, 6.58, 8.28, 10.72, 13.87]);
    }

    /// AREMA's formula, converted, within the rounding of Cole's coefficients, 1.5 %.
    #[test]
    fn benchmark_cole_is_arema_in_metric_units() {
        let (cole, arema) =
            (super::coefficients(80.0, 4.0, 0.16), arema::coefficients(80.0, 4.0, 0.16));
        let pairs = [
            (cole.constant, arema.constant),
            (cole.linear, arema.linear),
            (cole.quadratic, arema.quadratic),
        ];
        for (cole, arema) in pairs {
            assert!((cole / arema - 1.0).abs() < 0.015, "{cole}, AREMA {arema}");
        }
    }
}
