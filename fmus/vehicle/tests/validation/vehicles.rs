//! The vehicles of the stock library in motion, and the track under them.

use crate::common::*;
use numerics::constants::STANDARD_GRAVITY;
use vehicle::dynamics::Dynamics;
use vehicle::dynamics::inputs::Inputs;
use vehicle::linear::{Rolling, Surfaces, System};

/// All wheels together carry the weight; left and right are alike.
#[test]
fn analytic_static_loads_of_all_vehicles() {
    for name in VEHICLES {
        let vehicle = started(from_stock(name), "", 10.0, &Inputs::none(FRICTION));
        let loads = vertical_loads(&vehicle);
        let weight = vehicle.structure.mass() * STANDARD_GRAVITY;
        Row {
            case: &format!("{name}, wheel loads over the weight"),
            value: loads.iter().flatten().sum::<f64>() / weight,
            expected: 1.0,
            unit: "1",
            source: "equilibrium",
            tolerance: (1e-6, "tolerance of the start"),
        }
        .holds(&PAGE);
        for ([left, right], data) in loads.iter().zip(&vehicle.structure.wheelsets) {
            assert_close(*left, *right, 1e-6);
            assert_close(*left, data.static_wheel_load, 1e-2);
        }
    }
}

/// Bounce of the loaded ore wagon on its springs without friction: 1.80 Hz for the car body on
/// 4 x 4.79 MN/m (by hand); ours has the bolsters' mass and the stiffness of plates and
/// adapters too, hence 2 %.
#[test]
fn benchmark_bounce_of_the_ore_wagon() {
    let structure = from_stock("wagon-ore-40t");
    let system = System::new(&structure, Surfaces::Slide).with_wheelsets_held(&structure);
    let modes = system.modes().oscillating;
    let bounce = modes.iter().find(|mode| mode.energy[2] > 0.9).expect("a bounce mode");
    Row {
        case: "ore wagon, loaded, bounce without friction",
        value: bounce.frequency(),
        expected: 1.80,
        unit: "Hz",
        source: "4 x 4.79 MN/m and the car body's mass by hand",
        tolerance: (2e-2 * 1.80, "bolsters, plates and adapters"),
    }
    .holds(&PAGE);
}

/// Linear critical speeds of the locomotive over the conicity (separate linear program for the
/// same data and contacts 0.755 m from the middle): within 2 m/s. That
/// computation has the yaw dampers without their stiffness in series.
#[test]
fn benchmark_critical_speeds() {
    let mut structure = (*locomotive()).clone();
    for damper in &mut structure.suspension.dampers {
        damper.series_stiffness = f64::INFINITY;
    }
    let published = [(0.05, 89.0), (0.10, 87.0), (0.15, 79.0), (0.20, 72.0), (0.30, 60.0)];
    for (conicity, expected) in published {
        let rolling = Rolling { conicity, half_distance: 0.755, rail_radius: 0.3 };
        let found = rolling.critical_speed(&structure, 150.0).expect("a critical speed");
        let dampers = "yaw dampers without series stiffness";
        Row {
            case: &format!("locomotive, conicity {conicity:.2}, critical speed, {dampers}"),
            value: found.speed,
            expected,
            unit: "m/s",
            source: LINEAR_PROGRAM,
            tolerance: (2.0, "two figures, and f11 and f22 of three"),
        }
        .holds(&PAGE);
    }
}

/// The same with the stiffness in series: eigenvalues of the same matrices by LAPACK, written anew in
/// Python with f11 16.2 MN and f22 14.9 MN, found with steps of 0.06 m/s: 127.4 and 63.6 m/s. Ours
/// takes f11 and f22 from Hertz and Kalker; 1 m/s.
#[test]
fn benchmark_critical_speeds_with_series_stiffness() {
    for (conicity, expected) in [(0.05, 127.4), (0.30, 63.6)] {
        let rolling = Rolling { conicity, half_distance: 0.755, rail_radius: 0.3 };
        let found = rolling.critical_speed(&locomotive(), 150.0).expect("a critical speed");
        Row {
            case: &format!("locomotive, conicity {conicity:.2}, critical speed"),
            value: found.speed,
            expected,
            unit: "m/s",
            source: "eigenvalues of the same matrices by LAPACK",
            tolerance: (1.0, "f11 and f22 of three figures"),
        }
        .holds(&PAGE);
    }
}

/// Kalker's coefficients of the locomotive's wheel: f11 16.2 MN, f22 14.9 MN, given with three
/// figures: 0.5 %.
#[test]
fn benchmark_creep_coefficients() {
    let rolling = Rolling { conicity: 0.1, half_distance: 0.755, rail_radius: 0.3 };
    let found = rolling.creep_coefficients(0.508, 109.545e3);
    for ((name, value), expected) in ["f11", "f22"].into_iter().zip(found).zip([16.2, 14.9]) {
        Row {
            case: &format!("locomotive, {name} of a wheel under 109.5 kN"),
            value: value / 1e6,
            expected,
            unit: "MN",
            source: LINEAR_PROGRAM,
            tolerance: (5e-3 * expected, "three figures of the source"),
        }
        .holds(&PAGE);
    }
}

/// Every vehicle runs 5 s through a transition into an arc and keeps its wheels on the rails.
#[test]
fn property_all_vehicles_run_through_a_transition() {
    for name in VEHICLES {
        for speed in [1.0, 16.67] {
            let inputs = Inputs::none(FRICTION);
            let mut vehicle = started(from_stock(name), TRANSITION, speed, &inputs);
            run(&mut vehicle, 5.0, &inputs);
            for wheel in vehicle.wheels.iter().flatten() {
                assert!(wheel.total.force.normal > 0.0, "{name} at {speed} m/s: {wheel:?}");
            }
        }
    }
}

/// Brakes to a standstill in a curve, stands, and starts again with traction: what the creep law's
/// stiffness at low speed must not spoil. The vehicle stands within 1 mm/s.
#[test]
fn property_stops_in_a_curve_and_starts_again() {
    let braking = Inputs { brake: 200e3, ..Inputs::none(FRICTION) };
    let mut vehicle = started(locomotive(), CURVE_800, 3.0, &braking);
    run(&mut vehicle, 10.0, &braking);
    assert!(vehicle.velocity().abs() < 1e-3, "{} m/s", vehicle.velocity());
    let stood = vehicle.position();
    run(&mut vehicle, 2.0, &braking);
    assert!((vehicle.position() - stood).abs() < 2e-3);
    let driving = Inputs { traction: 100e3, ..Inputs::none(FRICTION) };
    run(&mut vehicle, 4.0, &driving);
    // 100 kN on 134 t and 16.3 t of rotating mass: 0.665 m/s², less some curve resistance.
    assert!((vehicle.velocity() - 2.6).abs() < 0.15, "{} m/s", vehicle.velocity());
}

const ERRI: &str = "[irregularity]
    spectrum = { quality = 'erri-high', seed = 3, begin_m = 1020.0, length_m = 400.0 }";

/// Work in less heat and what is stored, against what was turned over, after a run.
fn energy_error(vehicle: &mut Dynamics, time: f64, inputs: &Inputs) -> f64 {
    let before = vehicle.stored_energy().sum();
    run(vehicle, time, inputs);
    let account = vehicle.state.account;
    let error = vehicle.stored_energy().sum() - before - account.work() + account.heat();
    error / (account.heat() + account.irregularities.abs())
}

/// Rough track, elastic rails, and both: all energy is accounted for, within 2 % of what little is
/// turned over without traction; kinetic energy counts at the end of the last step and elastic
/// energy in its middle.
#[test]
fn property_energy_balance_on_rough_and_elastic_track() {
    for track in [ERRI.to_owned(), SUPPORT.to_owned(), format!("{ERRI}\n{SUPPORT}")] {
        for name in VEHICLES {
            let inputs = Inputs::none(FRICTION);
            let mut vehicle = started(from_stock(name), &track, 20.0, &inputs);
            let error = energy_error(&mut vehicle, 5.0, &inputs);
            assert!(error.abs() < 2e-2, "{name}: {error}\n{track}");
        }
    }
}

/// On elastic rails a wheel of 109.5 kN sinks by 109.5 kN over 60 MN/m = 1.826 mm, its wheelset with
/// it, and nothing moves at the start.
#[test]
fn analytic_elastic_rails_carry_the_wheels() {
    let inputs = Inputs::none(FRICTION);
    let stiff = started(locomotive(), "", 10.0, &inputs);
    let mut vehicle = started(locomotive(), SUPPORT, 10.0, &inputs);
    let sunk = vehicle.state.deflections[0][0].displacement.y;
    Row {
        case: "locomotive, elastic rails, deflection over load by stiffness",
        value: sunk / (134e3 * STANDARD_GRAVITY / 12.0 / 60e6),
        expected: 1.0,
        unit: "1",
        source: "Hooke's law",
        tolerance: (1e-3, "the contact is inclined by 1.7 degrees"),
    }
    .holds(&PAGE);
    let axle = vehicle.structure.wheelsets[0].body;
    let at = |vehicle: &Dynamics| vehicle.state.bodies[axle].position.z;
    // The lateral thrust of the inclined contact spreads the rails a little.
    assert!((at(&vehicle) - at(&stiff) - sunk).abs() < 0.05e-3);
    let first = vertical_loads(&vehicle);
    run(&mut vehicle, 0.5, &inputs);
    for (now, first) in vertical_loads(&vehicle).iter().flatten().zip(first.iter().flatten()) {
        assert_close(*now, *first, 2e-3);
    }
}
