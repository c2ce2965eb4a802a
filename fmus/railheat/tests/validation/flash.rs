//! Flash temperature and creep force.

use railheat::contact::{
    Contact, Friction, HERTZ_PEAK, Material, creep_force, flash_rise, kalker_c11,
};

use validation::Row;

use crate::PAGE;
use crate::common::{CONTACT, SPEED};

/// Rise behind a semi-elliptic flux at x = s a behind the middle, in units of ε (q₀/β) √(a/v):
/// f(s) = ∫ √(1-u²)/√(s-u) du / √π from -1 to min(s, 1), by the midpoint rule after substitutions
/// that take the root singularities away.
fn profile(s: f64) -> f64 {
    let (from, to) = ((s - 1.0).max(0.0).sqrt(), (s + 1.0).sqrt());
    let points = 20_000;
    let sum: f64 = (0..points)
        .map(|i| {
            let p = (f64::from(i) + 0.5) / f64::from(points);
            let w = from + (to - from) * p * p * (3.0 - 2.0 * p);
            let weight = (to - from) * 6.0 * p * (1.0 - p) / f64::from(points);
            let u = s - w * w;
            2.0 * (1.0 - u * u).max(0.0).sqrt() * weight
        })
        .sum();
    sum / std::f64::consts::PI.sqrt()
}

/// `docs/reference/conduction.md`: five digits are given; the quadrature is good to more than seven.
#[test]
fn analytic_flash_profile_of_a_hertz_contact() {
    for (s, wanted) in [
        (-0.8, 0.24106),
        (-0.6, 0.46200),
        (-0.2, 0.83686),
        (0.0, 0.98623),
        (0.4, 1.19074),
        (0.8, 1.21452),
        (1.0, 1.06385),
        (1.5, 0.76019),
        (2.0, 0.64289),
        (10.0, 0.28051),
    ] {
        Row {
            case: &format!("rise behind a Hertz contact, {s} a behind its middle"),
            value: profile(s),
            expected: wanted,
            unit: "ε q₀/β √(a/v)",
            source: "closed form, docs/reference/conduction.md",
            tolerance: (6e-6, "five digits are given"),
        }
        .holds(&PAGE);
    }
}

/// `docs/reference/conduction.md`: the constant of the code is the profile's maximum, at x = 0.6522295 a.
#[test]
fn analytic_flash_constant_is_the_maximum_of_the_profile() {
    let peak = 0.652_229_5;
    Row {
        case: "highest rise behind a Hertz contact",
        value: HERTZ_PEAK,
        expected: profile(peak),
        unit: "ε q₀/β √(a/v)",
        source: "maximum of the closed form, by quadrature",
        tolerance: (2e-7, "digits of the constant"),
    }
    .holds(&PAGE);
    for other in [peak - 1e-2, peak + 1e-2] {
        assert!(profile(other) < HERTZ_PEAK);
    }
}

/// `docs/reference/conduction.md`: with equal steels the rise is 0.29474 F ξ √(v/a)/(b β), so that 2.5 N of
/// F ξ make 0.51 K at 60 km/h (stated to two digits).
#[test]
fn analytic_flash_rise_of_two_and_a_half_newtons() {
    let steel = Material::PAPER;
    let (a, b) = (CONTACT.a, CONTACT.b);
    let rise = flash_rise(&CONTACT, 2500.0, 0.001, SPEED, 0.5, &steel);
    Row {
        case: "flash rise by 2.5 N of force times creepage at 60 km/h",
        value: rise,
        expected: 0.51,
        unit: "K",
        source: "closed form, docs/reference/conduction.md",
        tolerance: (0.005, "two digits are given"),
    }
    .holds(&PAGE);
    let coefficient = rise / (2.5 * (SPEED / a).sqrt() / (b * steel.penetration()));
    Row {
        case: "flash rise over F ξ √(v/a)/(b β) with equal steels",
        value: coefficient,
        expected: 0.29474,
        unit: "1",
        source: "half of 0.58949, docs/reference/conduction.md",
        tolerance: (5e-6, "five digits are given"),
    }
    .holds(&PAGE);
}

/// Ertz & Knothe, *Wear* 253 (2002) 498: their case in closed form is 150.30 K (`docs/reference/conduction.md`,
/// five digits).
#[test]
fn benchmark_flash_rise_of_the_ertz_knothe_case() {
    let contact = Contact { normal_force: 100e3, a: 5.88e-3, b: 10.54e-3 };
    let steel = Material { conductivity: 50.0, ..Material::PAPER };
    let rise = flash_rise(&contact, 0.3 * 100e3, 1.0 / 30.0, 30.0, 0.5, &steel);
    Row {
        case: "flash rise of the Ertz-Knothe case by its creep force",
        value: rise,
        expected: 150.30,
        unit: "K",
        source: "Ertz and Knothe, Wear 253 (2002) 498",
        tolerance: (0.005, "five digits are given"),
    }
    .holds(&PAGE);
}

/// `docs/reference/conduction.md`: the heat that a wheel really leaves in a metre of rail is
/// 1.6964 b β √(a/v) ΔT, 2.47 J/m per kelvin here (three digits).
#[test]
fn analytic_heat_per_metre_of_a_flash_temperature() {
    let steel = Material::PAPER;
    let (force, creepage) = (10e3, 0.002);
    let rise = flash_rise(&CONTACT, force, creepage, SPEED, 0.5, &steel);
    let per_kelvin = 0.5 * force * creepage / rise;
    let (a, b) = (CONTACT.a, CONTACT.b);
    let constant = per_kelvin / (b * steel.penetration() * (a / SPEED).sqrt());
    let source = "closed form, docs/reference/conduction.md";
    Row {
        case: "heat per metre over b β √(a/v) and kelvin of flash rise",
        value: constant,
        expected: 1.6964,
        unit: "1",
        source,
        tolerance: (5e-5, "five digits are given"),
    }
    .holds(&PAGE);
    Row {
        case: "heat per metre and kelvin of flash rise at 60 km/h",
        value: per_kelvin,
        expected: 2.47,
        unit: "J/(m K)",
        source,
        tolerance: (0.005, "three digits are given"),
    }
    .holds(&PAGE);
}

/// CONTACT 24.1, exact half-space with Coulomb friction, locomotive Eurosprinter 127
/// (`docs/reference/contact.md`, series 1). Polach's law with both factors 1 is known to be +4.0 to
/// -6.2 % off; the parabola for C₁₁ adds its own 1.1 % where the force is linear.
#[test]
fn benchmark_creep_force_against_contact() {
    let contact = Contact { normal_force: 106_700.0, a: 6.304e-3, b: 12.61e-3 };
    for (creepage, wanted) in [
        (1e-5, 247.0),
        (0.0004, 9112.0),
        (0.0012, 22_820.0),
        (0.002, 31_040.0),
        (0.0028, 34_620.0),
        (0.0044, 35_190.0),
        (0.006, 35_200.0),
        (0.03, 35_210.0),
        (0.25, 35_210.0),
    ] {
        let force = creep_force(&contact, creepage, 0.33);
        Row {
            case: &format!("creep force at a creepage of {creepage}"),
            value: force,
            expected: wanted,
            unit: "N",
            source: "CONTACT, Eurosprinter, series 1 (docs/reference/contact.md)",
            tolerance: (0.065 * wanted, "Polach's law, +4.0 to -6.2 %"),
        }
        .holds(&PAGE);
        assert_eq!(force, creep_force(&contact, -creepage, 0.33));
    }
}

/// Kalker 1990, table E.3, at ν = 0.28: the parabola's error is at most 1.7 %.
#[test]
fn benchmark_kalker_coefficient() {
    for (ratio, wanted) in [
        (0.1, 3.441),
        (0.3, 3.561),
        (0.5, 3.734),
        (1.0, 4.226),
        (2.0, 5.204),
        (5.0, 7.892),
        (10.0, 11.83),
    ] {
        Row {
            case: &format!("Kalker's coefficient C₁₁, ν = 0.28, a/b = {ratio}"),
            value: kalker_c11(ratio),
            expected: wanted,
            unit: "1",
            source: "Kalker 1990, table E.3",
            tolerance: (0.017 * wanted, "error of the parabola, 1.7 %"),
        }
        .holds(&PAGE);
    }
}

#[test]
fn property_a_lifted_or_resting_wheel_heats_nothing() {
    let steel = Material::PAPER;
    let lifted = Contact::default();
    assert_eq!(Friction::PAPER.rise(&lifted, 0.01, SPEED, &steel), 0.0);
    assert_eq!(Friction::PAPER.rise(&CONTACT, 0.0, SPEED, &steel), 0.0);
    assert_eq!(Friction::PAPER.rise(&CONTACT, 0.01, 0.0, &steel), 0.0);
    let forward = Friction::PAPER.rise(&CONTACT, 0.01, SPEED, &steel);
    assert_eq!(Friction::PAPER.rise(&CONTACT, -0.01, -SPEED, &steel), forward);
}
