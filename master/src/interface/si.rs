//! Units as FMI 2.0 §2.2.2 and SSP 1.0 §4.4 state them: exponents of the SI base units, and the
//! linear way to them.

use std::fmt;

/// Exponents of kilogram, metre, second, ampere, kelvin, mole and candela.
///
/// The radian counts as one, as in the SI: some tools state it and some do not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Dimension(pub [i32; 7]);

/// Symbols of the base units in the order of the exponents.
const BASE_UNITS: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];

impl Dimension {
    /// Of mechanics: exponents of kilogram, metre and second.
    pub const fn mechanical(kg: i32, m: i32, s: i32) -> Self {
        Self([kg, m, s, 0, 0, 0, 0])
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts = BASE_UNITS.iter().zip(self.0).filter(|(_, exponent)| *exponent != 0);
        let parts: Vec<_> = parts
            .map(|(symbol, exponent)| match exponent {
                1 => (*symbol).to_owned(),
                _ => format!("{symbol}{exponent}"),
            })
            .collect();
        match parts.is_empty() {
            true => f.write_str("1"),
            false => f.write_str(&parts.join(".")),
        }
    }
}

/// A unit: a value x in it is `to_base.apply(x)` in SI base units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SiUnit {
    /// Exponents of the base units.
    pub dimension: Dimension,
    /// The way to base units.
    pub to_base: Linear,
}

impl SiUnit {
    /// The way of a value in this unit to the unit `other`; none where they measure different
    /// things.
    pub fn to(&self, other: &Self) -> Option<Linear> {
        (self.dimension == other.dimension).then(|| match self == other {
            true => Linear::IDENTITY,
            false => self.to_base.then(other.to_base.inverse()),
        })
    }
}

/// y = factor · x + offset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linear {
    /// Factor, never zero.
    pub factor: f64,
    /// Offset.
    pub offset: f64,
}

impl Linear {
    /// Leaves values as they are.
    pub const IDENTITY: Self = Self { factor: 1.0, offset: 0.0 };

    /// The value for `x`.
    pub fn apply(&self, x: f64) -> f64 {
        self.factor * x + self.offset
    }

    /// The way back.
    pub fn inverse(&self) -> Self {
        Self { factor: 1.0 / self.factor, offset: -self.offset / self.factor }
    }

    /// First this, then `next`.
    pub fn then(&self, next: Self) -> Self {
        Self { factor: next.factor * self.factor, offset: next.factor * self.offset + next.offset }
    }

    /// Whether values stay as they are.
    pub fn is_identity(&self) -> bool {
        *self == Self::IDENTITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit(dimension: Dimension, factor: f64, offset: f64) -> SiUnit {
        SiUnit { dimension, to_base: Linear { factor, offset } }
    }

    /// Definitions: 36 km/h are 10 m/s; 25 °C are 298.15 K and 77 °F; tolerance: rounding.
    #[test]
    fn analytic_speeds_and_temperatures_are_converted_both_ways() {
        let speed = Dimension::mechanical(0, 1, -1);
        let (km_per_h, m_per_s) = (unit(speed, 1.0 / 3.6, 0.0), unit(speed, 1.0, 0.0));
        assert!((km_per_h.to(&m_per_s).unwrap().apply(36.0) - 10.0).abs() < 1e-12);
        assert!((m_per_s.to(&km_per_h).unwrap().apply(10.0) - 36.0).abs() < 1e-12);

        let kelvin = Dimension([0, 0, 0, 0, 1, 0, 0]);
        let celsius = unit(kelvin, 1.0, 273.15);
        let fahrenheit = unit(kelvin, 5.0 / 9.0, 273.15 - 32.0 * 5.0 / 9.0);
        assert!((celsius.to_base.apply(25.0) - 298.15).abs() < 1e-12);
        assert!((celsius.to(&fahrenheit).unwrap().apply(25.0) - 77.0).abs() < 1e-9);
    }

    #[test]
    fn equal_units_leave_every_bit_and_different_ones_do_not_meet() {
        let degree = unit(Dimension::default(), 0.1, 0.0);
        assert!(degree.to(&degree).unwrap().is_identity());
        assert_eq!(degree.to(&unit(Dimension::mechanical(1, 1, -2), 1.0, 0.0)), None);
    }

    #[test]
    fn a_dimension_reads_like_a_unit() {
        assert_eq!(Dimension::mechanical(1, 1, -2).to_string(), "kg.m.s-2");
        assert_eq!(Dimension::default().to_string(), "1");
    }
}
