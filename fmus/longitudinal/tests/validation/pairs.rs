//! Two vehicles: impacts, and oscillations on their connection.

use longitudinal::Command;
use longitudinal::{Couplers, TrainDynamics, TrainState};
use stock::DraftGear;
use track::Track;

use crate::gears::WEDGE;
use crate::support::*;

/// The peak force between two vehicles that run into each other, N.
fn impact(gear: &DraftGear, speed: f64) -> f64 {
    let vehicles = vec![without_resistance(wagon()); 2];
    let mut train = train(&vehicles, gear, Track::straight());
    train.check_step().unwrap();
    let mut state = start(&mut train, 1.0, Couplers::Unstressed, Command::default());
    state.vehicles[1].velocity += speed;
    let mut peak = 0.0_f64;
    for _ in 0..1000 {
        train.advance(&mut state, &Command::default(), 1e-3);
        peak = peak.max(-state.connections[0].force);
    }
    peak
}

/// In an impact of two vehicles both gears take the energy of their relative motion, ½ (m/2) v².
#[test]
fn analytic_peak_force_of_an_impact_of_two_vehicles() {
    let gear = friction_gear();
    for speed in [0.3, 1.0, 1.5_f64] {
        let energy_kj = 0.5 * (134e3 / 2.0) * speed.powi(2) * 1e-3;
        let deflection = inverse(|x| 2.0 * gear.draft.loading.energy_to_kj(x), energy_kj, 74.4);
        let expected = gear.draft.loading.force_at_kn(deflection) * 1e3;
        Row {
            case: &format!("peak force of an impact at {speed} m/s"),
            value: impact(&gear, speed),
            expected,
            unit: "N",
            source: "closed form",
            tolerance: (0.005 * expected, "the peak may lie between two steps of 1 ms"),
        }
        .holds(&PAGE);
    }
}

/// An impact with the blended law has the peak of the clamped one: both are on the loading curve
/// until the gears are slower than the transition speed.
#[test]
fn analytic_impact_with_a_blended_law() {
    let blended = WEDGE.replace("[loading]", "transition_speed_mm_s = 10\n[loading]");
    let (clamped, blended) = (impact(&gear_of(WEDGE), 1.0), impact(&gear_of(&blended), 1.0));
    Row {
        case: "peak force of an impact at 1 m/s, curves blended over 20 mm/s",
        value: blended,
        expected: clamped,
        unit: "N",
        source: "the clamped law",
        tolerance: (0.02 * clamped, "1/2 (v_e/v)² of the energy, and 20 ms on the way down"),
    }
    .holds(&PAGE);
}

/// A drawbar is a spring without slack: two vehicles oscillate with ω² = 2 K/m, K of two in series.
#[test]
fn analytic_drawbar_between_two_vehicles_oscillates() {
    let text = "name = 'bar'\nsource = 'test'\n[drawbar]\nstiffness_mn_m = 200\n";
    let (mut train, mut state) = wagons_without_slack(2, &gear_of(text), 0.1);
    let (mut crossings, mut times, mut before) = (0, vec![], 0.0);
    for k in 1..=4000 {
        train.advance(&mut state, &Command::default(), 1e-3);
        let now = state.connections[0].deflection;
        if before < 0.0 && now >= 0.0 {
            crossings += 1;
            times.push(f64::from(k) * 1e-3 - now / (now - before) * 1e-3);
        }
        before = now;
    }
    let period = (times[crossings - 1] - times[0]) / (crossings - 1) as f64;
    let expected = 2.0 * std::f64::consts::PI / (2.0 * 100e6 / 134e3_f64).sqrt();
    Row {
        case: "period of two vehicles on a drawbar",
        value: period,
        expected,
        unit: "s",
        source: "closed form",
        tolerance: (1e-3 * expected, "(ωh)²/24 = 6e-5 of the step, and its interpolation"),
    }
    .holds(&PAGE);
}

/// A damped elastic connection loses the energy c ω π A² of each period: the amplitude falls with
/// exp(−c t/m).
#[test]
fn analytic_elastic_gear_with_damping() {
    let text = "name = 'damped'\nsource = 'test'\ndamping_kn_s_m = 100\nstructure_stiffness_mn_m = 50\n\
        [loading]\ndeflection_mm = [0, 50]\nforce_kn = [0, 2500]\n";
    let (mut train, mut state) = wagons_without_slack(2, &gear_of(text), 0.1);
    let energy = |train: &TrainDynamics, state: &TrainState| {
        let relative = state.vehicles[0].velocity - state.vehicles[1].velocity;
        train.energy(state).stored + 134e3 / 4.0 * relative * relative
    };
    let first = energy(&train, &state);
    train.advance(&mut state, &Command::default(), 3.0);
    // The two gears in series have 50 kN s/m; the relative motion has the mass m/2.
    let expected = (-50e3 / (134e3 / 2.0) * 3.0_f64).exp();
    Row {
        case: "energy that damped gears leave after 3 s",
        value: energy(&train, &state) / first,
        expected,
        unit: "of the first",
        source: "closed form",
        tolerance: (0.02 * expected, "c/(m ω) = 2 % within a period"),
    }
    .holds(&PAGE);
}
