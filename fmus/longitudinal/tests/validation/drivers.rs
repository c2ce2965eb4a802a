//! Drivers who control the speed or repeat a logger, and remote locomotives.

use files::Mistake;
use longitudinal::Command;
use longitudinal::driver::Driver;
use longitudinal::driver::state::DriverState;
use longitudinal::driver::view::View;
use longitudinal::{Couplers, TrainDynamics, TrainState};
use track::Track;

use crate::support::*;

const KMH: f64 = 1.0 / 3.6;

/// Driver of the text of a file, with further files beside it.
pub fn driver(text: &str, others: &[(&str, &str)]) -> Result<Driver, Mistake> {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("driver.toml", text);
    others.iter().for_each(|(name, text)| write(name, text));
    Driver::from_file(&folder.path().join("driver.toml"))
}

/// Runs a train with a driver and calls `see` after each step of 10 ms.
fn run(
    driver: &Driver,
    train: &mut TrainDynamics,
    state: &mut TrainState,
    time: f64,
    mut see: impl FnMut(f64, &TrainState, &[Command], &DriverState),
) {
    let (mut own, step) = (driver.start(), 1e-2);
    let mut commands = vec![Command::default(); driver.last_group() + 1];
    for k in 0..(time / step).round() as usize {
        let now = k as f64 * step;
        let leader = state.vehicles[0];
        let (chainage, velocity) = (leader.position, leader.velocity);
        let view = View { time: now, chainage, velocity, train: Some((train, state)) };
        commands[0] = driver.command(&mut own, &view, step);
        driver.pass_on(&mut own, &view, &mut commands);
        train.advance_groups(state, &commands, step);
        see(now + step, state, &commands, &own);
    }
}

const ROLLING: &str =
    "gradient = [{ chainage_m = 0, permille = 0 }, { chainage_m = 1500, permille = 6 },
    { chainage_m = 4000, permille = -8 }, { chainage_m = 7000, permille = 0 }]";

/// What 2 locomotives can do with 128 wagons.
const GENTLE: &str =
    "gradient = [{ chainage_m = 0, permille = 0 }, { chainage_m = 2000, permille = 0.4 },
    { chainage_m = 4500, permille = -2 }, { chainage_m = 7000, permille = 0 }]";

/// Root mean square and greatest error of the speed from 60 s on over a line with some wagons, km/h.
fn speed_errors(line: &str, wagons: usize, text: &str) -> (f64, f64) {
    let driver = driver(text, &[]).unwrap();
    let track = Track::from_toml(line, "line").unwrap();
    let mut train = train(&block_train(2, wagons), &friction_gear(), track);
    let mut state = start(&mut train, 60.0 * KMH, Couplers::InBalance, notch(2.0));
    let (mut squares, mut greatest, mut count) = (0.0, 0.0_f64, 0.0);
    run(&driver, &mut train, &mut state, 400.0, |time, state, _, own| {
        if time > 60.0 {
            let error = (state.vehicles[0].velocity - own.target_speed) / KMH;
            squares += error * error;
            greatest = greatest.max(error.abs());
            count += 1.0;
        }
    });
    ((squares / count).sqrt(), greatest)
}

/// 10 km/h less within 1500 m.
const SPEED_OF_A_HEAVY_TRAIN: &str =
    "[speed]\nchainage_m = [0, 3000, 4500, 20000]\nkmh = [60, 60, 50, 50]\n";

pub const SPEED: &str = "[speed]\nchainage_m = [0, 3000, 3500, 20000]\nkmh = [60, 60, 50, 50]\n";

/// Prints root mean square and greatest error, km/h, and fails beyond their limits.
fn are_within(case: &str, (rms, greatest): (f64, f64), limits: (f64, f64)) {
    let value = format!("{rms:.2}, {greatest:.2} km/h");
    let limit = format!("{}, {} km/h", limits.0, limits.1);
    Bound { case, limit: &limit, obtained: &value }.stands_in(&PAGE);
    assert!(rms < limits.0 && greatest < limits.1, "{case}: {value}");
}

/// The limits are bounds of good driving, not of a closed form: without control the speed changes by
/// far more, which the last line checks.
#[test]
fn property_drivers_keep_to_a_speed_profile_over_a_rolling_line() {
    let cases = [
        ("continuous feed-forward and PID", "[cruise]\n[levers]\ncontinuous = true\n", 1.5, 4.0),
        ("feed-forward and PID in notches", "[cruise]\n", 2.0, 5.0),
        ("fuzzy rules", "[fuzzy]\n", 1.0, 3.0),
    ];
    for (name, text, rms, greatest) in cases {
        let errors = speed_errors(ROLLING, 30, &format!("{SPEED}{text}"));
        let case = format!("rms and greatest error of the speed by {name}");
        are_within(&case, errors, (rms, greatest));
    }
    let text = format!(
        "{SPEED}[cruise]\nproportional_per_s = 0\nintegral_per_s2 = 0\n[levers]\nnotch_interval_s = 60\n\
         dynamic_brake_s = 600\ntrain_brake_s = 600"
    );
    let uncontrolled = speed_errors(ROLLING, 30, &text);
    Bound {
        case: "the same with feed-forward only and levers that hardly move",
        limit: "over 15 km/h",
        obtained: &format!("{:.2}, {:.2} km/h", uncontrolled.0, uncontrolled.1),
    }
    .stands_in(&PAGE);
    assert!(uncontrolled.1 > 15.0, "{uncontrolled:?}");
}

/// The same drivers and gains on another line with the paper's train, four times as heavy.
/// The tail is on another gradient than the head, 2.6 km before it.
#[test]
fn property_drivers_keep_to_a_speed_profile_with_a_heavy_train() {
    let cases = [
        ("feed-forward and PID in notches", "[cruise]\n", 2.0, 5.0),
        ("fuzzy rules", "[fuzzy]\n", 2.0, 5.0),
    ];
    for (name, text, rms, greatest) in cases {
        let errors = speed_errors(GENTLE, 128, &format!("{SPEED_OF_A_HEAVY_TRAIN}{text}"));
        let case = format!("rms and greatest error of the speed of 130 vehicles by {name}");
        are_within(&case, errors, (rms, greatest));
    }
}

/// The feed-forward alone asks for the force that the line takes: at constant speed on a constant
/// gradient the drive gives resistance and gravity.
#[test]
fn analytic_feed_forward_is_the_force_balance() {
    let text = "[speed]\nchainage_m = [0, 9e5]\nkmh = [50, 50]\n[cruise]\nproportional_per_s = 0\n\
                integral_per_s2 = 0\n[levers]\ncontinuous = true\nnotch_interval_s = 0.1\n";
    let driver = driver(text, &[]).unwrap();
    let mut train = train(&block_train(2, 20), &friction_gear(), gradient(4.0));
    let mut state = start(&mut train, 50.0 * KMH, Couplers::InBalance, notch(4.0));
    run(&driver, &mut train, &mut state, 120.0, |_, _, _, _| {});
    let demand = train.demand(&state, 0.0, train.totals(&state).velocity);
    Row {
        case: "traction under feed-forward alone",
        value: train.totals(&state).traction,
        expected: demand,
        unit: "N",
        source: "balance of resistance and gravity",
        tolerance: (2e-3 * demand, "the drive lags behind the command by its ramp"),
    }
    .holds(&PAGE);
}

const LOGGER: &str = "Time (s), Notch, DB, Speed\n\
    100, 4, 0, 36.0\n101, 4, 0, 37.0\n104, 8, 0, 40.0\n110, 0, 0.5, 39.0\n";
pub const REPLAY: &str = "[replay]\nfile = 'logger.csv'\ntime = 'Time (s)'\nthrottle = 'Notch'\n\
    dynamic_brake = 'DB'\nspeed = 'Speed'\n";

#[test]
fn analytic_replay_holds_each_row_until_the_next() {
    let driver = driver(REPLAY, &[("logger.csv", LOGGER)]).unwrap();
    let mut own = driver.start();
    let mut at = |time: f64| {
        let view = View { time, chainage: 0.0, velocity: 10.5, train: None };
        let command = driver.command(&mut own, &view, 1.0);
        (command.notch, command.dynamic_brake, own.measured_speed * 3.6)
    };
    assert_eq!(at(0.0), (4.0, 0.0, 36.0));
    assert_eq!((at(3.9).0, at(4.0).0), (4.0, 8.0));
    assert!((at(2.5).2 - 38.5).abs() < 1e-12);
    assert_eq!((at(10.0).0, at(99.0).1), (0.0, 0.5));
}

/// The measured speed beside the simulated one: a constant difference of 0.5 m/s has that as its root
/// mean square.
#[test]
fn analytic_root_mean_square_of_a_constant_difference() {
    let driver = driver(REPLAY, &[("logger.csv", LOGGER)]).unwrap();
    let mut own = driver.start();
    for k in 0..1000 {
        let time = f64::from(k) * 0.01;
        let mut view = View { time, chainage: 0.0, velocity: 0.0, train: None };
        driver.command(&mut own, &view, 0.0);
        view.velocity = own.measured_speed + 0.5;
        driver.command(&mut own, &view, 0.01);
    }
    assert!((own.speed_rms() - 0.5).abs() < 1e-12);
}

/// A logger's file that is made from a run of the model gives the same run again.
#[test]
fn property_replay_of_a_simulated_logger_repeats_the_run() {
    let schedule = driver(
        "command = [{ from_s = 0, notch = 5 }, { from_s = 20, notch = 8 }, { from_s = 40, dynamic_brake = 0.5 }]",
        &[],
    )
    .unwrap();
    let mut train = train(&block_train(1, 10), &friction_gear(), gradient(2.0));
    let mut state = start(&mut train, 12.0, Couplers::InBalance, notch(5.0));
    let mut log = format!("t,n,d,v\n0,5,0,{}\n", state.vehicles[0].velocity);
    let mut next = 0.5;
    run(&schedule, &mut train, &mut state, 60.0, |time, state, _, _| {
        if time > next - 1e-9 {
            let in_force = match time {
                t if t > 40.0 - 1e-9 => "0,0.5",
                t if t > 20.0 - 1e-9 => "8,0",
                _ => "5,0",
            };
            log += &format!("{next},{in_force},{}\n", state.vehicles[0].velocity);
            next += 0.5;
        }
    });
    let text = "[replay]\nfile = 'l.csv'\ntime = 't'\nthrottle = 'n'\ndynamic_brake = 'd'\nspeed = 'v'\n\
                speed_unit = 'm/s'\n";
    let replay = driver(text, &[("l.csv", &log)]).unwrap();
    let mut again = start(&mut train, 12.0, Couplers::InBalance, notch(5.0));
    let mut rms = f64::NAN;
    run(&replay, &mut train, &mut again, 60.0, |_, _, _, own| rms = own.speed_rms());
    assert_eq!(again.vehicles, state.vehicles);
    // The measured speed is linear over half seconds: less than 1/8 · 0.5² s² · jerk is lost.
    assert!(rms < 5e-3, "{rms}");
}

/// A remote group follows after its delay, or by commands of its own.
#[test]
fn analytic_remote_locomotives_follow_after_their_delay() {
    let text = "command = [{ from_s = 0, notch = 2 }, { from_s = 10, notch = 8 }]\n\
        remote = [{ group = 1, delay_s = 1.5 }, { group = 2, command = [{ from_s = 5, notch = 3 }] }]";
    let driver = driver(text, &[]).unwrap();
    let consist = stock::Consist::from_toml(
        "vehicle = [{ type = 'locomotive-coco-134t' }, { type = 'wagon-coco-134t-unpowered', count = 3 },
                    { type = 'locomotive-coco-134t', group = 1 }, { type = 'locomotive-coco-134t', group = 2 }]",
        "consist.toml",
    )
    .unwrap();
    let mut train = TrainDynamics::from_consist(&consist, &library(), Track::straight()).unwrap();
    assert_eq!(train.groups(), 3);
    let mut state = start(&mut train, 10.0, Couplers::InBalance, Command::default());
    let mut seen = vec![];
    run(&driver, &mut train, &mut state, 12.0, |_, _, commands, _| {
        seen.push([commands[0].notch, commands[1].notch, commands[2].notch]);
    });
    let at = |time: f64| seen[(time * 100.0).round() as usize];
    assert_eq!(at(1.0), [2.0, 2.0, 0.0]);
    assert_eq!(at(5.0), [2.0, 2.0, 3.0]);
    assert_eq!(at(11.4), [8.0, 2.0, 3.0]);
    assert_eq!(at(11.6), [8.0, 8.0, 3.0]);
    let lever = |i: usize| state.vehicles[i].lever;
    assert!(lever(0) > lever(4) && lever(4) > 0.0 && lever(5) > 0.0 && lever(1) == 0.0);
}
