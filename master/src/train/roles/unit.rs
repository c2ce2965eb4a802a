//! Units of the exchange.

use crate::interface::si::Dimension;
use crate::system::port::SignalUnit;

const fn of(symbol: &'static str, kg: i32, m: i32, s: i32) -> SignalUnit {
    SignalUnit { symbol, dimension: Dimension::mechanical(kg, m, s) }
}

pub const ONE: SignalUnit = of("1", 0, 0, 0);
pub const METRE: SignalUnit = of("m", 0, 1, 0);
pub const PER_METRE: SignalUnit = of("1/m", 0, -1, 0);
pub const METRE_PER_SECOND: SignalUnit = of("m/s", 0, 1, -1);
pub const METRE_PER_SECOND_SQUARED: SignalUnit = of("m/s2", 0, 1, -2);
pub const NEWTON: SignalUnit = of("N", 1, 1, -2);
pub const WATT: SignalUnit = of("W", 1, 2, -3);
