//! Flash temperature and creep force.

use railheat::contact::{
    Contact, Friction, HERTZ_PEAK, Material, creep_force, flash_rise, kalker_c11,
};

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

/// Reference §1: five digits are given; the quadrature is good to more than seven.
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
        assert!((profile(s) - wanted).abs() < 6e-6, "at {s}: {}", profile(s));
    }
}

/// Reference §1: the constant of the code is the profile's maximum, at x = 0.6522295 a.
#[test]
fn analytic_flash_constant_is_the_maximum_of_the_profile() {
    let place = 0.652_229_5;
    assert!((profile(place) - HERTZ_PEAK).abs() < 2e-7);
    for other in [place - 1e-2, place + 1e-2] {
        assert!(profile(other) < HERTZ_PEAK);
    }
}

/// Reference §1 and §7.9: with equal steels the rise is 0.29474 F ξ √(v/a)/(b β), so that 2.5 N of
/// F ξ make 0.51 K at 60 km/h (stated to two digits).
#[test]
fn analytic_flash_rise_of_two_and_a_half_newtons() {
    let steel = Material::PAPER;
    let (a, b) = (CONTACT.a, CONTACT.b);
    let rise = flash_rise(&CONTACT, 2500.0, 0.001, SPEED, 0.5, &steel);
    assert!((rise - 0.51).abs() < 0.005, "{rise}");
    let coefficient = rise / (2.5 * (SPEED / a).sqrt() / (b * steel.penetration()));
    assert!((coefficient - 0.29474).abs() < 5e-6, "{coefficient}");
}

/// Ertz & Knothe, *Wear* 253 (2002) 498: their case in closed form is 150.30 K (reference §2.2,
/// five digits).
#[test]
fn benchmark_flash_rise_of_the_ertz_knothe_case() {
    let contact = Contact { normal_force: 100e3, a: 5.88e-3, b: 10.54e-3 };
    let steel = Material { conductivity: 50.0, ..Material::PAPER };
    let rise = flash_rise(&contact, 0.3 * 100e3, 1.0 / 30.0, 30.0, 0.5, &steel);
    assert!((rise - 150.30).abs() < 0.005, "{rise}");
}

/// Reference §1: the heat that a wheel really leaves in a metre of rail is
/// 1.6964 b β √(a/v) ΔT, 2.47 J/m per kelvin here (three digits).
#[test]
fn analytic_heat_per_metre_of_a_flash_temperature() {
    let steel = Material::PAPER;
    let (force, creepage) = (10e3, 0.002);
    let rise = flash_rise(&CONTACT, force, creepage, SPEED, 0.5, &steel);
    let per_kelvin = 0.5 * force * creepage / rise;
    let (a, b) = (CONTACT.a, CONTACT.b);
    let constant = per_kelvin / (b * steel.penetration() * (a / SPEED).sqrt());
    assert!((constant - 1.6964).abs() < 5e-5, "{constant}");
    assert!((per_kelvin - 2.47).abs() < 0.005, "{per_kelvin}");
}

/// CONTACT 24.1, exact half-space with Coulomb friction, locomotive Eurosprinter 127
/// (reference/vehicle.md 4.7, series 1). Polach's law with both factors 1 is known to be +4.0 to
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
        let error = force / wanted - 1.0;
        assert!(error.abs() < 0.065, "ξ = {creepage}: {force} N, {error}");
        assert_eq!(force, creep_force(&contact, -creepage, 0.33));
    }
}

/// Kalker's table at ν = 0.28 (reference/vehicle.md 4.3): the parabola's error is at most 1.7 %.
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
        let error = kalker_c11(ratio) / wanted - 1.0;
        assert!(error.abs() < 0.017, "a/b = {ratio}: {error}");
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
