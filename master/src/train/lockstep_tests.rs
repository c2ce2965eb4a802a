//! The step loop with mocks: who gets what, when and in which order.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

use controller::{Controller, Gains, Motion};

use crate::scenario::Scheme;
use crate::system::mock::Mock;
use crate::system::port::{Port, Signal};
use crate::system::unit::{Unit, terminate};
use crate::train::lockstep::{Clock, Lockstep, Train, Vehicle};
use crate::train::rail::Rail;
use crate::train::roles::{self, rail_input, vehicle_input, vehicle_output};
use crate::train::tape::Tape;

const VEHICLES: usize = 2;
const STEP: f64 = 0.5;
/// Gain of the controllers on the position error, N/m.
const KP: f64 = 2.0;

type Calls = Arc<Mutex<Vec<String>>>;

fn with<'a>(signals: &'a [Signal], causality: &'a str) -> impl Iterator<Item = (String, &'a str)> {
    signals.iter().map(move |signal| (signal.name.clone(), causality))
}

fn port(unit: &dyn Unit, signals: &[Signal], causality: &str) -> Port {
    Port::connect(unit.interface(), signals, causality, &BTreeMap::new()).unwrap()
}

/// The train's coupler forces are the time at the end of the step, plus 100 for each place; the heat
/// of its brakes is ten times that.
fn train(calls: &Calls) -> Train {
    let signals = roles::longitudinal_signals(VEHICLES);
    let variables: Vec<_> =
        with(&signals.outputs, "output").chain(with(&signals.parameters, "parameter")).collect();
    let block = roles::train::NAMES.len();
    let unit = Mock::new("train", &variables, calls, move |values, time, length| {
        for place in 0..VEHICLES {
            let value = time + length + 100.0 * place as f64;
            values[place * block + roles::train::COUPLER_FRONT] = value;
            values[place * block + roles::train::WHEEL_BRAKE_POWER] = 10.0 * value;
        }
    });
    let start = port(&unit, &signals.parameters, "parameter");
    let outputs = port(&unit, &signals.outputs, "output");
    Train { unit: Box::new(unit), start, constants: vec![], outputs }
}

/// A vehicle's position is the time, that of its wheelset the force that it got; its wheels'
/// friction power is the time.
fn vehicle(place: usize, calls: &Calls) -> Vehicle {
    let signals = roles::vehicle_signals(1);
    let variables: Vec<_> = with(&signals.inputs, "input")
        .chain(with(&signals.outputs, "output"))
        .chain(with(&signals.parameters, "parameter"))
        .collect();
    let outputs_at = signals.inputs.len();
    let name = format!("vehicle[{}]", place + 1);
    let unit = Mock::new(&name, &variables, calls, move |values, time, length| {
        values[outputs_at + vehicle_output::POSITION] = time + length;
        values[outputs_at + vehicle_output::wheelset(0)] = values[vehicle_input::COUPLER_FRONT];
        values[outputs_at + vehicle_output::wheel(0, 0) + vehicle_output::FRICTION_POWER] =
            time + length;
    });
    let start = port(&unit, &signals.parameters, "parameter");
    let inputs = port(&unit, &signals.inputs, "input");
    let outputs = port(&unit, &signals.outputs, "output");
    let limit = f64::INFINITY;
    let gains = Gains { proportional: KP, integral: 0.0, derivative: 0.0, limit };
    Vehicle {
        constants: vec![],
        unit: Box::new(unit),
        start,
        inputs,
        outputs,
        controller: Controller::new(gains),
        controller_force: 0.0,
    }
}

fn lockstep(scheme: Scheme, every: u64) -> (Lockstep, Calls) {
    let calls = Calls::default();
    let signals = roles::railheat_signals(&[1; VEHICLES]);
    let variables: Vec<_> = with(&signals.inputs, "input").collect();
    let unit = Mock::new("rail", &variables, &calls, |_, _, _| {});
    let inputs = port(&unit, &signals.inputs, "input");
    let rail = Rail::new(Box::new(unit), inputs, vec![1; VEHICLES], 0, every);
    let lockstep = Lockstep {
        clock: Clock { start: 0.0, length: STEP },
        scheme,
        train: train(&calls),
        vehicles: (0..VEHICLES).map(|place| vehicle(place, &calls)).collect(),
        rails: vec![rail],
        times: Default::default(),
    };
    (lockstep, calls)
}

fn run(lockstep: &mut Lockstep, steps: u64) {
    run_from(lockstep, 0, steps);
}

/// Runs the steps from `first` up to before `end`, from the initialisation if that is step 0.
fn run_from(lockstep: &mut Lockstep, first: u64, end: u64) {
    let pool = crate::system::parallel::pool(1).unwrap();
    pool.install(|| {
        if first == 0 {
            lockstep.initialize(Motion { position: 0.0, velocity: 1.0 }, 10.0, 10.0).unwrap();
        }
        for k in first..end {
            lockstep.step(k).unwrap();
        }
    });
}

/// The place of friction power in a wheelset's block of rail inputs.
const POWER: usize = 4;

#[test]
fn sequential_vehicles_get_the_forces_of_the_end_of_the_step() {
    let (mut lockstep, _) = lockstep(Scheme::Sequential, 1);
    run(&mut lockstep, 2);
    let forces = lockstep.vehicles.iter().map(|v| v.inputs.values[vehicle_input::COUPLER_FRONT]);
    assert_eq!(forces.collect::<Vec<_>>(), [1.0, 101.0]);
    let rail = &lockstep.rails[0];
    assert_eq!(rail.inputs.values[0], 1.0, "position of the first wheelset");
    assert_eq!(rail.inputs.values[POWER], 1.0);
}

#[test]
fn jacobi_vehicles_get_the_forces_of_the_beginning_of_the_step() {
    let (mut lockstep, _) = lockstep(Scheme::Jacobi, 1);
    run(&mut lockstep, 2);
    let forces = lockstep.vehicles.iter().map(|v| v.inputs.values[vehicle_input::COUPLER_FRONT]);
    assert_eq!(forces.collect::<Vec<_>>(), [0.5, 100.5]);
    assert_eq!(lockstep.rails[0].inputs.values[POWER], 0.5);
}

/// The error of position is the time, as the train's place in the mock is zero.
#[test]
fn the_controllers_force_acts_at_once_or_as_that_of_a_unit_one_step_later() {
    for (scheme, expected) in
        [(Scheme::Sequential, [0.0, -0.5 * KP, -KP]), (Scheme::Jacobi, [0.0, 0.0, -0.5 * KP])]
    {
        let (mut lockstep, _) = lockstep(scheme, 1);
        let mut forces = vec![];
        for steps in 0..3 {
            run_from(&mut lockstep, steps, steps + 1);
            forces.push(lockstep.vehicles[0].inputs.values[vehicle_input::SYNCHRONISATION]);
        }
        assert_eq!(forces, expected, "{scheme:?}");
    }
}

#[test]
fn a_slower_rail_gets_means_and_the_last_position() {
    let (mut lockstep, calls) = lockstep(Scheme::Sequential, 2);
    run(&mut lockstep, 4);
    let rail = &lockstep.rails[0];
    assert_eq!(rail.inputs.values[POWER], (1.5 + 2.0) / 2.0);
    assert_eq!(rail.inputs.values[0], 2.0);
    let calls = calls.lock().unwrap();
    let steps: Vec<_> = calls.iter().filter(|call| call.starts_with("rail step")).collect();
    assert_eq!(steps, ["rail step 0.000", "rail step 1.000"]);
}

#[test]
fn the_rail_gets_the_brake_heat_that_the_train_tells() {
    let (mut lockstep, _) = lockstep(Scheme::Sequential, 2);
    run(&mut lockstep, 4);
    let rail = &lockstep.rails[0];
    let heat = |vehicle: usize| {
        rail.inputs.values[vehicle * rail_input::NAMES.len() + rail_input::BRAKE_POWER]
    };
    assert_eq!([heat(0), heat(1)], [17.5, 1017.5], "means of the steps that end at 1.5 and 2 s");
}

/// A rail of 2 exchange steps a step: what it got in the run comes again from the tape; alone all
/// inputs are zero.
#[test]
fn a_train_comes_again_as_it_was_and_alone_there_is_none() {
    let (mut lockstep, _) = lockstep(Scheme::Sequential, 2);
    let folder = tempfile::tempdir().unwrap();
    lockstep.rails[0].tape = Some(Tape::new(folder.path()).unwrap());
    run(&mut lockstep, 4);
    assert_eq!(lockstep.rails_time(5), 4.0 * STEP, "an unfinished step of the rail does not count");
    let rail = &mut lockstep.rails[0];
    let of_last_step = rail.inputs.values.clone();
    rail.step_alone(2.0, 10.0).unwrap();
    assert!(rail.inputs.values.iter().all(|value| *value == 0.0));
    assert_eq!(rail.rewind().unwrap(), 2);
    rail.step_again(12.0, 1.0).unwrap();
    assert_eq!(rail.inputs.values[POWER], (0.5 + 1.0) / 2.0);
    rail.step_again(13.0, 1.0).unwrap();
    assert_eq!(rail.inputs.values, of_last_step);
    let end = rail.step_again(14.0, 1.0).unwrap_err().to_string();
    assert!(end.contains("left rail") && end.contains("further trains"), "{end}");
}

/// FMI 2.0 §4.2.4: in stepping, no output is got after a set without a step in between.
#[test]
fn no_unit_is_read_between_a_set_and_its_step() {
    for scheme in [Scheme::Sequential, Scheme::Jacobi] {
        let (mut lockstep, calls) = lockstep(scheme, 1);
        run(&mut lockstep, 3);
        let calls = calls.lock().unwrap();
        for unit in ["train", "vehicle[1]", "vehicle[2]", "rail"] {
            let own = calls.iter().filter_map(|call| call.strip_prefix(&format!("{unit} ")));
            let stepping: Vec<_> = own.skip_while(|call| *call != "exit").skip(1).collect();
            let read_after_set = stepping.windows(2).any(|pair| pair == ["set", "get"]);
            assert!(!read_after_set, "{unit}: {stepping:?}");
            assert_eq!(stepping.iter().filter(|call| call.starts_with("step")).count(), 3);
        }
    }
}

#[test]
fn every_unit_is_told_the_end() {
    let (mut lockstep, calls) = lockstep(Scheme::Sequential, 1);
    run(&mut lockstep, 1);
    terminate(lockstep.units_mut()).unwrap();
    let calls = calls.lock().unwrap();
    assert_eq!(calls.iter().filter(|call| call.ends_with("terminate")).count(), 4);
}
