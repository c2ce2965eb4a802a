//! `hotfoot creep`.
//!
//! Signs are left out of the comparisons with closed forms, and have a test of their own.

use tools::creep::{CreepArguments, creep};

use crate::table::{Table, assert_near, refusal};

/// Shear modulus, N/m², and Poisson's ratio of rail steel, as the program has them.
const SHEAR_MODULUS: f64 = 82e9;
const POISSON_RATIO: f64 = 0.28;

/// A load of 100 kN on a round patch of 6 mm.
const ROUND: [&str; 5] = ["--load", "100000", "--semi-axes-mm", "6", "6"];

fn table(words: &[&str]) -> Table {
    Table::of::<CreepArguments>(creep, words)
}

fn on_round_patch(words: &[&str]) -> Table {
    table(&[&ROUND, words].concat())
}

fn refused(words: &[&str]) -> String {
    refusal::<CreepArguments>(creep, words)
}

#[test]
fn golden_columns() {
    let names = "longitudinal,lateral,spin_1_m,force_longitudinal_n,force_lateral_n,spin_moment_n_m,\
                 friction_power_w,flash_temperature_k";
    assert_eq!(on_round_patch(&[]).names(), names);
}

/// Coulomb: a wheel that slides has the force μ N, and turns μ N v ξ into heat. The table of exact
/// rolling is within 0.4 % there, the other laws within what they leave of their slope.
#[test]
fn analytic_a_sliding_wheel_has_the_friction_force() {
    for (law, tolerance) in [
        ("exact-rolling", 4e-3),
        ("fastsim-on-line", 4e-3),
        ("polach", 2e-2),
        ("shen-hedrick-elkins", 1e-6),
    ] {
        let words = ["--law", law, "--friction", "0.3", "--speed", "10", "--longitudinal", "0.5"];
        let table = on_round_patch(&words);
        assert_near(table.column("force_longitudinal_n")[0].abs(), 30e3, tolerance);
        assert_near(table.column("friction_power_w")[0], 150e3, tolerance);
    }
}

/// Kalker 1990, table E.3, a/b = 1: C11 = 4.12 and C22 = 3.67 at ν = 0.25, 5.20 and 3.81 at 0.5. Linear
/// between them, ν = 0.28 has 4.25 and 3.69; the rule between them may bend by 2 %.
#[test]
fn benchmark_small_creepages_have_kalkers_forces() {
    let stiffness = SHEAR_MODULUS * 6e-3 * 6e-3;
    let creepage = 1e-5;
    let linear = ["--law", "kalker-linear"];
    let along = on_round_patch(&[&linear[..], &["--longitudinal", "1e-5"]].concat());
    let across = on_round_patch(&[&linear[..], &["--lateral", "1e-5"]].concat());
    let c11 = along.column("force_longitudinal_n")[0].abs() / (stiffness * creepage);
    let c22 = across.column("force_lateral_n")[0].abs() / (stiffness * creepage);
    assert_near(c11, 4.25, 0.02);
    assert_near(c22, 3.69, 0.02);
}

/// Kalker's theory is linear: twice the creepage, twice the force, and four times the power.
#[test]
fn analytic_the_linear_law_is_linear() {
    let table = on_round_patch(&["--law", "kalker-linear", "--longitudinal", "0.001,0.002"]);
    let (force, power) = (table.column("force_longitudinal_n"), table.column("friction_power_w"));
    assert_near(force[1] / force[0], 2.0, 1e-6);
    assert_near(power[1] / power[0], 4.0, 1e-6);
}

/// Hertz 1882: equal radii R give a circle of a³ = 3 N R/(4 E*), E* = E/(2 (1 − ν²)) = G/(1 − ν) of two
/// equal bodies. With these semi-axes the forces are those by the radii.
#[test]
fn analytic_radii_give_hertzs_circle() {
    let (load, radius): (f64, f64) = (100e3, 0.4);
    let modulus = SHEAR_MODULUS / (1.0 - POISSON_RATIO);
    let semi_axis = (0.75 * load * radius / modulus).cbrt() * 1e3;
    let semi_axis = semi_axis.to_string();
    let creepage = ["--longitudinal", "0.001", "--lateral", "0.0005"];
    let by_radii = ["--load", "100000", "--radii-m", "0.4", "0.4"];
    let by_axes = ["--load", "100000", "--semi-axes-mm", &semi_axis, &semi_axis];
    let by_radii = table(&[&by_radii[..], &creepage].concat());
    let by_axes = table(&[&by_axes[..], &creepage].concat());
    for quantity in ["force_longitudinal_n", "force_lateral_n", "friction_power_w"] {
        // The elliptic integrals of the Hertzian contact are iterated.
        assert_near(by_radii.column(quantity)[0], by_axes.column(quantity)[0], 1e-3);
    }
}

/// Friction that falls to a share A of μ0 with e^(−B w): at 5 m/s of slip and B = 2 s/m it is A μ0.
#[test]
fn analytic_friction_falls_with_the_slip_velocity() {
    let falling = ["--friction", "0.4", "--limit-ratio", "0.5", "--decay", "2"];
    let sliding = ["--speed", "10", "--longitudinal", "0.5"];
    let table = on_round_patch(&[&falling[..], &sliding].concat());
    assert_near(table.column("force_longitudinal_n")[0].abs(), 20e3, 5e-3);
}

/// The creep force works against the slip, whichever way it goes: its power is lost.
#[test]
fn property_opposite_creepages_have_opposite_forces_and_equal_powers() {
    let table = on_round_patch(&["--longitudinal", "-0.002,0,0.002"]);
    let (force, power) = (table.column("force_longitudinal_n"), table.column("friction_power_w"));
    assert_eq!((force[0], force[1].abs()), (-force[2], 0.0));
    assert!(power[0] > 0.0 && power[0] == power[2] && power[1] == 0.0, "{power:?}");
    let flash = table.column("flash_temperature_k");
    assert!(flash[0] > 0.0 && flash[0] == flash[2] && flash[1] == 0.0, "{flash:?}");
}

#[test]
fn a_single_creepage_serves_for_all_rows() {
    let table = on_round_patch(&["--longitudinal", "0,0.001,0.002", "--lateral", "0.0005"]);
    assert_eq!(table.column("longitudinal"), [0.0, 0.001, 0.002]);
    assert_eq!(table.column("lateral"), [0.0005; 3]);
    assert_eq!(table.column("spin_1_m"), [0.0; 3]);
}

#[test]
fn wrong_options_are_answered_with_what_is_right() {
    for (words, wanted) in [
        (&["--load", "1e5"][..], "--semi-axes-mm"),
        (&["--semi-axes-mm", "6", "6"], "--load"),
        (&["--load", "0", "--semi-axes-mm", "6", "6"], "must be greater than zero"),
        (&["--load", "1e5", "--semi-axes-mm", "6", "0"], "must be greater than zero"),
        (
            &["--load", "1e5", "--semi-axes-mm", "6", "6", "--radii-m", "1", "1"],
            "cannot be used with",
        ),
        (&["--load", "100kN", "--semi-axes-mm", "6", "6"], "must be a number, without a unit"),
    ] {
        let message = refused(words);
        assert!(message.contains(wanted), "{words:?}: {message}");
    }
    for (words, wanted) in [
        (&["--friction", "0"][..], "must be greater than zero"),
        (&["--speed", "0"], "must be greater than zero"),
        (&["--law", "coulomb"], "possible values: exact-rolling"),
        (&["--reduction", "0", "1", "0"], "--reduction must be k0 greater than zero"),
        (&["--reduction", "1", "2", "0"], "alpha between 0 and 1"),
        (&["--factors", "0.3", "0.6"], "--factors must be kA not below kS"),
        (&["--longitudinal", "0,0.1", "--lateral", "0,0.1,0.2"], "must have the same length"),
        (&["--plot", "c.svg"], "a list of creepages that differ"),
    ] {
        let message = refused(&[&ROUND, words].concat());
        assert!(message.contains(wanted), "{words:?}: {message}");
    }
}
