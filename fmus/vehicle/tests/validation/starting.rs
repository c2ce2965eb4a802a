//! The start: equilibrium, and standstill.

use crate::common::*;
use numerics::constants::STANDARD_GRAVITY;
use vehicle::contact::Standing;
use vehicle::dynamics::inputs::Inputs;

/// Nothing jumps at the start: wheel loads stay within 0.1 % of the first ones for a second.
#[test]
fn property_starts_in_equilibrium() {
    let inputs = Inputs { traction: 100e3, rear_coupler: 100e3, ..Inputs::none(FRICTION) };
    for track in ["", CURVE_800] {
        for speed in [2.0, 16.67, 25.0] {
            let mut vehicle = started(locomotive(), track, speed, &inputs);
            let first = vertical_loads(&vehicle);
            for _ in 0..1000 {
                vehicle.step(1e-3, &inputs);
                let now = vertical_loads(&vehicle);
                for (now, first) in now.iter().flatten().zip(first.iter().flatten()) {
                    assert_close(*now, *first, 1e-3);
                }
            }
        }
    }
}

/// Every vehicle finds its equilibrium in tight curves, without cant and with more than it needs, at
/// rest and in motion, and stands there with all wheels on the rails. The weight and what of the
/// centrifugal force the cant turns into it rest on them: in the plane across the track
/// m (g cos + v²/R sin), to 0.2 % (sums of wheels that are yawed and rolled against that plane).
#[test]
fn property_starts_in_tight_curves() {
    let inputs = Inputs::none(FRICTION);
    for name in VEHICLES {
        let structure = from_stock(name);
        for (radius, cant) in [150.0, 200.0, 300.0].into_iter().flat_map(|r| [(r, 0.0), (r, 0.1)]) {
            let curve = format!(
                "alignment = [{{ length_m = 1e6, radius_m = {radius}, cant_mm = {} }}]",
                1e3 * cant
            );
            for speed in [0.0, 2.0, 10.0] {
                let vehicle = started(structure.clone(), &curve, speed, &inputs);
                let case = format!("{name}, R {radius} m, cant {cant} m, {speed} m/s");
                let standing = vehicle.wheels.iter().flatten().map(|wheel| wheel.standing);
                assert!(standing.into_iter().all(|s| s == Standing::OnRail), "{case}");
                // Below 0.5 m/s places are those of 0.5 m/s.
                let speed = f64::max(speed, 0.5);
                let sin: f64 = cant / 1.5;
                let upright =
                    STANDARD_GRAVITY * (1.0 - sin * sin).sqrt() + speed * speed / radius * sin;
                let loads: f64 = vertical_loads(&vehicle).iter().flatten().sum();
                let expected = structure.mass() * upright;
                assert!((loads / expected - 1.0).abs() < 2e-3, "{case}: {loads} N, {expected} N");
            }
        }
    }
}

/// From rest in a curve of R 150 m without cant 100 kN take the locomotive away: never faster than
/// 100 kN on 134 t and 16.3 t of rotating mass, 0.665 m/s2, and by less than 0.2 m/s2 slower, which
/// is a curve resistance of 23 N/kN; no wheel leaves its rail.
#[test]
fn property_pulls_away_in_a_tight_curve() {
    let driving = Inputs { traction: 100e3, ..Inputs::none(FRICTION) };
    let curve = "alignment = [{ length_m = 1e6, radius_m = 150.0 }]";
    let mut vehicle = started(locomotive(), curve, 0.0, &driving);
    for _ in 0..5 {
        run(&mut vehicle, 1.0, &driving);
        let standing = vehicle.wheels.iter().flatten().map(|wheel| wheel.standing);
        assert!(standing.into_iter().all(|s| s == Standing::OnRail));
    }
    let speed = vehicle.velocity();
    assert!((5.0 * 0.465..5.0 * 0.665).contains(&speed), "{speed} m/s");
}

/// A standing vehicle with its brake on does not roll down a gradient of 2 %: what is left is the
/// creep of the contacts at their reference speed of 0.1 m/s, below 0.1 mm/s.
#[test]
fn property_the_brake_holds_on_a_gradient() {
    let slope = "gradient = [{ chainage_m = 0.0, permille = -20.0 }]";
    let inputs = Inputs { brake: 100e3, ..Inputs::none(FRICTION) };
    let mut vehicle = started(locomotive(), slope, 0.0, &inputs);
    run(&mut vehicle, 2.0, &inputs);
    let begin = vehicle.position();
    run(&mut vehicle, 10.0, &inputs);
    assert!((vehicle.position() - begin).abs() < 1e-3, "{} m", vehicle.position() - begin);
    // Without the brake it rolls away with nearly g sin.
    let free = Inputs::none(FRICTION);
    run(&mut vehicle, 5.0, &free);
    assert!(vehicle.velocity() > 0.8);
}
