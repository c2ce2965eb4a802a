//! Forces balance between the three models: steady on level straight track, the creep forces of
//! a locomotive carry its traction, and its coupler force is what the train says.

use hotfoot::recording::{KeyValue, SeriesReader};
use hotfoot_tests::{PAGE, SmallScenario};
use validation::Row;

/// Mean of a column over the last second for one vehicle.
fn late_mean(vehicles: &SeriesReader, column: &str, vehicle: i32) -> f64 {
    let values = vehicles.read(column, &[("vehicle", KeyValue::Integer(vehicle))]).unwrap();
    let late = &values[values.len() - 10..];
    late.iter().sum::<f64>() / late.len() as f64
}

/// Mass of every vehicle of the train, kg (the paper's table 1).
const MASS: f64 = 134e3;

/// Wagons behind the locomotive: the ratio of the paper's train, which notch 5 keeps at about
/// its speed.
const WAGONS: i32 = 64;

/// A force must be what balances it within 1 %: the train is not wholly steady after 20 s.
fn holds(case: &str, value: f64, of: &str, source: &str) {
    let tolerance = (0.01, "the train is not wholly steady after 20 s");
    Row { case, value, expected: 1.0, unit: &format!("of {of}"), source, tolerance }.holds(&PAGE);
}

#[test]
fn analytic_creep_forces_carry_traction_and_the_coupler_the_wagons() {
    let mut scenario = SmallScenario::new(20.0);
    scenario.track = "alignment = [{ length_m = 3000.0 }]\n".to_owned();
    scenario.driver = "[[command]]\nfrom_s = 0.0\nnotch = 5.0\n".to_owned();
    scenario.text = scenario.text.replace("count = 4", &format!("count = {WAGONS}"));
    scenario.leave_out_heat();
    scenario.run_well(&[]);
    let vehicles = SeriesReader::open(&scenario.results().join("series"), "vehicles").unwrap();
    let locomotive = |column| late_mean(&vehicles, column, 1);
    let traction = locomotive("traction_force");
    assert!(traction > 50e3, "the locomotive pulls with {traction} N");

    let creep = locomotive("creep_force");
    holds(
        "locomotive before 64 wagons, steady: creep forces",
        creep / traction,
        "its traction",
        "balance of forces",
    );

    // Newton's law for the 3D locomotive gives the coupler force that the train must have.
    let speed = vehicles.read("velocity", &[("vehicle", KeyValue::Integer(1))]).unwrap();
    let acceleration = speed[speed.len() - 1] - speed[speed.len() - 11];
    let expected = creep + locomotive("resistance_force") - MASS * acceleration;
    let tension = locomotive("coupler_rear_force");
    let coupler = "the same: tension of its coupler";
    holds(
        coupler,
        tension / expected,
        "what its motion leaves",
        "Newton's law for the 3D locomotive",
    );

    // It pulls mass and resistance behind it.
    let behind: f64 = (2..=WAGONS + 1).map(|i| -late_mean(&vehicles, "resistance_force", i)).sum();
    let expected = f64::from(WAGONS) * MASS * acceleration + behind;
    holds(coupler, tension / expected, "what it pulls", "mass and resistance behind it");
}
