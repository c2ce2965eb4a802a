//! Resistance, traction and what speed comes of them, against published figures and one mass.

use longitudinal::Command;
use longitudinal::{Couplers, TrainDynamics, TrainState};
use stock::Vehicle;
use track::Track;

use crate::support::*;

const KMH: f64 = 1.0 / 3.6;

/// Resistance of all vehicles at their velocities, N.
fn resistance(train: &TrainDynamics, state: &TrainState) -> f64 {
    -train.totals(state).resistance
}
/// Source: Cole's formula by hand: 187 kN for four axles a vehicle, 210 kN
/// for six, for the paper's 130 vehicles at 60 km/h.
#[test]
fn benchmark_resistance_of_the_train_at_60_kmh() {
    for (axles, expected) in [(4, 187e3), (6, 210e3)] {
        let mut vehicles = block_train(2, 128);
        vehicles.iter_mut().for_each(|vehicle| vehicle.axles = axles);
        let mut train = train(&vehicles, &friction_gear(), Track::straight());
        let state = start(&mut train, 60.0 * KMH, Couplers::InBalance, Command::default());
        Row {
            case: &format!("resistance of 130 vehicles with {axles} axles at 60 km/h"),
            value: resistance(&train, &state),
            expected,
            unit: "N",
            source: "Cole 2006 by hand",
            tolerance: (500.0, "rounding of the figure"),
        }
        .holds(&PAGE);
    }
}

/// Source: 17 420 t times g: 170.9 kN (with g = 9.81 m/s²).
#[test]
fn benchmark_force_of_a_gradient_of_one_permille() {
    let mut train = train(&block_train(2, 128), &friction_gear(), gradient(1.0));
    let state = start(&mut train, 10.0, Couplers::InBalance, Command::default());
    Row {
        case: "force of one permille on 17 420 t",
        value: -train.totals(&state).gravity,
        expected: 170.9e3,
        unit: "N",
        source: "m g i",
        tolerance: (100.0, "rounding of g"),
    }
    .holds(&PAGE);
}

/// Source: power over speed by hand: 2 × 3207 kW, 85 to 100 % at the rail, ALTRIOS's notch fractions:
/// 173 to 203 kN in notch 5 and 327 to 385 kN in notch 8 at 60 km/h.
#[test]
fn benchmark_traction_in_notches_5_and_8() {
    let published = [(5.0, 0.85, 173e3), (5.0, 1.0, 203e3), (8.0, 0.85, 327e3), (8.0, 1.0, 385e3)];
    for (step, efficiency, expected) in published {
        let mut vehicles = block_train(2, 0);
        for vehicle in &mut vehicles {
            vehicle.traction.as_mut().unwrap().efficiency = efficiency;
        }
        let mut train = train(&vehicles, &friction_gear(), Track::straight());
        let state = start(&mut train, 60.0 * KMH, Couplers::InBalance, notch(step));
        Row {
            case: &format!("two locomotives in notch {step}, {efficiency} at the rail"),
            value: train.totals(&state).traction,
            expected,
            unit: "N",
            source: "power over speed by hand",
            tolerance: (500.0, "rounding of the figure"),
        }
        .holds(&PAGE);
    }
}

/// Canadian National formula in N, t, km/h: lb per short ton 1.5 + 18 n/W + 0.03 V + C A V²/10⁴W,
/// with `drag` = C A in ft².
fn canadian_national(mut vehicle: Vehicle, axles: u32, drag: f64) -> Vehicle {
    let (pound, short_ton, mile) = (4.448_222, 0.907_184_74, 1.609_344);
    vehicle.axles = axles;
    vehicle.resistance.constant_n_per_t = 1.5 * pound / short_ton;
    vehicle.resistance.axle_n = 18.0 * pound;
    vehicle.resistance.linear_n_per_t_kmh = 0.03 * pound / short_ton / mile;
    vehicle.resistance.quadratic_n_per_kmh2 = drag * 1e-4 * pound / (mile * mile);
    if let Some(traction) = &mut vehicle.traction {
        traction.adhesion = None;
    }
    vehicle
}

/// Source: computed by hand for the Canadian National formula with loaded gondolas
/// (four axles, 105 ft², C 4.2), a leading and a trailing locomotive (160 ft², C 24.0 and 5.5),
/// 2 × 3207 kW × 0.85 and no limit of adhesion.
#[test]
fn benchmark_balancing_speeds_of_the_train() {
    let wagon = canadian_national(wagon(), 4, 105.0 * 4.2);
    let mut vehicles = vec![
        canadian_national(locomotive(), 6, 160.0 * 24.0),
        canadian_national(locomotive(), 6, 160.0 * 5.5),
    ];
    vehicles.extend(std::iter::repeat_n(wagon, 128));
    let published = [(0.0, 63.0), (1.0, 45.2), (2.0, 34.0), (3.0, 26.8), (4.0, 22.0)];
    for (permille, expected) in published {
        let train = train(&vehicles, &friction_gear(), gradient(permille));
        let surplus = |kmh: f64| {
            let state = start(&mut train.clone(), kmh * KMH, Couplers::Unstressed, notch(8.0));
            let totals = train.totals(&state);
            totals.traction + totals.gravity + totals.resistance
        };
        Row {
            case: &format!("balancing speed on {permille} permille"),
            value: inverse(|kmh| -surplus(kmh), 0.0, 120.0),
            expected,
            unit: "km/h",
            source: "Canadian National's formula by hand",
            tolerance: (0.1, "rounding of the figure, of g and of the mass"),
        }
        .holds(&PAGE);
    }
}

/// The paper's train on straight level track against one mass with the same forces.
///
/// Its four cases start at 60 km/h and last 200 s. Source of the expectation: Heun's method on
/// m dv/dt = T(v) − R(v). The paper itself says "almost constant speed" for notch 5 and "almost
/// 2 m/s" more for notch 8 (table 5).
#[test]
fn analytic_speed_of_the_paper_s_train_after_200_s() {
    for step in [5.0, 7.0, 8.0] {
        let vehicles = block_train(2, 128);
        let mut train = train(&vehicles, &friction_gear(), Track::straight());
        let mut state = start(&mut train, 16.67, Couplers::InBalance, notch(step));
        train.advance(&mut state, &notch(step), 200.0);

        let power: f64 = [0.0, 0.0676, 0.1353, 0.2794, 0.3935, 0.5275, 0.6940, 0.8487, 1.0]
            [step as usize]
            * 2.0
            * 3207e3
            * 0.85;
        let (tonnes, axles) = (134.0 * 130.0, 6.0 * 130.0);
        let acceleration = |v: f64| {
            let kmh = v * 3.6;
            let resistance =
                2.943 * tonnes + 89.2 * axles + 0.0306 * tonnes * kmh + 0.12187 * 130.0 * kmh * kmh;
            (power / v - resistance) / (tonnes * 1e3)
        };
        let (mut v, h) = (16.67, 0.1);
        for _ in 0..2000 {
            let euler = v + h * acceleration(v);
            v += h * (acceleration(v) + acceleration(euler)) / 2.0;
        }
        Row {
            case: &format!("change of speed in 200 s in notch {step}"),
            value: train.totals(&state).velocity - 16.67,
            expected: v - 16.67,
            unit: "m/s",
            source: "one mass",
            tolerance: (1e-4, "exchange of speed between vehicles as the couplers settle"),
        }
        .holds(&PAGE);
    }
}
