//! Forces balance between the three models: steady on level straight track, the creep forces of
//! a locomotive carry its traction, and its coupler force is what the train says.

use hotfoot::recording::{KeyValue, SeriesReader};
use hotfoot_tests::SmallScenario;

/// Mean of a column over the last second for one vehicle.
fn late_mean(vehicles: &SeriesReader, column: &str, vehicle: i32) -> f64 {
    let values = vehicles.read(column, &[("vehicle", KeyValue::Integer(vehicle))]).unwrap();
    let late = &values[values.len() - 10..];
    late.iter().sum::<f64>() / late.len() as f64
}

/// Mass of every vehicle of the train, kg (the paper's table 1).
const MASS: f64 = 134e3;

#[test]
fn analytic_creep_forces_carry_traction_and_the_coupler_the_wagons() {
    let mut scenario = SmallScenario::new(20.0);
    scenario.track = "alignment = [{ length_m = 1000.0 }]\n".to_owned();
    scenario.run_well(&[]);
    let vehicles = SeriesReader::open(&scenario.results().join("series"), "vehicles").unwrap();
    let locomotive = |column| late_mean(&vehicles, column, 1);
    let traction = locomotive("traction_force");
    assert!(traction > 50e3, "the locomotive pulls with {traction} N");

    // Longitudinal creep forces on the wheels are traction less what accelerates the wheelsets'
    // rotation: the rotating inertia is 6 x 700 kg m2 / (0.508 m)2 / 134 t = 12 % of the mass, and
    // the acceleration leaves 1 % only if it is counted.
    let rotating_mass = 6.0 * 700.0 / (0.508 * 0.508);
    let speed = vehicles.read("velocity", &[("vehicle", KeyValue::Integer(1))]).unwrap();
    let acceleration = (speed[speed.len() - 1] - speed[speed.len() - 11]) / 1.0;
    let creep = locomotive("creep_force");
    let expected = traction - rotating_mass * acceleration;
    assert!((creep - expected).abs() < 0.01 * traction, "creep {creep} N, expected {expected} N");

    // The vehicle itself: creep + resistance + coupler + synchronisation = mass x acceleration.
    let coupler = -locomotive("coupler_rear_force");
    let rest = creep + locomotive("resistance_force") + coupler + locomotive("sync_force");
    let inertia = MASS * acceleration;
    assert!((rest - inertia).abs() < 0.01 * traction, "balance {rest} N, inertia {inertia} N");

    // Closed form (reference/longitudinal.md 1.7): the coupler carries mass behind over mass.
    let behind: f64 = (2..=5).map(|i| -late_mean(&vehicles, "resistance_force", i)).sum();
    let expected = 4.0 * MASS * acceleration + behind;
    let tension = locomotive("coupler_rear_force");
    assert!((tension - expected).abs() < 0.01 * traction, "tension {tension}, expected {expected}");
}
