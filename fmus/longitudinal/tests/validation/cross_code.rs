//! Case A of the Train Propulsion Simulator, an independent program, complete up to its first brake
//! application: `scenarios/benchmarks/tps-a`.
//!
//! Source of inputs and results: its shipped example `My_TPS_Input_File.txt`, run with build 1.01.01 and
//! variable step. Tolerances: the speeds drift apart by up to 0.037 m/s for a cause that was not found;
//! two programs whose couplers swing differently agree in a peak within some per cent.

use std::path::Path;

use crate::support::*;
use longitudinal::driver::Driver;
use longitudinal::driver::view::View;
use longitudinal::{Couplers, Start, TrainDynamics};
use stock::Consist;
use track::Track;

const CASE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/benchmarks/tps-a");

/// 528 ft, the length of the train and half a locomotive after the origin of the track.
const START: f64 = 702.716;

/// Speed at times, s, m/s.
const SPEEDS: [(f64, f64); 10] = [
    (30.0, 20.7252),
    (60.0, 18.3354),
    (120.0, 13.0230),
    (180.0, 9.0766),
    (240.0, 7.0726),
    (300.0, 6.7464),
    (420.0, 8.3581),
    (540.0, 12.0469),
    (700.0, 21.0223),
    (800.0, 32.2268),
];

/// Greatest tension of couplers, counted from 1, kN.
const TENSIONS: [(usize, f64); 9] = [
    (1, 273.1),
    (2, 262.4),
    (3, 250.8),
    (5, 227.3),
    (10, 164.4),
    (15, 99.5),
    (20, 47.2),
    (25, 37.8),
    (29, 10.1),
];

#[test]
fn benchmark_case_a_of_the_train_propulsion_simulator() {
    let file = |name: &str| Path::new(CASE).join(name);
    let consist = Consist::from_file(&file("consist.toml")).unwrap();
    let track = Track::from_file(&file("track.toml")).unwrap();
    let driver = Driver::from_file(&file("driver.toml")).unwrap();
    let mut train = TrainDynamics::from_consist(&consist, &library(), track).unwrap();
    let (mut own, step) = (driver.start(), 1e-3);
    let view = View { time: 0.0, chainage: START, velocity: 22.352, train: None };
    let mut state = train.start(&Start {
        position: START,
        velocity: view.velocity,
        couplers: Couplers::Unstressed,
        applied: driver.command(&mut own, &view, step),
    });
    let mut greatest = vec![0.0_f64; consist.types.len() - 1];
    let mut k = 0_u32;
    for (time, expected) in SPEEDS {
        while f64::from(k) * step < time - step / 2.0 {
            let leader = state.vehicles[0];
            let (chainage, velocity) = (leader.position, leader.velocity);
            let view = View { time: f64::from(k) * step, chainage, velocity, train: None };
            let command = driver.command(&mut own, &view, step);
            train.advance(&mut state, &command, step);
            for (greatest, connection) in greatest.iter_mut().zip(&state.connections) {
                *greatest = greatest.max(connection.force * 1e-3);
            }
            k += 1;
        }
        Row {
            case: &format!("speed after {time} s"),
            value: state.vehicles[0].velocity,
            expected,
            unit: "m/s",
            source: "Train Propulsion Simulator, case A",
            tolerance: (0.05, "a third more than the speeds drift apart"),
        }
        .holds(&PAGE);
    }
    assert!(state.vehicles[0].position < 12_874.8, "the brake is not yet applied");
    for (coupler, expected) in TENSIONS {
        Row {
            case: &format!("greatest tension of coupler {coupler}"),
            value: greatest[coupler - 1],
            expected,
            unit: "kN",
            source: "Train Propulsion Simulator, case A",
            tolerance: (
                0.05 * expected,
                "5 %: couplers swing differently, TPS keeps steps of up to 20 ms",
            ),
        }
        .holds(&PAGE);
    }
}
