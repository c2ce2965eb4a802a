//! Hertz contact.

use crate::{PAGE, near};
use contact::{STEEL, hertz::UnitContact};
use validation::Row;

/// theta in degrees and the classical coefficients m, n, r, computed independently with exact
/// elliptic integrals (Johnson, Contact Mechanics, 4.2; printed tables in books differ in the third figure).
const EXACT: [[f64; 4]; 21] = [
    [2.0, 22.2432, 0.1692, 0.1793],
    [4.0, 13.2925, 0.2189, 0.2631],
    [6.0, 9.7883, 0.2552, 0.3274],
    [8.0, 7.8560, 0.2851, 0.3812],
    [10.0, 6.6115, 0.3110, 0.4280],
    [15.0, 4.8077, 0.3657, 0.5253],
    [20.0, 3.8160, 0.4121, 0.6038],
    [25.0, 3.1788, 0.4540, 0.6698],
    [30.0, 2.7306, 0.4931, 0.7263],
    [35.0, 2.3961, 0.5306, 0.7752],
    [40.0, 2.1357, 0.5673, 0.8177],
    [45.0, 1.9265, 0.6038, 0.8547],
    [50.0, 1.7541, 0.6407, 0.8867],
    [55.0, 1.6094, 0.6783, 0.9143],
    [60.0, 1.4858, 0.7171, 0.9376],
    [65.0, 1.3788, 0.7575, 0.9570],
    [70.0, 1.2851, 0.7999, 0.9726],
    [75.0, 1.2020, 0.8448, 0.9847],
    [80.0, 1.1278, 0.8927, 0.9932],
    [85.0, 1.0609, 0.9442, 0.9983],
    [90.0, 1.0, 1.0, 1.0],
];

/// Tolerance: half of the table's last digit.
#[test]
fn benchmark_hertz_exact_table() {
    let modulus = STEEL.contact_modulus();
    for [theta, m, n, r] in EXACT {
        let cosine = theta.to_radians().cos();
        let contact = UnitContact::new(0.5 * (1.0 - cosine), 0.5 * (1.0 + cosine), &STEEL);
        let length = (3.0 / (4.0 * modulus)).cbrt();
        let approach = (9.0 / (16.0 * modulus * modulus)).cbrt();
        let case = |what: &str| format!("{what} at theta {theta}");
        near(&case("m"), contact.semi_axis_rolling / length, m, 5.1e-5);
        near(&case("n"), contact.semi_axis_lateral / length, n, 5.1e-5);
        near(&case("r"), contact.approach(1.0) / approach, r, 5.1e-5);
    }
}

/// CONTACT, Eurosprinter example (docs/reference/contact.md): A 0.8, B 0.2814 per metre, N 106.7 kN.
/// Tolerance: the four printed digits; the pressure is of CONTACT's grid, good to 0.1 %.
#[test]
fn benchmark_hertz_contact_eurosprinter() {
    let load: f64 = 106_700.0;
    let contact = UnitContact::new(0.8, 0.2814, &STEEL);
    let a = contact.semi_axis_rolling * load.cbrt();
    let b = contact.semi_axis_lateral * load.cbrt();
    let row = |what: &str, value: f64, expected: f64, unit: &str, tolerance: (f64, &str)| {
        let case = &format!("Hertz, Eurosprinter, {what}");
        let source = "CONTACT, Eurosprinter, [contact](../reference/contact.md)";
        Row { case, value, expected, unit, source, tolerance }.holds(&PAGE);
    };
    let figures = "four figures of the source";
    row("semi-axis a", 1e3 * a, 6.304, "mm", (1e-3, figures));
    row("semi-axis b", 1e3 * b, 12.61, "mm", (5e-3, figures));
    row("approach", 1e3 * contact.approach(load), 0.07651, "mm", (1e-5, figures));
    let pressure = 1.5 * load / (std::f64::consts::PI * a * b);
    row("largest pressure", 1e-6 * pressure, 640.7, "MPa", (0.64, "the grid of the source"));
}

/// Load and approach are inverse to each other, and a wheel above the rail carries nothing.
#[test]
fn property_hertz_load_and_approach_are_inverse() {
    let contact = UnitContact::new(1.0, 0.3, &STEEL);
    for load in [1.0, 1e3, 1e5] {
        near("load", contact.normal_force(contact.approach(load)), load, 1e-12 * load);
    }
    assert_eq!(contact.normal_force(-1e-3), 0.0);
    assert_eq!(contact.approach(-1e3), 0.0);
}
