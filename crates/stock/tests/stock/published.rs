//! Values of the shipped files against the sources that they name.

use stock::Vehicle;

use crate::scratch::shipped;

/// Newtons in a pound of force, and metres in an inch.
const POUND: f64 = 4.448_221_615_260_5;
const INCH: f64 = 0.0254;

fn near(value: f64, expected: f64, tolerance: f64) {
    let difference = (value / expected - 1.0).abs();
    assert!(difference <= tolerance, "{value} instead of {expected}: off by {difference:.2e}");
}

/// The value at a speed, km/h, linear between the points of a table.
fn at(speeds: &[f64], values: &[f64], speed: f64) -> f64 {
    let i = speeds.partition_point(|own| *own < speed).clamp(1, speeds.len() - 1);
    let share = (speed - speeds[i - 1]) / (speeds[i] - speeds[i - 1]);
    values[i - 1] + share * (values[i] - values[i - 1])
}

fn locomotive() -> Vehicle {
    shipped().vehicle("locomotive-coco-134t").unwrap()
}

/// Curtius and Kniffler 1944: 7.5/(V + 44) + 0.161 with V in km/h. The table has three digits, half
/// of whose last one is 0.25 %, and a
/// chord of 20 km/h lies at most 1 % above the curve.
#[test]
fn benchmark_adhesion_is_that_of_curtius_and_kniffler() {
    let adhesion = locomotive().traction.unwrap().adhesion.unwrap();
    for (speed, value) in adhesion.speed_kmh.iter().zip(&adhesion.value) {
        near(*value, 7.5 / (speed + 44.0) + 0.161, 2.5e-3);
    }
    for speed in [5.0, 50.0, 110.0] {
        let found = at(&adhesion.speed_kmh, &adhesion.value, speed);
        near(found, 7.5 / (speed + 44.0) + 0.161, 1e-2);
    }
}

/// Downer EDI GT46C-ACe: 3207 kW, 600 kN starting and 520 kN continuous effort. With 85 % of the power at
/// the rail the continuous effort ends at 0.85 · 3207 kW/520 kN = 18.9 km/h.
#[test]
fn benchmark_continuous_effort_ends_where_the_power_limits() {
    let traction = locomotive().traction.unwrap();
    let (power, effort) = (traction.power_kw.unwrap(), traction.effort.unwrap());
    assert_eq!((power, effort.effort_kn[0], effort.effort_kn[1]), (3207.0, 600.0, 520.0));
    near(effort.speed_kmh[1], traction.efficiency * power / effort.effort_kn[1] * 3.6, 2e-3);
}

/// Above 30 km/h the dynamic brake follows the hyperbola of the power 325 kN · 30 km/h.
#[test]
fn analytic_the_dynamic_brake_has_constant_power() {
    let effort = locomotive().dynamic_brake.unwrap().effort;
    let points = effort.speed_kmh.iter().zip(&effort.effort_kn);
    for (speed, force) in points.filter(|(speed, _)| **speed >= 30.0) {
        near(speed * force, 325.0 * 30.0, 1e-3);
    }
}

/// Train Propulsion Simulator, example input: 200, 325 and 400 kips at 0.75, 3 and 4 in.
#[test]
fn benchmark_elastic_coupler_in_pounds_and_inches() {
    let gear = shipped().draft_gear("elastic-tps").unwrap();
    let curve = &gear.draft.loading;
    for (inches, kips) in [(0.75, 200.0), (3.0, 325.0), (4.0, 400.0)] {
        near(curve.force_at_kn(inches * INCH * 1e3), kips * POUND, 1e-5);
    }
    // Elastic: it gives back all that it takes.
    assert_eq!(gear.draft.unloading, gear.draft.loading);
}

/// maisvendoo/train, EFCoupling: 240 kN + 25.7 MN/m loading, 50 kN + 2.85 MN/m unloading. The energy that
/// a full stroke of 90 mm loses is the area between: (240 − 50) x + (25.7 − 2.85) x²/2.
#[test]
fn benchmark_the_sa3_gear_loses_the_area_between_its_lines() {
    let gear = shipped().draft_gear("friction-gear-sa3").unwrap().draft;
    let stroke = 90.0;
    near(gear.loading.force_at_kn(stroke), 240.0 + 25.7 * stroke, 1e-9);
    near(gear.unloading.force_at_kn(stroke), 50.0 + 2.85 * stroke, 1e-9);
    let lost = gear.loading.energy_to_kj(stroke) - gear.unloading.energy_to_kj(stroke);
    let area = (240.0 - 50.0) * stroke + (25.7 - 2.85) * stroke * stroke / 2.0;
    near(lost, area * 1e-3, 1e-9);
}

/// The power law through the official point has the exponent F x/W − 1 (Miner TF-880: 2518 kN, 74.4 mm,
/// 61.7 kJ). Forces are rounded to 0.1 kN, which is 1 % of the smallest.
#[test]
fn analytic_the_friction_gear_follows_its_power_law() {
    let curve = shipped().draft_gear("friction-gear-m901e").unwrap().draft.loading;
    let exponent = 2518.0 * 74.4e-3 / 61.7 - 1.0;
    for (deflection, force) in curve.deflection_mm.iter().zip(&curve.force_kn).skip(1) {
        near(*force, 2518.0 * (deflection / 74.4).powf(exponent), 1e-2);
    }
}

/// Masses, and what is loaded into an empty wagon: the body differs, bogies and wheelsets do not.
#[test]
fn property_a_load_lies_in_the_body() {
    let vehicle = |name: &str| shipped().vehicle(name).unwrap();
    let (empty, loaded) = (vehicle("wagon-ore-40t-empty"), vehicle("wagon-ore-40t"));
    let load = loaded.mass_kg - empty.mass_kg;
    assert!(load > 0.0);
    let (below, above) = (empty.multibody.unwrap(), loaded.multibody.unwrap());
    near(above.body[0].mass_kg - below.body[0].mass_kg, load, 1e-9);
    assert_eq!(below.wheelset, above.wheelset);
}

/// What a vehicle's parts weigh is what its couplers pull, of every shipped vehicle that has both.
#[test]
fn property_parts_add_up_to_the_whole() {
    for name in
        ["locomotive-coco-134t", "wagon-ore-40t", "wagon-ore-40t-empty", "manchester-vehicle-1"]
    {
        let vehicle = shipped().vehicle(name).unwrap();
        near(vehicle.multibody.unwrap().mass(), vehicle.mass_kg, 1e-6);
    }
}
