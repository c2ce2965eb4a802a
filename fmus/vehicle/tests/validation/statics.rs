//! "Reference set" is the representative Co-Co locomotive of `stock/vehicles`, for which the same
//! quantities were computed by a separate linear program (docs/reference/locomotive.md): loads, modes, weight transfer,
//! steady lateral acceleration.

use crate::common::*;
use numerics::constants::STANDARD_GRAVITY;
use vehicle::dynamics::inputs::Inputs;
use vehicle::linear;

/// Static wheel loads: 134 t x 9.80665 m/s² / 12 = 109.5 kN (vertical; the contact is inclined by
/// 1.7 degrees). Exact up to the equilibrium's own tolerance of 1e-7 m/s²; symmetric to rounding.
#[test]
fn analytic_static_wheel_loads() {
    let vehicle = started(locomotive(), "", 10.0, &Inputs::none(FRICTION));
    let loads = vertical_loads(&vehicle);
    let sum: f64 = loads.iter().flatten().sum();
    assert_close(sum, 134e3 * STANDARD_GRAVITY, 1e-6);
    for [left, right] in loads {
        assert_close(left, 134e3 * STANDARD_GRAVITY / 12.0, 1e-3);
        assert_close(left, right, 1e-9);
    }
}

/// Undamped modes with the wheelsets held: separate linear program (docs/reference/locomotive.md), given
/// with three or four figures; hence 0.2 %.
#[test]
fn benchmark_natural_frequencies() {
    let expected = [
        0.687, 1.022, 1.692, 1.713, 2.012, 4.34, 5.32, 5.46, 8.22, 8.24, 9.13, 9.48, 11.56, 11.80,
        14.47, 14.47, 22.6, 22.7,
    ];
    let found = linear::natural_frequencies(&locomotive());
    assert_eq!(found.len(), expected.len());
    for (i, (value, expected)) in found.into_iter().zip(expected).enumerate() {
        Row {
            case: &format!("locomotive, wheelsets held, mode {}", i + 1),
            value,
            expected,
            unit: "Hz",
            source: LINEAR_PROGRAM,
            tolerance: (2e-3 * expected, "three or four figures of the source"),
        }
        .holds(&PAGE);
    }
}

/// Traction weight transfer at 480 kN of drawbar pull: independent computation for the reference
/// set, linear. Ours has the weight of displaced bodies too; 2 % of the largest change.
#[test]
fn benchmark_weight_transfer_in_traction() {
    let pull = 480e3;
    let inputs = Inputs { traction: pull, rear_coupler: pull, ..Inputs::none(0.6) };
    let vehicle = started(locomotive(), "", 5.0, &inputs);
    let expected = [-31.1, -6.0, 19.2, -19.2, 6.0, 31.1];
    let static_load = 134e3 * STANDARD_GRAVITY / 6.0;
    let loads = vertical_loads(&vehicle).into_iter().zip(expected);
    for (i, ([left, right], expected)) in loads.enumerate() {
        Row {
            case: &format!("locomotive, 480 kN of traction, load of axle {}", i + 1),
            value: (left + right - static_load) / 1e3,
            expected,
            unit: "kN",
            source: LINEAR_PROGRAM,
            tolerance: (0.02 * 31.1, "weight of displaced bodies, which the source leaves out"),
        }
        .holds(&PAGE);
    }
}

/// Steady lateral acceleration of 0.65 m/s²: separate linear program (docs/reference/locomotive.md),
/// contacts 0.755 m from the middle; ours is linear here too, with the wheelsets on springs at the
/// rails. The mean load change is a matter of moments: 0.1 %. Its share between end and middle
/// axles depends on how the rails hold the wheelsets sideways, which its page does not say:
/// 3 %. Sway and roll are given with two figures: 3 %.
#[test]
fn benchmark_steady_lateral_acceleration() {
    const CONTACT: f64 = 0.2e9;
    let structure = locomotive();
    let mut stiffness = linear::stiffness(&structure);
    for data in &structure.wheelsets {
        let (at, radius, half) = (6 * data.body, data.wheel.radius, 0.755);
        stiffness[(at, at)] += CONTACT;
        stiffness[(at + 2, at + 2)] += 2.0 * CONTACT;
        stiffness[(at + 3, at + 3)] += 2.0 * CONTACT * half * half;
        stiffness[(at + 4, at + 4)] += CONTACT;
        stiffness[(at + 5, at + 5)] += CONTACT;
        // Lateral displacement at the rail: y - r roll.
        let row = [(at + 1, 1.0), (at + 3, -radius)];
        for (i, a) in row {
            for (j, b) in row {
                stiffness[(i, j)] += CONTACT * a * b;
            }
        }
    }
    let mut force = nalgebra::DVector::zeros(stiffness.nrows());
    for (i, body) in structure.bodies.iter().enumerate() {
        force[6 * i + 1] = body.mass * 0.65;
    }
    let moved = stiffness.cholesky().expect("a definite stiffness").solve(&force);
    let changes: Vec<f64> = structure
        .wheelsets
        .iter()
        .map(|data| {
            let at = 6 * data.body;
            CONTACT * (moved[at + 2] + 0.755 * moved[at + 3]) / 1e3
        })
        .collect();
    let row = |what: &str, value: f64, (expected, unit): (f64, &str), (share, reason)| {
        Row {
            case: &format!("locomotive, 0.65 m/s² across, {what}"),
            value,
            expected,
            unit,
            source: LINEAR_PROGRAM,
            tolerance: (share * expected, reason),
        }
        .holds(&PAGE);
    };
    let mean = (2.0 * 14.92 + 13.17) / 3.0;
    let figures = (1e-3, "four figures of the source");
    row("mean wheel load", changes.iter().sum::<f64>() / 6.0, (mean, "kN"), figures);
    let open = (3e-2, "how the rails hold the wheelsets across, which the source leaves open");
    let expected = [14.92, 13.17, 14.92, 14.92, 13.17, 14.92];
    for (i, (change, expected)) in changes.iter().zip(expected).enumerate() {
        row(&format!("wheel load of axle {}", i + 1), *change, (expected, "kN"), open);
    }
    let figures = (3e-2, "two figures of the source");
    row("sway", 1e3 * moved[1], (34.0, "mm"), figures);
    row("roll", moved[3].to_degrees().abs(), (0.35, "degrees"), figures);
}
