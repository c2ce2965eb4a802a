//! Equivalent conicity of EN 15302, annex E (UIC 519): reference wheels A and B on rail A.
//!
//! Points and conicities are those of the public transcriptions criogenox/A_WRCC-Wheel-Rail-Contact-
//! Characterization and criogenox/B_ECC (MIT); the standard's own text has the same reference profiles.

use crate::PAGE;
use contact::{EquivalentConicity, ProfilePair, RailProfile, WheelProfile, WheelsetPairs};
use validation::{Bound, Row};

const MM: f64 = 1e-3;

/// Amplitude in mm, conicity, and its greatest and least value, of each case.
const ANNEX_E: &str = include_str!("en15302/en15302-annex-e.csv");

/// Amplitude in mm, conicity, its greatest and least value.
fn annex_e(case: &str) -> Vec<[f64; 4]> {
    let begin = format!("{case},");
    let rows = ANNEX_E.lines().filter_map(|line| line.strip_prefix(&begin));
    let numbers =
        |row: &str| row.split(',').map(|number| number.parse().unwrap()).collect::<Vec<_>>();
    rows.map(|row| numbers(row).try_into().unwrap()).collect()
}

/// Wheels of 920 mm on upright rails, 1435.16 mm apart.
fn pair(wheel: &str) -> ProfilePair {
    let file =
        |name: &str| format!("{}/tests/validation/en15302/{name}", env!("CARGO_MANIFEST_DIR"));
    let (wheel, rail) = (file(wheel), file("SUIC519A.dat"));
    ProfilePair {
        gauge: 1.43516,
        ..ProfilePair::standard_gauge(
            WheelProfile::named(&wheel).unwrap(),
            RailProfile::named(&rail).unwrap(),
            0.0,
            0.460,
        )
    }
}

/// Every amplitude of the table lies in its band, which the standard gives for programs: 0.05, or half
/// of the conicity.
#[test]
fn benchmark_en_15302_annex_e() {
    for (case, wheel) in [("E1", "RUIC519A.dat"), ("E2", "RUIC519B.dat")] {
        let conicity =
            EquivalentConicity::new(&WheelsetPairs::alike(&pair(wheel)), 7.5 * MM).unwrap();
        let mut worst = 0.0_f64;
        for [amplitude, expected, greatest, least] in annex_e(case) {
            let found = conicity.at(amplitude * MM).unwrap();
            let band = if found > expected { greatest - expected } else { expected - least };
            worst = worst.max((found - expected).abs() / band);
            assert!(
                (least..=greatest).contains(&found),
                "{case}: {found} at {amplitude} mm, the band is {least} to {greatest}"
            );
            if [2.0, 5.0, 7.0].contains(&amplitude) {
                Row {
                    case: &format!("equivalent conicity, {case}, amplitude {amplitude} mm"),
                    value: found,
                    expected,
                    unit: "1",
                    source: "EN 15302, annex E",
                    tolerance: (band, "the standard's band"),
                }
                .holds(&PAGE);
            }
        }
        Bound {
            case: &format!(
                "equivalent conicity, {case}, 1 to 7.5 mm, share of the standard's band"
            ),
            limit: "below 1",
            obtained: &format!("{worst:.2}"),
        }
        .stands_in(&PAGE);
    }
}

/// A cone of 1:20 has its own conicity, whatever the rail, since its wheels do not roll aside.
#[test]
fn analytic_a_cone_has_its_own_conicity() {
    let pair = crate::pair("cone-1-20", "60E1");
    let conicity = EquivalentConicity::new(&WheelsetPairs::alike(&pair), 3.0 * MM).unwrap();
    for amplitude in [0.5, 1.0, 3.0] {
        let case = format!("equivalent conicity of a cone 1:20, amplitude {amplitude} mm");
        Row {
            case: &case,
            value: conicity.at(amplitude * MM).unwrap(),
            expected: 0.05,
            unit: "1",
            source: "Klingel 1883",
            tolerance: (2e-6, "the rail is sampled every 0.01 mm"),
        }
        .holds(&PAGE);
    }
}

/// Cones 1:20 whose radii differ by 0.2 mm swing about 2 mm beside the middle, where they are equal, with
/// the conicity of the cone.
#[test]
fn analytic_cones_of_unequal_radii_keep_their_conicity() {
    let right = crate::pair("cone-1-20", "60E1");
    let left = ProfilePair { nominal_radius: right.nominal_radius + 0.2 * MM, ..right.clone() };
    let conicity = EquivalentConicity::new(&WheelsetPairs { left, right }, 3.0 * MM).unwrap();
    assert!((conicity.of_radii_at(2.0 * MM).unwrap()).abs() < 1e-6);
    Row {
        case: "equivalent conicity of cones 1:20 whose radii differ by 0.2 mm, amplitude 2 mm",
        value: conicity.at(2.0 * MM).unwrap(),
        expected: 0.05,
        unit: "1",
        source: "Klingel 1883",
        tolerance: (2e-6, "the rail is sampled every 0.01 mm"),
    }
    .holds(&PAGE);
}
