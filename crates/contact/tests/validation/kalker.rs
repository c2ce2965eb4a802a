//! Kalker's coefficients.

use crate::{PAGE, near};
use contact::kalker::CreepCoefficients;
use validation::Row;

/// nu, a/b, C11, C22, C23 interpolated by CONTACT's rule from Kalker 1990, table E.3.
/// Tolerance: one unit in the last digit, as its print has not always rounded to the nearest.
#[test]
fn benchmark_kalker_interpolated() {
    let cases = [
        [0.30, 0.5, 3.813, 3.036, 0.954],
        [0.30, 1.0, 4.300, 3.729, 1.500],
        [0.30, 2.0, 5.275, 5.020, 2.682],
        [0.28, 0.5, 3.734, 3.026, 0.944],
        [0.28, 1.0, 4.226, 3.705, 1.488],
        [0.28, 2.0, 5.204, 4.972, 2.657],
    ];
    for [nu, ratio, c11, c22, c23] in cases {
        let c = CreepCoefficients::new(ratio, nu);
        let case = |what: &str| format!("{what} for nu {nu}, a/b {ratio}");
        near(&case("C11"), c.c11, c11, 1e-3);
        near(&case("C22"), c.c22, c22, 1e-3);
        near(&case("C23"), c.c23, c23, 1e-3);
    }
}

/// Kalker 1990, table E.3, as it stands: no interpolation, no tolerance but rounding.
#[test]
fn benchmark_kalker_table_rows() {
    for (nu, ratio, expected) in [
        (0.25, 0.1, [3.31, 2.52, 0.473, 8.28]),
        (0.0, 0.6, [2.98, 2.98, 0.930, 1.56]),
        (0.5, 1.0, [5.20, 3.98, 1.63, 1.16]),
        (0.25, 2.0, [5.10, 4.90, 2.62, 0.819]),
        (0.0, 10.0, [10.7, 10.7, 12.2, 0.795]),
    ] {
        let c = CreepCoefficients::new(ratio, nu);
        for (value, expected) in [c.c11, c.c22, c.c23, c.c33].into_iter().zip(expected) {
            near(&format!("nu {nu}, a/b {ratio}"), value, expected, 1e-9);
        }
    }
}

/// For a line contact short in the rolling direction C11 and C22 go to pi^2/(4 (1 - nu)) and pi^2/4
/// (Kalker 1990); at a/b = 1e-6 the rest of the table's correction is below 1e-5.
#[test]
fn analytic_kalker_line_contact() {
    let nu = 0.28;
    let c = CreepCoefficients::new(1e-6, nu);
    let limit = std::f64::consts::PI.powi(2) / 4.0;
    for (name, value, expected) in [("C11", c.c11, limit / (1.0 - nu)), ("C22", c.c22, limit)] {
        Row {
            case: &format!("Kalker, line contact, {name}"),
            value,
            expected,
            unit: "1",
            source: "Kalker 1990, asymptote",
            tolerance: (1e-4, "a/b of 1e-6"),
        }
        .holds(&PAGE);
    }
}

/// No jump anywhere from very long to very short ellipses: a change of a/b by 0.1 % changes no
/// coefficient by more than 0.3 % (C23 and C33 go with up to the 1.5th power of a/b).
#[test]
fn property_kalker_continuous() {
    let mut ratio = 0.01;
    let mut before = CreepCoefficients::new(ratio, 0.28);
    while ratio < 100.0 {
        ratio *= 1.001;
        let c = CreepCoefficients::new(ratio, 0.28);
        for (a, b) in
            [(before.c11, c.c11), (before.c22, c.c22), (before.c23, c.c23), (before.c33, c.c33)]
        {
            assert!(b > 0.0 && (b / a - 1.0).abs() < 3e-3, "{a} to {b} at a/b {ratio}");
        }
        before = c;
    }
}
