//! Closed forms of whole trains, and published figures by hand.

use std::sync::Arc;

use crate::support::*;
use longitudinal::connection::{Connection, ConnectionState, GearPair};
use longitudinal::driver::Command;
use longitudinal::{Couplers, LONGEST_STEP, TrainDynamics, TrainState, draft_gear};
use stock::Vehicle;
use track::Track;

const KMH: f64 = 1.0 / 3.6;

/// Resistance of all vehicles at their velocities, N.
fn resistance(train: &TrainDynamics, state: &TrainState) -> f64 {
    -train.totals(state).resistance
}

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
        .holds();
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
        .holds();
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
        .holds();
    }
}

/// Two vehicles that run into each other are slowest to one another when both gears have taken
/// the energy of their relative motion, ½ (m/2) v².
#[test]
fn analytic_peak_force_of_an_impact_of_two_vehicles() {
    let vehicles = vec![without_resistance(wagon()); 2];
    let gear = friction_gear();
    for speed in [0.3, 1.0, 1.5_f64] {
        let mut train = train(&vehicles, &gear, Track::straight());
        let command = Command::default();
        let mut state = start(&mut train, 1.0, Couplers::Unstressed, command);
        state.vehicles[1].velocity += speed;
        let mut peak = 0.0_f64;
        for _ in 0..1000 {
            train.advance(&mut state, &command, 1e-3);
            peak = peak.max(-state.connections[0].force);
        }
        let energy_kj = 0.5 * (134e3 / 2.0) * speed.powi(2) * 1e-3;
        let deflection = inverse(|x| 2.0 * gear.draft.loading.energy_to_kj(x), energy_kj, 74.4);
        let expected = gear.draft.loading.force_at_kn(deflection) * 1e3;
        Row {
            case: &format!("peak force of an impact at {speed} m/s"),
            value: peak,
            expected,
            unit: "N",
            source: "closed form",
            tolerance: (0.005 * expected, "the peak may lie between two steps of 1 ms"),
        }
        .holds();
    }
}

/// The argument from 0 to `greatest` at which a rising function has a value.
fn inverse(function: impl Fn(f64) -> f64, value: f64, greatest: f64) -> f64 {
    let (mut low, mut high) = (0.0, greatest);
    for _ in 0..80 {
        let middle = (low + high) / 2.0;
        match function(middle) < value {
            true => low = middle,
            false => high = middle,
        }
    }
    low
}

fn connection(slack: f64) -> Connection {
    let gear = draft_gear::DraftGear::new(&friction_gear()).unwrap();
    Connection::new(Arc::new(GearPair::new(&gear, &gear)), slack, 20.0)
}

/// Moves a connection evenly to a deflection and gives the work done on it.
fn push(connection: &mut Connection, state: &mut ConnectionState, to: f64) -> f64 {
    let (from, steps) = (state.deflection, 20_000);
    let at = |i: i32| from + (to - from) * f64::from(i) / f64::from(steps);
    (1..=steps).map(|i| connection.move_to(state, at(i), 0.0)).sum()
}

#[test]
fn analytic_energy_of_a_closed_cycle_of_the_gears() {
    let (gear, slack, travel) = (friction_gear(), 0.02, 0.060);
    let mut connection = connection(slack);
    let mut state = ConnectionState::default();
    let deflection = slack / 2.0 + 2.0 * travel;
    let loaded = push(&mut connection, &mut state, deflection);
    Row {
        case: "energy taken by two gears pushed in by 60 mm each",
        value: loaded,
        expected: 2e3 * gear.draft.loading.energy_to_kj(60.0),
        unit: "J",
        source: "area under the loading curve",
        tolerance: (20.0, "corners of the curve cut by 20000 steps"),
    }
    .holds();
    let dissipated = loaded + push(&mut connection, &mut state, 0.0);
    // Coming out, the force falls along the locked stiffness (200 N/µm) to the unloading curve.
    let force = gear.draft.loading.force_at_kn(60.0);
    let locked = |x: f64| force - gear.draft.locked_stiffness_mn_m * (60.0 - x);
    let unloading = &gear.draft.unloading;
    let meets = inverse(|x| locked(x) - unloading.force_at_kn(x), 0.0, 60.0);
    let given_back =
        unloading.energy_to_kj(meets) + (force + locked(meets)) / 2.0 * (60.0 - meets) * 1e-3;
    let expected = 2e3 * (gear.draft.loading.energy_to_kj(60.0) - given_back);
    Row {
        case: "energy kept by the gears in a closed cycle",
        value: dissipated,
        expected,
        unit: "J",
        source: "area between the curves",
        tolerance: (1e-3 * expected, "corners of the curves cut by 20000 steps"),
    }
    .holds();
    assert_eq!(state.force, 0.0);
}

/// On any path a gear gives back no more than it has stored, and never has less than nothing.
#[test]
fn property_gears_never_create_energy() {
    let mut connection = connection(0.02);
    let mut state = ConnectionState::default();
    let (mut work, mut dissipated, mut seed) = (0.0, 0.0, 1_u64);
    for _ in 0..200 {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let to = ((seed >> 40) as f64 / (1_u64 << 24) as f64 - 0.5) * 0.32;
        work += push(&mut connection, &mut state, to);
        let stored = connection.stored_energy(&state);
        // 1 J: corners cut by the steps, of 1e5 J that go in and out.
        assert!(stored >= 0.0 && work - stored >= dissipated - 1.0, "{work} {stored} {dissipated}");
        dissipated = work - stored;
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
            tolerance: (1e-4, "what the issue asks for; integration errors only"),
        }
        .holds();
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

/// Source: Cole's formula by hand, project reference 3.1: 187 kN for four axles a vehicle, 210 kN
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
            tolerance: (500.0, "rounding of the published figure"),
        }
        .holds();
    }
}

/// Source: 17 420 t times g, project reference 1.7: 170.9 kN (with g = 9.81 m/s²).
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
    .holds();
}

/// Source: issue 2, by hand: 2 × 3207 kW, 85 to 100 % at the rail, ALTRIOS's notch fractions:
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
            source: "issue 2",
            tolerance: (500.0, "rounding of the published figure"),
        }
        .holds();
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

/// Source: project reference 1.7, computed for the Canadian National formula with loaded gondolas
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
            source: "project reference 1.7",
            tolerance: (0.1, "rounding of the published figure, of g and of the mass"),
        }
        .holds();
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
        .holds();
    }
}
