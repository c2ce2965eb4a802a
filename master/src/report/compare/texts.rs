//! Differences as people read them.

use crate::report::quantity::with_unit;

/// A difference with its unit; plain numbers have no prefix.
pub(super) fn shown(value: f64, unit: &str) -> String {
    match unit {
        _ if !value.is_finite() => "–".to_owned(),
        "1" | "" => significant(value),
        // A prefix would stand before the 1.
        unit if unit.starts_with("1/") => format!("{} {unit}", significant(value)),
        unit => with_unit(value, unit),
    }
}

/// A number with three digits.
fn significant(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size if (1e-3..1e5).contains(&size) => {
            let decimals = (2.0 - size.log10().floor()).max(0.0) as usize;
            format!("{value:.decimals$}")
        }
        _ => format!("{value:.2e}"),
    }
}

/// A part in percent.
pub(super) fn percent(part: f64) -> String {
    match part.is_finite() {
        false => "–".to_owned(),
        true if part == 0.0 => "0 %".to_owned(),
        true if part < 1e-4 => format!("{:.1e} %", 100.0 * part),
        true if part < 0.1 => format!("{:.3} %", 100.0 * part),
        true => format!("{:.1} %", 100.0 * part),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_have_three_digits_and_a_prefix() {
        assert_eq!(shown(-1234.0, "N"), "-1.23 kN");
        assert_eq!(shown(0.001234, "1"), "0.00123");
        assert_eq!(shown(12.0, "1"), "12.0");
        assert_eq!(shown(f64::INFINITY, "N"), "–");
        assert_eq!(shown(-0.227, "1/m"), "-0.227 1/m");
        assert_eq!(percent(0.0), "0 %");
        assert_eq!(percent(1.566_4), "156.6 %");
        assert_eq!(percent(0.012345), "1.234 %");
        assert_eq!(percent(1e-7), "1.0e-5 %");
    }
}
