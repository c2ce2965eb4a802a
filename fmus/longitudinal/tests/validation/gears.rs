//! Kinds of draft gears.

use std::sync::Arc;

use longitudinal::TrainDynamics;
use longitudinal::coupling::connection::{Connection, ConnectionState, GearPair};
use longitudinal::coupling::draft_gear::DraftGear;
use track::Track;

use crate::support::*;

/// A spring of 10 MN/m behind a friction wedge with the preload of 50 kN.
pub const WEDGE: &str = "name = 'wedge'\nsource = 'test'\n\
    locked_stiffness_mn_m = 400\nstructure_stiffness_mn_m = 200\n\
    [loading]\ndeflection_mm = [0, 80]\nforce_kn = [50, 850]\n\
    [wedge]\nangle_deg = 50\nwedge_friction = 0.1\nhousing_friction = 0.3\n";

const POLYMER: &str = "name = 'polymer'\nsource = 'test'\nloss_percent = 40\n\
    locked_stiffness_mn_m = 60\nstructure_stiffness_mn_m = 50\n\
    [loading]\ndeflection_mm = [0, 40, 70]\nforce_kn = [20, 400, 1200]\n";

const CUSHION: &str = "name = 'cushion'\nsource = 'test'\n\
    structure_stiffness_mn_m = 100\nlocked_stiffness_mn_m = 150\n\
    [loading]\ndeflection_mm = [0, 250]\nforce_kn = [100, 150]\n\
    [orifice]\ndeflection_mm = [0, 250]\nresistance_kn_s2_m2 = [300, 900]\n";

const BUFFERS: &str = "name = 'screw coupling'\nsource = 'test'\nloss_percent = 60\n\
    locked_stiffness_mn_m = 80\nstructure_stiffness_mn_m = 50\n\
    [loading]\ndeflection_mm = [0, 50]\nforce_kn = [10, 500]\n\
    [buff]\ncount = 2\nloss_percent = 50\nlocked_stiffness_mn_m = 40\nstructure_stiffness_mn_m = 30\n\
    [buff.loading]\ndeflection_mm = [0, 105]\nforce_kn = [10, 600]\n";

fn connection(front: &str, rear: &str) -> Connection {
    connection_of(&gear_of(front), &gear_of(rear), 0.0)
}

fn connection_of(front: &stock::DraftGear, rear: &stock::DraftGear, slack: f64) -> Connection {
    let gear = |stock: &stock::DraftGear| DraftGear::new(stock).unwrap();
    Connection::new(Arc::new(GearPair::new(&gear(front), &gear(rear))), slack, 20.0)
}

/// Moves a connection evenly to a deflection, m, at a speed, m/s; gives the work done on it, J.
fn push(connection: &mut Connection, state: &mut ConnectionState, to: f64, speed: f64) -> f64 {
    let (from, steps) = (state.deflection, 20_000);
    let at = |i: i32| from + (to - from) * f64::from(i) / f64::from(steps);
    let speed = speed * (to - from).signum();
    (1..=steps).map(|i| connection.move_to(state, at(i), speed)).sum()
}

/// Forces of a wedge gear pushed in and coming out: spring force times the ratios of the statics
/// (Cole 2006, chapter 9), by hand for φ = 50°, μ₁ = 0.1, μ₂ = 0.3.
#[test]
fn analytic_wedge_gear_follows_its_statics() {
    let mut both = connection(WEDGE, WEDGE);
    let mut state = ConnectionState::default();
    // Preload comes up over F/K of the structure: each gear's own 40 mm lie behind that.
    let tan = 50.0_f64.to_radians().tan();
    let ratio_in = 1.0 / (1.0 - 0.3 * (1.0 - 0.1 * tan) / (tan + 0.1));
    let ratio_out = 1.0 / (1.0 + 0.3 * (1.0 + 0.1 * tan) / (tan - 0.1));
    let preloaded = 50e3 * ratio_in / 200e6;
    push(&mut both, &mut state, -2.0 * (preloaded + 0.040), 0.0);
    let row = |case: &str, value: f64, expected: f64| {
        Row {
            case,
            value,
            expected,
            unit: "N",
            source: "statics of the wedge",
            tolerance: (1e-6 * expected, "rounding"),
        }
        .holds(&PAGE);
    };
    row("wedge gears pushed in by 40 mm each", -state.force, 450e3 * ratio_in);
    push(&mut both, &mut state, -2.0 * (preloaded + 0.030), 0.0);
    row("the same coming out to 30 mm each", -state.force, 350e3 * ratio_out);
    push(&mut both, &mut state, 0.0, 0.0);
    assert_eq!(state.force, 0.0);
}

/// Two gears of different kinds in series carry the same force: their deflections add.
#[test]
fn analytic_mixed_gears_in_series_add_their_deflections() {
    let mut mixed = connection(WEDGE, POLYMER);
    let (mut wedges, mut polymers) = (connection(WEDGE, WEDGE), connection(POLYMER, POLYMER));
    for force in [-30e3, -200e3, -600e3, -1500e3, 400e3] {
        let half = |c: &Connection| c.loaded_to(force).deflection / 2.0;
        let expected = half(&wedges) + half(&polymers);
        assert!((mixed.loaded_to(force).deflection - expected).abs() < 1e-12);
        let mut state = ConnectionState::default();
        push(&mut mixed, &mut state, expected, 0.0);
        assert!((state.force / force - 1.0).abs() < 1e-9, "{} {force}", state.force);
    }
    assert!(wedges.front_loss_share() == 0.5 && polymers.front_loss_share() == 0.5);
    let share = mixed.front_loss_share();
    assert!(share > 0.0 && share < 1.0 && share != 0.5);
    let mut state = ConnectionState::default();
    push(&mut wedges, &mut state, 0.01, 0.0);
    push(&mut polymers, &mut state, 0.01, 0.0);
}

#[test]
fn analytic_energy_of_a_closed_cycle_of_the_gears() {
    let (gear, slack, travel) = (friction_gear(), 0.02, 0.060);
    let mut connection = connection_of(&gear, &gear, slack);
    let mut state = ConnectionState::default();
    let deflection = slack / 2.0 + 2.0 * travel;
    let loaded = push(&mut connection, &mut state, deflection, 0.0);
    Row {
        case: "energy taken by two gears pushed in by 60 mm each",
        value: loaded,
        expected: 2e3 * gear.draft.loading.energy_to_kj(60.0),
        unit: "J",
        source: "area under the loading curve",
        tolerance: (20.0, "corners of the curve cut by 20000 steps"),
    }
    .holds(&PAGE);
    let dissipated = loaded + push(&mut connection, &mut state, 0.0, 0.0);
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
    .holds(&PAGE);
    assert_eq!(state.force, 0.0);
}

/// Each kind gives back no more than it took, on any path and at any speed.
#[test]
fn property_no_kind_of_gear_creates_energy() {
    let shipped = friction_gear();
    let mut kinds = vec![("the paper's", connection_of(&shipped, &shipped, 0.02))];
    kinds.extend([WEDGE, POLYMER, CUSHION, BUFFERS].map(|text| (text, connection(text, text))));
    for (kind, mut connection) in kinds {
        let mut state = ConnectionState::default();
        let (mut work, mut heat, mut seed) = (0.0, 0.0, 7_u64);
        for _ in 0..200 {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let random = (seed >> 40) as f64 / (1_u64 << 24) as f64 - 0.5;
            work += push(&mut connection, &mut state, random * 0.32, 0.2);
            let stored = connection.stored_energy(&state);
            // 1 J: corners cut by the steps, of 1e5 J that go in and out.
            assert!(stored >= 0.0 && work - stored >= heat - 1.0, "{kind}: {work} {stored} {heat}");
            heat = work - stored;
        }
        assert!(heat > 0.0);
    }
}

/// A cushion's force at a speed: that of its spring and C (v/2)² of each of two in series, by hand
/// at 125 mm each: 125 + 600 · 0.5² = 275 kN.
#[test]
fn analytic_cushion_resists_with_the_square_of_the_speed() {
    let mut both = connection(CUSHION, CUSHION);
    let mut state = ConnectionState::default();
    // The preload of 100 kN comes up over 1 mm each.
    push(&mut both, &mut state, -2.0 * 0.126, 1.0);
    // The orifice is given over the deflection with that millimetre: 602.4 kN s²/m².
    let expected = 125e3 + 602.4e3 * 0.25;
    assert!((-state.force / expected - 1.0).abs() < 1e-9, "{}", state.force);
}

#[test]
fn analytic_buffers_in_buff_and_coupling_in_draft() {
    let mut both = connection(BUFFERS, BUFFERS);
    for (force, stiffness, preload) in
        [(-500e3, 2.0 * 590e3 / 0.105, 20e3), (300e3, 490e3 / 0.050, 10e3)]
    {
        let deflection = both.loaded_to(force).deflection;
        let structure = if force < 0.0 { 60e6 } else { 50e6 };
        let each = preload / structure + (force.abs() - preload) / stiffness;
        assert!((deflection.abs() - 2.0 * each).abs() < 1e-12);
        let mut state = ConnectionState::default();
        push(&mut both, &mut state, deflection, 0.0);
        assert!((state.force / force - 1.0).abs() < 1e-9);
    }
}

/// Over a transition speed the force is on the curves outside of it, and between them inside.
#[test]
fn analytic_transition_speed_blends_the_curves() {
    let smooth = WEDGE.replace("[loading]", "transition_speed_mm_s = 10\n[loading]");
    let (mut smooth, mut clamped) = (connection(&smooth, &smooth), connection(WEDGE, WEDGE));
    let (mut a, mut b) = (ConnectionState::default(), ConnectionState::default());
    // Two gears in series share the speed: 20 mm/s in all.
    push(&mut smooth, &mut a, -0.08, 0.05);
    push(&mut clamped, &mut b, -0.08, 0.05);
    let loading = b.force;
    assert!((a.force / loading - 1.0).abs() < 1e-12);
    smooth.move_to(&mut a, -0.08, 0.05);
    let unloading = a.force;
    smooth.move_to(&mut a, -0.08, 0.01);
    let halfway = loading + 0.75 * (unloading - loading);
    assert!((a.force / halfway - 1.0).abs() < 1e-12);
}

/// A screw coupling does not couple to an automatic one; a pair on a drawbar couples inside.
#[test]
fn vehicles_whose_couplers_do_not_fit_are_refused() {
    let couple = |front: &str, rear: &str| {
        let vehicles = [vehicle_of(front), vehicle_of(rear)];
        let gear = friction_gear();
        TrainDynamics::new(vehicles.iter().map(|v| (v, &gear)), Track::straight()).map(|_| ())
    };
    let message = couple("coupler.kind = 'screw'", "").unwrap_err().to_string();
    assert!(message.contains("vehicles 1 and 2 of the consist do not fit"), "{message}");
    assert!(message.contains("\"screw\"") && message.contains("\"automatic\""), "{message}");
    let with_bar = "coupler.rear = { kind = 'drawbar', draft_gear = 'elastic-tps', slack_mm = 0 }";
    assert!(couple(with_bar, "coupler.kind = 'drawbar'").is_ok());
}
