//! Units that measurements have, in SI.

/// A unit as it is written, its SI unit, what one of it is in that, and where its zero lies.
const UNITS: [(&str, &str, f64, f64); 24] = [
    ("km/h", "m/s", 1.0 / 3.6, 0.0),
    ("mph", "m/s", 0.447_04, 0.0),
    ("kN", "N", 1e3, 0.0),
    ("MN", "N", 1e6, 0.0),
    ("kW", "W", 1e3, 0.0),
    ("MW", "W", 1e6, 0.0),
    ("kJ", "J", 1e3, 0.0),
    ("MJ", "J", 1e6, 0.0),
    ("kWh", "J", 3.6e6, 0.0),
    ("mm", "m", 1e-3, 0.0),
    ("cm", "m", 1e-2, 0.0),
    ("km", "m", 1e3, 0.0),
    ("t", "kg", 1e3, 0.0),
    ("kPa", "Pa", 1e3, 0.0),
    ("MPa", "Pa", 1e6, 0.0),
    ("bar", "Pa", 1e5, 0.0),
    ("mK", "K", 1e-3, 0.0),
    ("°C", "K", 1.0, 273.15),
    ("degC", "K", 1.0, 273.15),
    ("%", "1", 1e-2, 0.0),
    ("‰", "1", 1e-3, 0.0),
    ("deg", "rad", 0.017_453_292_519_943_295, 0.0),
    ("ms", "s", 1e-3, 0.0),
    ("min", "s", 60.0, 0.0),
];

/// Factor and offset that take a measured value into the SI unit `wanted`; none for another quantity.
///
/// A value without a unit is in SI.
pub(super) fn conversion(measured: Option<&str>, wanted: &str) -> Option<(f64, f64)> {
    match measured {
        None => Some((1.0, 0.0)),
        Some(unit) if unit == wanted => Some((1.0, 0.0)),
        Some(unit) => {
            let mut fitting =
                UNITS.iter().filter(|(written, si, ..)| *written == unit && *si == wanted);
            fitting.next().map(|(_, _, factor, offset)| (*factor, *offset))
        }
    }
}

/// The units from which a value can be taken into an SI unit, for a message.
pub(super) fn known(wanted: &str) -> String {
    let fitting = UNITS.iter().filter(|(_, si, ..)| *si == wanted).map(|(written, ..)| *written);
    std::iter::once(wanted).chain(fitting).collect::<Vec<_>>().join(", ")
}

/// A name of a column and the unit behind it: `speed [km/h]` or `speed (km/h)`.
pub(super) fn name_and_unit(written: &str) -> (&str, Option<&str>) {
    for (open, close) in [('[', ']'), ('(', ')')] {
        let inner = written.strip_suffix(close).and_then(|rest| rest.rsplit_once(open));
        if let Some((name, unit)) = inner
            && name.ends_with(' ')
        {
            return (name.trim_end(), Some(unit.trim()));
        }
    }
    (written, None)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn benchmark_units_are_those_of_the_si_brochure() {
        assert_eq!(conversion(Some("km/h"), "m/s").map(|(factor, _)| 36.0 * factor), Some(10.0));
        assert_eq!(conversion(Some("°C"), "K"), Some((1.0, 273.15)));
        assert_eq!(conversion(Some("kN"), "m/s"), None);
        assert_eq!(conversion(None, "Pa"), Some((1.0, 0.0)));
    }

    #[test]
    fn a_unit_stands_in_brackets_behind_a_space() {
        assert_eq!(name_and_unit("speed [km/h]"), ("speed", Some("km/h")));
        assert_eq!(name_and_unit("force (kN)"), ("force", Some("kN")));
        assert_eq!(name_and_unit("vehicles[1].velocity"), ("vehicles[1].velocity", None));
        assert_eq!(name_and_unit("vehicles[1]"), ("vehicles[1]", None));
    }
}
