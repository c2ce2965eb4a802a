//! The controller in the whole loop (Bosomworth et al. 2018, figure 6): under constant traction
//! the position error grows with velocity-only control and stays bounded with the PD law.

use hotfoot::recording::{KeyValue, SeriesReader};
use hotfoot_tests::{PAGE, SmallScenario};
use validation::Bound;

/// Position error of the last vehicle at each full second of 60 s, m.
fn errors(kp_kn_per_m: f64) -> Vec<f64> {
    let mut scenario = SmallScenario::new(60.0);
    scenario.track = "alignment = [{ length_m = 3000.0 }]\n".to_owned();
    scenario.leave_out_heat();
    scenario.text += &format!("[synchronisation]\nkp_kn_per_m = {kp_kn_per_m:?}\n");
    scenario.run_well(&[]);
    let vehicles = SeriesReader::open(&scenario.results().join("series"), "vehicles").unwrap();
    let key = [("vehicle", KeyValue::Integer(5))];
    vehicles.read("position_error", &key).unwrap().into_iter().step_by(10).collect()
}

#[test]
fn benchmark_the_position_error_grows_without_kp_and_is_bounded_with_it() {
    let velocity_only = errors(0.0);
    let (early, late) = (velocity_only[30].abs(), velocity_only[60].abs());
    // A constant difference of the two models makes the error grow in proportion to time; the
    // traction and so the difference fall a little as the train gains speed.
    assert!(late > 1.5 * early && early > 0.01, "{early} m at 30 s, {late} m at 60 s");
    Bound {
        case: "position error of the fifth vehicle under constant traction, Kp = 0, after 30 and 60 s",
        limit: "over 10 mm, and half as much again",
        obtained: &format!("{early:.3} and {late:.3} m"),
    }
    .stands_in(&PAGE);

    let with_position = errors(2.0);
    let largest = with_position.iter().fold(0.0_f64, |largest, error| largest.max(error.abs()));
    assert!(largest < late, "{largest} m with Kp, {late} m without");
    // Bounded: the second half of the run adds nothing to the first.
    let half = with_position[..30].iter().fold(0.0_f64, |most, error| most.max(error.abs()));
    assert!(largest <= half * 1.01, "largest error {largest} m, in the first half {half} m");
    Bound {
        case: "the same with Kp = 2 kN/m, largest in the first half and in all of 60 s",
        limit: "less than without, and no more in the second half",
        obtained: &format!("{half:.3} and {largest:.3} m"),
    }
    .stands_in(&PAGE);
}
