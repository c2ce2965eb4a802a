//! The three coefficients that every formula of the propulsion resistance comes down to.

use std::ops::Mul;

/// Newtons in a pound of force.
const POUND: f64 = 4.448_221_615;
/// Tonnes in a short ton.
const SHORT_TON: f64 = 0.907_184_74;
/// Kilometres in a mile.
const MILE: f64 = 1.609_344;
/// Square feet in a square metre.
const SQUARE_FEET: f64 = 10.763_910_4;

/// Propulsion resistance `constant + linear V + quadratic V²` in N with the speed V in km/h.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coefficients {
    /// N.
    pub constant: f64,
    /// N/(km/h).
    pub linear: f64,
    /// N/(km/h)²; the part of the air.
    pub quadratic: f64,
}

impl Coefficients {
    /// Coefficients in pounds of force and miles per hour.
    pub fn imperial(constant: f64, linear: f64, quadratic: f64) -> Self {
        Self {
            constant: constant * POUND,
            linear: linear * POUND / MILE,
            quadratic: quadratic * POUND / (MILE * MILE),
        }
    }
}

impl Mul<Coefficients> for f64 {
    type Output = Coefficients;

    fn mul(self, coefficients: Coefficients) -> Coefficients {
        Coefficients {
            constant: self * coefficients.constant,
            linear: self * coefficients.linear,
            quadratic: self * coefficients.quadratic,
        }
    }
}

/// Short tons of a mass, t.
pub(super) fn short_tons(tonnes: f64) -> f64 {
    tonnes / SHORT_TON
}

/// Square feet of an area, m².
pub(super) fn square_feet(area: f64) -> f64 {
    area * SQUARE_FEET
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// Compares a wagon of 134 t with figures by hand, N/t at 0, 20, 40, 60 and 80 km/h.
    ///
    /// The tolerance is their rounding.
    pub(in crate::resistance) fn assert_newtons_per_tonne(c: Coefficients, expected: [f64; 5]) {
        for (i, expected) in expected.into_iter().enumerate() {
            let speed = 20.0 * i as f64;
            let found = (c.constant + speed * (c.linear + speed * c.quadratic)) / 134.0;
            assert!((found - expected).abs() < 0.01, "{found} N/t at {speed} km/h, not {expected}");
        }
    }

    /// The units by definition: a pound is 0.45359237 kg, a foot 0.3048 m; to the digits above.
    #[test]
    fn analytic_units_follow_from_pound_foot_and_standard_gravity() {
        let pound = 0.453_592_37;
        assert!((POUND / (pound * 9.80665) - 1.0).abs() < 1e-10);
        assert!((SHORT_TON / (pound * 2.0) - 1.0).abs() < 1e-15);
        assert!((MILE / (5280.0 * 0.3048e-3) - 1.0).abs() < 1e-15);
        assert!((SQUARE_FEET * 0.3048 * 0.3048 - 1.0).abs() < 1e-8);
    }
}
