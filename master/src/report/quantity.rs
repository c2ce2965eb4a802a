//! Numbers with SI prefixes.

/// A prefix that keeps the numbers of an axis or a table between 1 and 1000.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Prefix {
    /// What one of the prefixed unit is in the unit.
    pub factor: f64,
    /// Symbol of the prefix.
    pub symbol: &'static str,
}

const PREFIXES: [(f64, &str); 7] =
    [(1e-9, "n"), (1e-6, "µ"), (1e-3, "m"), (1.0, ""), (1e3, "k"), (1e6, "M"), (1e9, "G")];

impl Prefix {
    /// The prefix for numbers up to `largest`.
    pub fn of(largest: f64) -> Self {
        let fits = |&&(factor, _): &&(f64, &str)| factor <= largest.abs() * (1.0 + 1e-12);
        let (factor, symbol) = match largest == 0.0 || !largest.is_finite() {
            true => (1.0, ""),
            false => *PREFIXES.iter().rev().find(fits).unwrap_or(&PREFIXES[0]),
        };
        Self { factor, symbol }
    }
}

/// A number with three significant digits and its unit, such as `173 kN`.
pub(super) fn with_unit(value: f64, unit: &str) -> String {
    let prefix = Prefix::of(value);
    let number = value / prefix.factor;
    let decimals = match number.abs() {
        n if n >= 100.0 || n == 0.0 => 0,
        n if n >= 10.0 => 1,
        _ => 2,
    };
    format!("{number:.decimals$} {}{unit}", prefix.symbol)
}

/// A number as an axis shows it: only the digits that tell neighbouring ticks of a span apart.
pub(super) fn tick(value: f64, span: f64) -> String {
    let decimals = (2.0 - span.log10()).ceil().clamp(0.0, 6.0) as usize;
    let text = format!("{value:.decimals$}");
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    match text.strip_prefix('-') {
        Some("0") => "0".to_owned(),
        Some(digits) => format!("−{digits}"),
        None => text.to_owned(),
    }
}

/// A text with a proper minus before its numbers, as pages have it.
pub(super) fn with_minus(text: &str) -> String {
    let mut typed = String::with_capacity(text.len());
    let mut before = ' ';
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        let is_sign = letter == '-'
            && before.is_whitespace()
            && letters.peek().is_some_and(char::is_ascii_digit);
        typed.push(if is_sign { '−' } else { letter });
        before = letter;
    }
    typed
}

/// A round number with its unit, such as `10 mK`.
pub(super) fn round_with_unit(value: f64, unit: &str) -> String {
    let prefix = Prefix::of(value);
    let number = value / prefix.factor;
    format!("{} {}{unit}", tick(number, number.abs()), prefix.symbol)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_get_the_prefix_that_suits_them() {
        assert_eq!(with_unit(173_210.0, "N"), "173 kN");
        assert_eq!(with_unit(-0.001_234, "m"), "-1.23 mm");
        assert_eq!(with_unit(0.0, "K"), "0 K");
        assert_eq!(with_unit(0.015, "K"), "15.0 mK");
        assert_eq!(with_unit(4e-12, "K"), "0.00 nK");
        assert_eq!(round_with_unit(0.01, "K"), "10 mK");
    }

    #[test]
    fn only_numbers_have_a_minus() {
        assert_eq!(with_minus("-984 N"), "−984 N");
        assert_eq!(with_minus("chainage -1.9 m at 4 s"), "chainage −1.9 m at 4 s");
        assert_eq!(with_minus("in 2026-11-30 a-b, 9e-12 - 1"), "in 2026-11-30 a-b, 9e-12 - 1");
    }

    #[test]
    fn ticks_have_no_more_digits_than_they_need() {
        assert_eq!(tick(50.0, 200.0), "50");
        assert_eq!(tick(-0.25, 1.0), "−0.25");
        assert_eq!(tick(17.5, 3.0), "17.5");
        assert_eq!(tick(-1e-17, 2.0), "0");
    }
}
