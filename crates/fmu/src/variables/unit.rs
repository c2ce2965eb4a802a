//! Units of variables, as `UnitDefinitions` of a model description states them (§2.2.2).

use std::fmt::Display;

use serde::Serialize;

/// A unit: its symbol and its exponents of the SI base units.
///
/// A value in SI base units is `factor · value + offset`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Unit {
    /// Symbol as it stands in the attribute `unit`, such as `"m/s"`.
    pub symbol: &'static str,
    /// Exponent of the kilogram.
    pub kg: i8,
    /// Exponent of the metre.
    pub m: i8,
    /// Exponent of the second.
    pub s: i8,
    /// Exponent of the kelvin.
    pub kelvin: i8,
    /// Exponent of the radian.
    pub rad: i8,
    /// Factor to SI base units.
    pub factor: f64,
    /// Offset to SI base units.
    pub offset: f64,
}

impl Unit {
    /// A number, or words about one, with the unit after it; a ratio has none.
    pub(crate) fn after(self, number: impl Display) -> String {
        match self.symbol {
            "1" => number.to_string(),
            symbol => format!("{number} {symbol}"),
        }
    }
}

const fn si(symbol: &'static str, kg: i8, m: i8, s: i8, kelvin: i8, rad: i8) -> Unit {
    Unit { symbol, kg, m, s, kelvin, rad, factor: 1.0, offset: 0.0 }
}

/// A ratio without unit.
pub const ONE: Unit = si("1", 0, 0, 0, 0, 0);
/// Metre.
pub const METRE: Unit = si("m", 0, 1, 0, 0, 0);
/// Square metre.
pub const SQUARE_METRE: Unit = si("m2", 0, 2, 0, 0, 0);
/// One per metre (spin creepage, curvature).
pub const PER_METRE: Unit = si("1/m", 0, -1, 0, 0, 0);
/// Second.
pub const SECOND: Unit = si("s", 0, 0, 1, 0, 0);
/// Metre per second.
pub const METRE_PER_SECOND: Unit = si("m/s", 0, 1, -1, 0, 0);
/// Metre per second squared.
pub const METRE_PER_SECOND_SQUARED: Unit = si("m/s2", 0, 1, -2, 0, 0);
/// Kilogram.
pub const KILOGRAM: Unit = si("kg", 1, 0, 0, 0, 0);
/// Newton.
pub const NEWTON: Unit = si("N", 1, 1, -2, 0, 0);
/// Newton per metre (stiffness).
pub const NEWTON_PER_METRE: Unit = si("N/m", 1, 0, -2, 0, 0);
/// Newton second per metre (damping).
pub const NEWTON_SECOND_PER_METRE: Unit = si("N.s/m", 1, 0, -1, 0, 0);
/// Newton per metre and second (gain on the integral of a position).
pub const NEWTON_PER_METRE_SECOND: Unit = si("N/(m.s)", 1, 0, -3, 0, 0);
/// Newton metre.
pub const NEWTON_METRE: Unit = si("N.m", 1, 2, -2, 0, 0);
/// Joule.
pub const JOULE: Unit = si("J", 1, 2, -2, 0, 0);
/// Joule per metre (of rail).
pub const JOULE_PER_METRE: Unit = si("J/m", 1, 1, -2, 0, 0);
/// Watt.
pub const WATT: Unit = si("W", 1, 2, -3, 0, 0);
/// Watt per square metre.
pub const WATT_PER_SQUARE_METRE: Unit = si("W/m2", 1, 0, -3, 0, 0);
/// Watt per metre and kelvin (conductivity).
pub const WATT_PER_METRE_KELVIN: Unit = si("W/(m.K)", 1, 1, -3, -1, 0);
/// Watt per square metre and kelvin (heat transfer coefficient).
pub const WATT_PER_SQUARE_METRE_KELVIN: Unit = si("W/(m2.K)", 1, 0, -3, -1, 0);
/// Joule per kilogram and kelvin (specific heat).
pub const JOULE_PER_KILOGRAM_KELVIN: Unit = si("J/(kg.K)", 0, 2, -2, -1, 0);
/// Kilogram per cubic metre.
pub const KILOGRAM_PER_CUBIC_METRE: Unit = si("kg/m3", 1, -3, 0, 0, 0);
/// Joule per kelvin (heat capacity of a body).
pub const JOULE_PER_KELVIN: Unit = si("J/K", 1, 2, -2, -1, 0);
/// Watt per kelvin (thermal conductance).
pub const WATT_PER_KELVIN: Unit = si("W/K", 1, 2, -3, -1, 0);
/// One per kelvin (thermal expansion).
pub const PER_KELVIN: Unit = si("1/K", 0, 0, 0, -1, 0);
/// Pascal.
pub const PASCAL: Unit = si("Pa", 1, -1, -2, 0, 0);
/// Kelvin: temperatures and temperature differences.
pub const KELVIN: Unit = si("K", 0, 0, 0, 1, 0);
/// Radian.
pub const RADIAN: Unit = si("rad", 0, 0, 0, 0, 1);
/// Radian per second.
pub const RADIAN_PER_SECOND: Unit = si("rad/s", 0, 0, -1, 0, 1);
