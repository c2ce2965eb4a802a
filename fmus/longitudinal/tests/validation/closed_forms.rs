//! Closed forms of whole trains.

use crate::support::*;
use longitudinal::Command;
use longitudinal::{Couplers, LONGEST_STEP, TrainDynamics, TrainState};
use track::Track;

/// The force that the vehicles behind coupler `k` need: (mass behind)/(mass) of what accelerates
/// the train, and their own resistance, less their own traction.
fn uniform_acceleration_force(train: &TrainDynamics, state: &TrainState, k: usize) -> f64 {
    let totals = train.totals(state);
    let driving = totals.traction + totals.gravity + totals.resistance;
    let behind = &train.vehicles()[k + 1..];
    let mass_behind: f64 = behind.iter().map(|vehicle| vehicle.mass).sum();
    let own: f64 = state.vehicles[k + 1..]
        .iter()
        .map(|v| v.forces.resistance - v.forces.gravity - v.forces.traction)
        .sum();
    mass_behind / train.mass() * driving + own
}

#[test]
fn analytic_coupler_forces_of_uniform_acceleration() {
    let mut train = train(&block_train(2, 20), &friction_gear(), Track::straight());
    let mut state = start(&mut train, 15.0, Couplers::InBalance, notch(8.0));
    for k in [0, 1, 10, 20] {
        Row {
            case: &format!("coupler {} in balance at the start", k + 1),
            value: state.connections[k].force,
            expected: uniform_acceleration_force(&train, &state, k),
            unit: "N",
            source: "closed form",
            tolerance: (1e-6, "rounding of sums of 1e5 N"),
        }
        .holds(&PAGE);
    }
    train.advance(&mut state, &notch(8.0), 60.0);
    for k in [0, 1, 10, 20] {
        let expected = uniform_acceleration_force(&train, &state, k);
        Row {
            case: &format!("coupler {} after 60 s in notch 8", k + 1),
            value: state.connections[k].force,
            expected,
            unit: "N",
            source: "closed form",
            tolerance: (0.01 * expected, "friction in the gears may hold a small force back"),
        }
        .holds(&PAGE);
    }
}

#[test]
fn analytic_coupler_forces_at_balancing_speed_on_a_gradient() {
    let permille = 5.0;
    let mut train = train(&block_train(1, 20), &gear("elastic-tps"), gradient(permille));
    let mut state = start(&mut train, 16.0, Couplers::InBalance, notch(8.0));
    train.advance(&mut state, &notch(8.0), 1500.0);
    assert!(train.vehicles()[0].acceleration(&state.vehicles[0]).abs() < 1e-4);
    for k in [0, 10, 19] {
        let behind = &state.vehicles[k + 1..];
        let weight = 134e3 * 9.80665 * permille * 1e-3;
        let expected: f64 = behind.iter().map(|v| weight + v.forces.resistance).sum();
        Row {
            case: &format!("coupler {} at steady speed on 5 permille", k + 1),
            value: state.connections[k].force,
            expected,
            unit: "N",
            source: "closed form",
            tolerance: (1e-3 * expected, "what is left of the acceleration after 1500 s"),
        }
        .holds(&PAGE);
    }
}

/// Slack, impacts, traction, brake and gradients: everything that books energy at once.
#[test]
fn analytic_energy_balance_of_a_rough_run() {
    let track = "gradient = [{ chainage_m = 0, permille = -8 }, { chainage_m = 700, permille = 8 },
                             { chainage_m = 1500, permille = 0 }]
                 alignment = [{ length_m = 400 }, { length_m = 800, radius_m = 300 }]";
    let track = Track::from_toml(track, "track").unwrap();
    let mut train = train(&block_train(2, 60), &friction_gear(), track);
    let mut state = start(&mut train, 10.0, Couplers::Unstressed, Command::default());
    let brake = Command { dynamic_brake: 1.0, ..train_brake(0.4) };
    for (command, time) in [(notch(8.0), 60.0), (Command::default(), 10.0), (brake, 40.0)] {
        let mut greatest = 0.0_f64;
        for _ in 0..(time / LONGEST_STEP).round() as usize {
            train.advance(&mut state, &command, LONGEST_STEP);
            let residual = train.energy_residual(&state, &train.energy(&state));
            let work = &state.work;
            let done = work.traction
                + work.dynamic_brake
                + work.brake
                + work.resistance
                + work.curve_resistance
                + state.gear_work;
            greatest = greatest.max((residual / done).abs());
        }
        Row {
            case: &format!("greatest energy residual of any step in {time} s more"),
            value: greatest,
            expected: 0.0,
            unit: "of the work done",
            source: "conservation of energy",
            tolerance: (1e-4, "integration errors only"),
        }
        .holds(&PAGE);
    }
    assert!(state.gear_work > 0.0 && state.work.dynamic_brake > 0.0 && state.work.brake > 0.0);
}

/// Friction holds a stopped train without any creep, whatever the step.
#[test]
fn analytic_braked_train_stops_and_stands_on_a_gradient() {
    for step in [1e-4, 1e-3, 1e-2] {
        let mut train = train(&block_train(2, 20), &friction_gear(), gradient(10.0));
        let mut state = start(&mut train, 5.0, Couplers::InBalance, train_brake(1.0));
        for _ in 0..(30.0 / step) as usize {
            train.advance(&mut state, &train_brake(1.0), step);
        }
        let stopped: Vec<f64> = state.vehicles.iter().map(|v| v.position).collect();
        for _ in 0..(5.0 / step) as usize {
            train.advance(&mut state, &train_brake(1.0), step);
        }
        for (i, stopped) in stopped.into_iter().enumerate() {
            let vehicle = &state.vehicles[i];
            assert_eq!((vehicle.velocity, vehicle.position), (0.0, stopped));
            assert_eq!(train.vehicles()[i].acceleration(vehicle), 0.0);
        }
    }
}
