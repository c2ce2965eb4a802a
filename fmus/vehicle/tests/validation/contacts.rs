//! Several contacts a wheel, and wheels off their rails.

use crate::common::*;
use vehicle::contact::Standing;
use vehicle::dynamics::inputs::Inputs;

/// In curves of 250 to 500 m wheels stand on two contacts at once. What a wheel shows is the sum of its
/// contacts in force and power, and lies between them in creepage. Rounding.
#[test]
fn property_tread_and_flange_share_the_load() {
    let inputs = Inputs::none(FRICTION);
    let mut shared = 0;
    for radius in [250.0, 300.0, 400.0, 500.0] {
        let curve = format!(
            "start_m = 1010.0
            alignment = [{{ length_m = 50.0, transition = true }},
                         {{ length_m = 1e4, radius_m = {radius}, cant_mm = 40.0 }}]"
        );
        let mut vehicle = started(locomotive(), &curve, 10.0, &inputs);
        run(&mut vehicle, 9.0, &inputs);
        for wheel in vehicle.wheels.iter().flatten() {
            let normal: f64 = wheel.patches.iter().map(|patch| patch.force.normal).sum();
            assert_close(normal, wheel.total.force.normal, 1e-12);
            let power: f64 = wheel.patches.iter().map(|patch| patch.friction_power).sum();
            assert!((power - wheel.total.friction_power).abs() <= 1e-12 * power.abs());
            let loaded = wheel.patches.iter().filter(|patch| patch.force.normal > 1e3);
            let creepages = loaded.map(|patch| patch.creepages.longitudinal);
            let creepages: Vec<f64> = creepages.collect();
            if creepages.len() > 1 {
                shared += 1;
                let least = creepages.iter().copied().fold(f64::INFINITY, f64::min);
                let most = creepages.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                let mean = wheel.total.creepages.longitudinal;
                assert!(least < mean && mean < most, "{mean} is not between {creepages:?}");
            }
        }
    }
    assert!(shared > 0, "no wheel has two contacts");
}

/// A wheelset set down beside its rails and one hung above them: told by the flag, and the step goes on
/// with finite numbers.
#[test]
fn property_a_wheel_off_its_rail_is_told_and_the_step_goes_on() {
    let inputs = Inputs::none(FRICTION);
    for (aside, up, expected) in [(0.05, 0.0, Standing::Derailed), (0.0, 5e-3, Standing::Lifted)] {
        let mut vehicle = started(locomotive(), "", 10.0, &inputs);
        let body = vehicle.structure.wheelsets[0].body;
        vehicle.state.bodies[body].position.y += aside;
        vehicle.state.bodies[body].position.z -= up;
        vehicle.step(1e-3, &inputs);
        assert!(vehicle.wheels[0].iter().any(|wheel| wheel.standing == expected));
        run(&mut vehicle, 0.5, &inputs);
        for wheel in vehicle.wheels.iter().flatten() {
            assert!(
                (wheel.total.force.normal
                    + wheel.total.friction_power
                    + wheel.total.ellipse.lateral_position)
                    .is_finite()
            );
        }
    }
}
