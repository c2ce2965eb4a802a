//! Air brake, locomotive brake, hand brakes and the heat of the wheels.

use longitudinal::Command;
use longitudinal::{BuildError, Couplers, TrainDynamics, TrainState};
use stock::{Consist, Vehicle};
use track::Track;

use crate::support::*;

/// The application of a full service fills the cylinder evenly in 10 s, an emergency in 4 s.
const AIR: &str = "[brake]\ncontrol = 'air'\n[brake.air]\n\
    service_wave_m_per_s = 250\nrelease_wave_m_per_s = 200\nemergency_wave_m_per_s = 280\n\
    build_up = { time_s = [0, 10], fraction = [0, 1] }\n\
    emergency_build_up = { time_s = [0, 4], fraction = [0, 1] }\n\
    release = { time_s = [0, 20], fraction = [0, 1] }\n";

fn air_train(locomotives: &[usize], count: usize, more: &str) -> TrainDynamics {
    let vehicles: Vec<Vehicle> = (0..count)
        .map(|i| match locomotives.contains(&i) {
            true => vehicle_of(&format!("{AIR}{more}")),
            false => vehicle_of(&format!("without = ['traction', 'dynamic_brake']\n{AIR}{more}")),
        })
        .collect();
    train(&vehicles, &friction_gear(), Track::straight())
}

/// First time at which each vehicle's cylinder is no longer what it was at the start.
fn first_changes(train: &mut TrainDynamics, state: &mut TrainState, command: &Command) -> Vec<f64> {
    let before: Vec<f64> = state.vehicles.iter().map(|v| v.brake.cylinder).collect();
    let mut times = vec![f64::NAN; before.len()];
    for k in 1..=20_000 {
        train.advance(state, command, 1e-3);
        for (i, time) in times.iter_mut().enumerate() {
            if time.is_nan() && state.vehicles[i].brake.cylinder != before[i] {
                *time = f64::from(k) * 1e-3;
            }
        }
        if times.iter().all(|time| time.is_finite()) {
            break;
        }
    }
    times
}

/// The wave arrives at a vehicle after its distance from the locomotive over the wave's speed.
/// That is 250 m/s for service, 280 for emergency and 200 for release.
#[test]
fn analytic_air_brake_wave_runs_along_the_train() {
    for (from, to, wave) in [(0.0, 0.5, 250.0), (0.0, 1.2, 280.0), (0.8, 0.3, 200.0)] {
        let mut train = air_train(&[0], 60, "");
        let mut state = start(&mut train, 15.0, Couplers::InBalance, train_brake(from));
        let times = first_changes(&mut train, &mut state, &train_brake(to));
        for i in [1, 20, 59] {
            Row {
                case: &format!("brake {from} to {to} arrives at vehicle {}", i + 1),
                value: times[i],
                expected: 20.0 * i as f64 / wave,
                unit: "s",
                source: "distance over the speed of the wave",
                tolerance: (2.1e-3, "two steps of 1 ms"),
            }
            .holds(&PAGE);
        }
    }
}

/// Locomotives in the middle vent the pipe there, too.
#[test]
fn analytic_air_brake_listens_to_the_nearest_locomotive() {
    let mut train = air_train(&[0, 40], 60, "");
    let mut state = start(&mut train, 15.0, Couplers::InBalance, Command::default());
    let times = first_changes(&mut train, &mut state, &train_brake(1.0));
    for (i, distance) in [(19, 380.0), (21, 380.0), (41, 20.0), (59, 380.0)] {
        assert!((times[i] - distance / 250.0).abs() < 2.1e-3, "{i}: {}", times[i]);
    }
}

/// Cylinder after times, s, by hand from the even curves.
#[test]
fn analytic_air_brake_fills_and_empties_along_its_curves() {
    let graduated = format!("{AIR}graduated_release = true\n");
    for (air, released_to) in [(AIR, 0.0), (&graduated, 0.3)] {
        let vehicle = vehicle_of(air);
        let mut train = train(&[vehicle], &friction_gear(), Track::straight());
        let mut state = start(&mut train, 15.0, Couplers::Unstressed, Command::default());
        let mut after = |command: f64, time: f64, expected: f64| {
            train.advance(&mut state, &train_brake(command), time);
            let cylinder = state.vehicles[0].brake.cylinder;
            // 1 ms until the command arrives, of 4 s.
            assert!((cylinder - expected).abs() < 5e-4, "{cylinder} {expected}");
        };
        after(0.6, 4.0, 0.4);
        after(0.6, 4.0, 0.6);
        after(0.3, 2.0, 0.5);
        after(0.3, 12.0, released_to);
        after(1.2, 4.0, (released_to + 1.2_f64).min(1.2));
        after(0.0, 30.0, 0.0);
    }
}

/// All brakes press the same shoes: the strongest counts.
#[test]
fn analytic_locomotive_brake_and_hand_brake() {
    let text = "[locomotive_brake]\nnet_braking_ratio = 0.2\nbuild_up_s = 4\nrelease_s = 8\n\
                [hand_brake]\nnet_braking_ratio = 0.05";
    let locomotive = vehicle_of(text);
    let mut train = train(&[locomotive], &friction_gear(), Track::straight());
    let command = |locomotive_brake: f64| Command { locomotive_brake, ..Command::default() };
    let mut state = start(&mut train, 15.0, Couplers::Unstressed, command(0.0));
    train.advance(&mut state, &command(1.0), 3.0);
    assert!((state.vehicles[0].brake.locomotive_cylinder - 0.75).abs() < 1e-9);
    let friction = state.vehicles[0].forces.brake / (134e3 * 9.80665 * 0.2 * 0.75);
    assert!((0.3..0.56).contains(&friction), "friction of the shoes: {friction}");
    train.advance(&mut state, &command(0.5), 3.0);
    assert!((state.vehicles[0].brake.locomotive_cylinder - 0.5).abs() < 1e-9);
}

#[test]
fn analytic_hand_brakes_hold_a_train_that_nothing_else_holds() {
    let folder = tempfile::tempdir().unwrap();
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../stock");
    for part in ["vehicles", "draft_gears"] {
        std::fs::create_dir(folder.path().join(part)).unwrap();
        for file in std::fs::read_dir(root.join(part)).unwrap() {
            let file = file.unwrap();
            std::fs::copy(file.path(), folder.path().join(part).join(file.file_name())).unwrap();
        }
    }
    let text = "extends = 'wagon-coco-134t-unpowered'\n[hand_brake]\nnet_braking_ratio = 0.1";
    std::fs::write(folder.path().join("vehicles/held.toml"), text).unwrap();
    let library = stock::Library::open(folder.path()).unwrap();
    let build = |text: &str| {
        let consist = Consist::from_toml(text, "consist.toml").unwrap();
        TrainDynamics::from_consist(&consist, &library, gradient(-20.0))
    };
    // 10 held wagons of 20 have 0.05 · 0.5568 of the weight: 27.8 permille, and 20 pull.
    for (share, stands) in [(1.0, true), (0.2, false)] {
        let mut train = build(&format!(
            "vehicle = [{{ type = 'held', count = 10, hand_brake = {share} }},
                        {{ type = 'held', count = 10 }}]"
        ))
        .unwrap();
        let mut state = start(&mut train, 0.0, Couplers::InBalance, Command::default());
        train.advance(&mut state, &Command::default(), 20.0);
        assert_eq!(state.vehicles.iter().all(|v| v.velocity == 0.0), stands);
    }
    let error = build("vehicle = [{ type = 'wagon-coco-134t-unpowered', hand_brake = 1 }]");
    assert!(matches!(error, Err(BuildError::NoHandBrake { number: 1, .. })));
}

const RESERVOIR: &str = "[brake.air.reservoir]\nrecharge_s = 50\nrecharge_s_per_km = 100\n";

/// Cylinder fractions of the first and the last of 51 vehicles after each of the commands.
///
/// The last vehicle is a kilometre behind the first. A command is a train brake and its time, s.
fn cylinders(keys: &str, reservoir: &str, commands: &[(f64, f64)]) -> Vec<[f64; 2]> {
    let mut train = air_train(&[0], 51, &format!("{keys}{RESERVOIR}{reservoir}"));
    let mut state = start(&mut train, 15.0, Couplers::InBalance, Command::default());
    let after = |&(command, time): &(f64, f64)| {
        train.advance(&mut state, &train_brake(command), time);
        [0, 50].map(|i| state.vehicles[i].brake.cylinder)
    };
    commands.iter().map(after).collect()
}

fn air_row(case: &str, value: f64, expected: f64) {
    Row {
        case,
        value,
        expected,
        unit: "of full service",
        source: "balance of the air by hand",
        tolerance: (5e-4, "a command arrives a step of 1 ms late; rates of up to 0.1/s"),
    }
    .holds(&PAGE);
}

/// The second application finds what the reservoirs have got back in 30 s: those at the head, with
/// 50 s, all but exp(−30/50); those a kilometre behind, with 150 s, get the release 5 s late and the
/// application 4 s late.
#[test]
fn analytic_reservoir_gives_what_it_has_got_back() {
    let twice = |second: f64| cylinders("", "", &[(0.6, 20.0), (0.0, 30.0), (second, 20.0)]);
    let [first, released, second] = twice(0.6)[..] else { unreachable!("three commands") };
    assert!(first.iter().all(|cylinder| (cylinder - 0.6).abs() < 1e-12));
    assert_eq!(released, [0.0, 0.0]);
    let lack = |time: f64, constant: f64| 0.6 * (-time / constant).exp();
    air_row("second application of 0.6, vehicle 1", second[0], 0.6 - lack(30.0, 50.0));
    air_row("second application of 0.6, vehicle 51", second[1], 0.6 - lack(29.0, 150.0));
    // 0.4 is less than the 0.49 that the last reservoir lacks.
    let second = twice(0.4)[2];
    air_row("second application of 0.4, vehicle 1", second[0], 0.4 - lack(30.0, 50.0));
    assert_eq!(second[1], 0.0);
}

#[test]
fn analytic_reservoir_with_leakage_of_the_pipe_brakes_more_and_more() {
    let leaking = cylinders("", "pipe_leakage_per_min = 0.3\n", &[(0.5, 60.0), (0.5, 60.0)]);
    air_row("0.5 after 60 s, pipe losing 0.3 a minute", leaking[0][0], 0.8);
    air_row("the same after 120 s: full service", leaking[1][0], 1.0);
}

/// Filled at 0.1/s for 5 s against a leakage of 1/300 s, and then left to leak.
#[test]
fn analytic_reservoir_does_not_make_up_for_a_leaking_cylinder() {
    let leaking = cylinders("", "cylinder_leakage_per_min = 0.2\n", &[(0.5, 60.0)]);
    let filled = 0.1 * 300.0 * (1.0 - (-5.0_f64 / 300.0).exp());
    let expected = filled * (-55.0_f64 / 300.0).exp();
    air_row("0.5 after 60 s, cylinder losing 0.2 a minute", leaking[0][0], expected);
}

#[test]
fn analytic_reservoir_at_the_end_of_a_leaking_pipe_has_less() {
    let ends = cylinders("", "gradient_per_km = 0.1\n", &[(0.5, 20.0), (1.0, 20.0), (1.2, 20.0)]);
    let expected = [[0.5, 0.5], [1.0, 0.9], [1.2, 1.08]];
    for (ends, expected) in ends.iter().zip(expected) {
        for (cylinder, expected) in ends.iter().zip(expected) {
            assert!((cylinder - expected).abs() < 1e-12, "{ends:?}");
        }
    }
}

/// A graduated release follows the pipe down and up again, with whatever air there is.
#[test]
fn analytic_reservoir_of_a_graduated_release() {
    let commands = [(0.6, 20.0), (0.3, 10.0), (0.5, 10.0)];
    let ends = cylinders("graduated_release = true\n", "", &commands);
    assert!((ends[1][0] - 0.3).abs() < 1e-12);
    // The lack has gone from 0.6 towards 0.3 for 10 s.
    let lack = 0.3 + 0.3 * (-10.0_f64 / 50.0).exp();
    let expected = 0.3 + (0.5 - lack).max(0.0);
    air_row("0.5 after a release from 0.6 to 0.3, vehicle 1", ends[2][0], expected);
}

/// The friction power of all wheels is the work against the brakes, times the wheels' share.
#[test]
fn analytic_heat_of_the_wheels_is_the_work_of_the_brakes() {
    let vehicle = vehicle_of("brake.wheel_heat_share = 0.9");
    let mut train = train(&vec![vehicle; 3], &friction_gear(), Track::straight());
    let mut state = start(&mut train, 15.0, Couplers::InBalance, train_brake(0.4));
    let mut heat = 0.0;
    let power = |train: &TrainDynamics, state: &TrainState| -> f64 {
        let pairs = train.vehicles().iter().zip(&state.vehicles);
        pairs.map(|(vehicle, state)| 12.0 * vehicle.wheel_brake_power(state)).sum()
    };
    for _ in 0..10_000 {
        let before = power(&train, &state);
        train.advance(&mut state, &train_brake(0.4), 1e-3);
        heat += (before + power(&train, &state)) / 2.0 * 1e-3;
    }
    Row {
        case: "heat of 36 wheels after 10 s of braking",
        value: heat,
        expected: 0.9 * state.work.brake,
        unit: "J",
        source: "work against the brakes",
        tolerance: (1e-9 * heat, "the same trapezoid, other order of the sum"),
    }
    .holds(&PAGE);
}
