//! The creep law by the exact theory against Kalker's tables and CONTACT, and its table against the
//! solver that made it.

use crate::{EUROSPRINTER_COULOMB, PAGE, creep_with_spin, eurosprinter, near};
use contact::kalker::CreepCoefficients;
use contact::rolling::recipe::{self, Ray};
use contact::{
    ContactPatch, CreepForces, CreepLaw, ExactRolling, FallingFriction, Reduction, STEEL,
    SlipVelocity,
};
use validation::{Bound, Row};

const SPEED: f64 = 10.0;

/// Kalker's tables as printed by his program, a sample; the head has the columns.
const KALKER: &str = include_str!("kalker-tables-sample.csv");

fn law(friction: f64) -> ExactRolling {
    ExactRolling::new(Reduction::NONE, FallingFriction::constant(friction))
}

/// Distance of the force from Kalker's, by mu N, of each row of the sample.
fn errors() -> Vec<f64> {
    let rows = KALKER.lines().filter(|line| line.starts_with(|first: char| first.is_ascii_digit()));
    let error = |row: &str| {
        let values: Vec<f64> = row.split(',').map(|value| value.parse().unwrap()).collect();
        let [a_over_b, ux, uy, phi, fx, fy] = values[..] else { panic!("{row}") };
        let (mu, normal_force, b) = (0.3, 80e3, 5e-3);
        let a = a_over_b * b;
        let kalker = CreepCoefficients::new(a_over_b, STEEL.poisson_ratio);
        let stiffness = STEEL.shear_modulus * a * b / (mu * normal_force);
        let slip = SlipVelocity {
            longitudinal: SPEED * 3.0 * ux / (stiffness * kalker.c11),
            lateral: SPEED * 3.0 * uy / (stiffness * kalker.c22),
            spin: SPEED * phi / (stiffness * (a * b).sqrt() * kalker.c23),
        };
        let patch = ContactPatch { normal_force, a, b, kalker };
        let found = law(mu).force(&patch, &slip, SPEED).force;
        let limit = mu * normal_force;
        (found.longitudinal / limit - fx).hypot(-found.lateral / limit - fy)
    };
    rows.map(error).collect()
}

/// The law by table against Kalker's exact tables: at most 1 % of mu N on average and 3 % anywhere.
///
/// Both have the error of their elements (Kalker's have 433), and this one that of the interpolation.
#[test]
fn benchmark_exact_rolling_by_kalkers_tables() {
    let errors = errors();
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    let most = errors.iter().fold(0.0_f64, |most, error| most.max(*error));
    for (case, value, allowed) in [
        ("exact rolling, distance from Kalker's tables, mean", mean, 0.01),
        ("exact rolling, distance from Kalker's tables, largest", most, 0.03),
    ] {
        Row {
            case,
            value,
            expected: 0.0,
            unit: "mu N",
            source: "Kalker's tables (CON93, nu 0.28), sample",
            tolerance: (allowed, "433 elements there, interpolation here"),
        }
        .holds(&PAGE);
    }
}

/// CONTACT's exact forces in longitudinal creep. Tolerance 1.5 % of mu N: the two grids, and the
/// interpolation.
#[test]
fn benchmark_exact_rolling_eurosprinter() {
    for (creepage, force) in EUROSPRINTER_COULOMB {
        let slip = SlipVelocity { longitudinal: SPEED * creepage, ..SlipVelocity::default() };
        let found = law(0.33).force(&eurosprinter(), &slip, SPEED).force.longitudinal;
        near(&format!("force in N at {creepage}"), found, force, 0.015 * 35_210.0);
    }
}

/// CONTACT's exact lateral force with spin (docs/reference/contact.md), where FASTSIM is 6 % off.
#[test]
fn benchmark_exact_rolling_lateral_creep_with_spin() {
    let (patch, slip) = creep_with_spin(SPEED);
    Row {
        case: "exact rolling by table, lateral creep with spin, force over mu N",
        value: law(0.3).force(&patch, &slip, SPEED).force.lateral / (0.3 * patch.normal_force),
        expected: -0.6074,
        unit: "1",
        source: "CONTACT, [contact](../reference/contact.md)",
        tolerance: (0.045, "grid of the table; fine grids have -0.625"),
    }
    .holds(&PAGE);
}

/// Small creepages give Kalker's linear forces. Tolerance 4 %: the outline of the contact in steps, and his
/// coefficients, which have three digits and are linear between a/b of tenths.
///
/// The moment by spin of slender contacts, which is small, is not compared (docs/known-errors.md).
#[test]
fn benchmark_exact_rolling_starts_with_kalker() {
    for a_over_b in [0.1, 0.3, 1.0, 3.0, 10.0] {
        let (b, normal_force) = (5e-3, 80e3);
        let kalker = CreepCoefficients::new(a_over_b, STEEL.poisson_ratio);
        let patch = ContactPatch { normal_force, a: a_over_b * b, b, kalker };
        let linear = CreepLaw::KalkerLinear;
        for (name, slip) in [
            ("longitudinal", SlipVelocity { longitudinal: 1.0, ..SlipVelocity::default() }),
            ("lateral", SlipVelocity { lateral: 1.0, ..SlipVelocity::default() }),
            ("spin", SlipVelocity { spin: 1.0, ..SlipVelocity::default() }),
        ] {
            let of = |forces: CreepForces| {
                let [x, y] = [forces.force.longitudinal, forces.force.lateral];
                [x.hypot(y), forces.spin_moment]
            };
            let whole = of(linear.force(&patch, &slip, SPEED));
            let reach = patch.a.hypot(patch.b);
            let scale = 0.003 * 0.3 * normal_force / (whole[0] + whole[1].abs() / reach);
            let slip = SlipVelocity {
                longitudinal: scale * slip.longitudinal,
                lateral: scale * slip.lateral,
                spin: scale * slip.spin,
            };
            let found = of(law(0.3).force(&patch, &slip, SPEED));
            let expected = of(linear.force(&patch, &slip, SPEED));
            let case = |what: &str| format!("{what} by {name} at a/b {a_over_b}");
            near(&case("force"), found[0], expected[0], 0.04 * expected[0].abs());
            if name == "lateral" {
                near(&case("moment"), found[1], expected[1], 0.06 * expected[1].abs());
            }
        }
    }
}

/// The shipped table is that of the recipe: its hash, and the nodes of rays that are solved anew.
///
/// Tolerance 1e-3 of a ratio: what the iteration leaves.
#[test]
fn property_shipped_table_follows_its_recipe() {
    assert!(recipe::shipped_is_whole(), "run cargo xtask creep-table");
    let rays = [Ray { direction: 3, spin: 5, shape: 2 }, Ray { direction: 6, spin: 11, shape: 7 }];
    for ray in rays {
        for size in [3, 12, 18] {
            let (solved, shipped) = (recipe::node(ray, size), recipe::shipped(ray, size));
            // The flash temperature of the first sizes is that of the next one.
            let ratios = if size < 10 { 6 } else { 8 };
            for (k, (solved, shipped)) in solved.into_iter().zip(shipped).take(ratios).enumerate() {
                let (solved, shipped) = (f64::from(solved), f64::from(shipped));
                near(&format!("{ray:?}, size {size}, ratio {k}"), shipped, solved, 1e-3);
            }
        }
    }
    Bound {
        case: "exact rolling, nodes of the table solved anew",
        limit: "1e-3 of a ratio",
        obtained: "holds",
    }
    .stands_in(&PAGE);
}
