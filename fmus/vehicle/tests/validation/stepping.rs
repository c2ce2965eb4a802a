//! The step itself: its convergence, any speed, saved states.

use crate::common::*;
use vehicle::contact::Standing;
use vehicle::dynamics::inputs::Inputs;

/// Steps of 1 ms against 0.1 ms through a transition into the arc: wheel loads within 0.5 % of the
/// static load, positions within 0.1 mm. The scheme is of first order in the friction terms; the
/// ring of a wheelset on its contacts (140 Hz) after the end of a transition is not resolved.
#[test]
fn property_step_convergence() {
    let inputs = Inputs { traction: 100e3, rear_coupler: 100e3, ..Inputs::none(FRICTION) };
    let ends = [1e-3, 1e-4].map(|step| {
        let mut vehicle = started(locomotive(), TRANSITION, 16.67, &inputs);
        for _ in 0..(4.8_f64 / step).round() as usize {
            vehicle.step(step, &inputs);
        }
        vehicle
    });
    for (coarse, fine) in ends[0].state.bodies.iter().zip(&ends[1].state.bodies) {
        assert!((coarse.position - fine.position).amax() < 1e-4);
    }
    let [coarse, fine] = ends.each_ref().map(vertical_loads);
    for (coarse, fine) in coarse.iter().flatten().zip(fine.iter().flatten()) {
        assert!((coarse - fine).abs() < 5e-3 * 109.5e3, "{coarse} N, {fine} N");
    }
}

/// The same on elastic rails, which follow the wheels a step late, through a transition and over a dip of
/// 5 mm in both rails. Instants differ by more, where a wheel meets a second contact a little earlier;
/// so the root mean square over 5 s counts: 0.5 % of the static load.
#[test]
fn property_step_convergence_on_elastic_rails() {
    let inputs = Inputs { traction: 100e3, rear_coupler: 100e3, ..Inputs::none(FRICTION) };
    let dip = "[[irregularity.shape]]
        form = 'dip'
        rails = 'both'
        direction = 'vertical'
        begin_m = 1015.0
        length_m = 3.0
        amplitude_mm = 5.0";
    let track = format!("{TRANSITION}\n{dip}\n{SUPPORT}");
    for speed in [1.0, 5.0, 16.67] {
        let mut vehicles =
            [1, 10].map(|parts| (started(locomotive(), &track, speed, &inputs), parts));
        let (mut squares, count) = (0.0, 5000);
        for _ in 0..count {
            for (vehicle, parts) in &mut vehicles {
                for _ in 0..*parts {
                    vehicle.step(1e-3 / f64::from(*parts), &inputs);
                }
            }
            let [coarse, fine] = vehicles.each_ref().map(|(vehicle, _)| vertical_loads(vehicle));
            for (coarse, fine) in coarse.iter().flatten().zip(fine.iter().flatten()) {
                squares += (coarse - fine).powi(2);
            }
        }
        let [coarse, fine] = vehicles.each_ref().map(|(vehicle, _)| &vehicle.state.bodies);
        for (coarse, fine) in coarse.iter().zip(fine) {
            assert!((coarse.position - fine.position).amax() < 1e-4, "{speed} m/s");
        }
        let rms = (squares / (12.0 * f64::from(count))).sqrt();
        println!("elastic rails, {speed} m/s, 1 ms against 0.1 ms: wheel loads {rms:.1} N rms");
        assert!(rms < 5e-3 * 109.5e3, "{speed} m/s: {rms} N");
    }
}

/// Every vehicle in the tightest curves at 1 to 15 m/s (below 1.2 m/s2), where flanges press, with the steps that
/// its FMU takes in 1 ms against a quarter of them: wheel loads within 0.1 % of the static ones, root mean
/// square over 3 s. A wheelset that rings on its flange is off by a quarter of its load and more.
#[test]
fn property_steps_of_1_ms_do_not_ring_in_tight_curves() {
    let speeds = |radius| [1.0, 3.0, 5.0, 10.0, 15.0].map(|speed: f64| (radius, speed));
    let curves: Vec<(f64, f64)> = [150.0, 200.0, 300.0].into_iter().flat_map(speeds).collect();
    for name in VEHICLES {
        let structure = from_stock(name);
        for &(radius, speed) in curves.iter().filter(|(r, v)| v * v / r < 1.2) {
            let case = format!("{name}, R {radius} m, {speed} m/s");
            let curve = format!("alignment = [{{ length_m = 1e6, radius_m = {radius} }}]");
            let inputs = Inputs::none(FRICTION);
            let vehicle = started(structure.clone(), &curve, speed, &inputs);
            let steps = (1e-3 / vehicle.longest_step()).ceil() as usize;
            let mut vehicles = [(vehicle.clone(), steps), (vehicle.clone(), 4 * steps)];
            let static_loads = vertical_loads(&vehicle);
            let (mut squares, count) = (0.0, 3000);
            for _ in 0..count {
                for (vehicle, steps) in &mut vehicles {
                    for _ in 0..*steps {
                        vehicle.step(1e-3 / *steps as f64, &inputs);
                    }
                }
                let [coarse, fine] =
                    vehicles.each_ref().map(|(vehicle, _)| vertical_loads(vehicle));
                let pairs = coarse.iter().flatten().zip(fine.iter().flatten());
                let loads = static_loads.iter().flatten();
                for ((coarse, fine), load) in pairs.zip(loads) {
                    squares += ((coarse - fine) / load).powi(2);
                }
            }
            let rms = (squares / f64::from(count) / (2 * static_loads.len()) as f64).sqrt();

            assert!(rms < 1e-3, "{case}: wheel loads differ by {rms} of the static ones");
        }
    }
}

/// From 0.1 to 40 m/s, on straight track and through a curve, all wheels stay on the rails.
#[test]
fn property_runs_at_any_speed() {
    let inputs = Inputs::none(FRICTION);
    for speed in [0.0, 0.1, 1.0, 5.0, 20.0, 40.0] {
        let curve = if speed > 30.0 { CURVE_3000 } else { TRANSITION };
        for track in ["", curve] {
            let mut vehicle = started(locomotive(), track, speed, &inputs);
            run(&mut vehicle, 5.0, &inputs);
            assert!(
                (vehicle.velocity() - speed).abs() < 0.2,
                "{speed} m/s: {}",
                vehicle.velocity()
            );
            for wheel in vehicle.wheels.iter().flatten() {
                assert!(
                    wheel.total.force.normal > 50e3 && wheel.standing == Standing::OnRail,
                    "{speed} m/s: {wheel:?}"
                );
            }
        }
    }
}

/// A state that went through a file gives the same bits later on.
#[test]
fn property_a_restored_state_goes_on_bit_by_bit() {
    let inputs = Inputs { traction: 100e3, ..Inputs::none(FRICTION) };
    let mut vehicle = started(locomotive(), TRANSITION, 16.67, &inputs);
    run(&mut vehicle, 1.0, &inputs);
    let saved = postcard::to_allocvec(&vehicle.state).unwrap();
    run(&mut vehicle, 1.0, &inputs);
    let mut other = started(locomotive(), TRANSITION, 10.0, &Inputs::none(FRICTION));
    other.restore(postcard::from_bytes(&saved).unwrap());
    run(&mut other, 1.0, &inputs);
    assert_eq!(vehicle.state, other.state);
    assert_eq!(vehicle.wheels, other.wheels);
}
