//! Systems of mocks.

use std::sync::{Arc, Mutex};

use super::clock::Clock;
use super::compile::{CompileError, compile};
use super::mock::Mock;
use super::step::System;
use super::structure::{Component, Connection, Endpoint, Sampling, Schedule, Structure};
use super::unit::{Unit, terminate};
use crate::interface::si::Linear;

type Calls = Arc<Mutex<Vec<String>>>;

/// Time between two communication points, s.
const STEP: f64 = 0.5;

/// A structure of components m0, m1, … that are linked as pairs of numbers from the output y to the
/// input u, with a factor.
fn schedule(stage: usize, every: u64) -> Schedule {
    Schedule { stage, every, ..Schedule::default() }
}

fn structure(schedules: &[Schedule], links: &[(usize, usize)], factor: f64) -> Structure {
    let component = |(number, schedule): (usize, &Schedule)| Component {
        name: format!("m{number}"),
        schedule: *schedule,
        ..Component::default()
    };
    let connection = |&(from, to): &(usize, usize)| {
        let (from, to) = (format!("m{from}"), format!("m{to}"));
        let factor = Linear { factor, offset: 0.0 };
        Connection::of(Endpoint::new(&from, "y"), Endpoint::new(&to, "u"), factor, Sampling::Mean)
    };
    Structure {
        components: schedules.iter().enumerate().map(component).collect(),
        connections: links.iter().map(connection).collect(),
        ..Structure::default()
    }
}

/// A unit for each component, whose step is y = 2 u + 1.
fn mocks(structure: &Structure, calls: &Calls, kind: fn(Mock) -> Mock) -> Vec<Box<dyn Unit>> {
    let variables = [("u".to_owned(), "input"), ("y".to_owned(), "output")];
    let mock = |component: &Component| -> Box<dyn Unit> {
        let unit = Mock::new(&component.name, &variables, calls, |values, _, _| {
            values[1] = 2.0 * values[0] + 1.0;
        });
        Box::new(kind(unit))
    };
    structure.components.iter().map(mock).collect()
}

fn compiled(structure: &Structure, units: Vec<Box<dyn Unit>>) -> System {
    compile(structure, units, Clock { start: 0.0, length: STEP }).unwrap()
}

/// So many mocks that step together, linked with a factor.
fn system(count: usize, links: &[(usize, usize)], factor: f64) -> (System, Calls) {
    let calls = Calls::default();
    let structure = structure(&vec![Schedule::default(); count], links, factor);
    let units = mocks(&structure, &calls, |mock| mock);
    (compiled(&structure, units), calls)
}

/// The same of mocks that follow their law also before they step.
fn feedthrough(count: usize, links: &[(usize, usize)], factor: f64) -> System {
    let structure = structure(&vec![Schedule::default(); count], links, factor);
    let units = mocks(&structure, &Calls::default(), Mock::feeding_through);
    compiled(&structure, units)
}

fn in_pool<T: Send>(task: impl FnOnce() -> T + Send) -> T {
    super::parallel::pool(1).unwrap().install(task)
}

/// A chain of three hands each value on by one step: all take the last exchange.
#[test]
fn analytic_every_hop_of_a_chain_takes_one_step() {
    let (mut system, calls) = system(3, &[(0, 1), (1, 2)], 10.0);
    let outputs: Vec<Vec<f64>> = in_pool(|| {
        system.initialize(|_| 10.0).unwrap();
        let step = |k| {
            system.step(k).unwrap();
            let last = [&system.parts[0].outputs, &system.parts[1].outputs];
            last.iter().map(|signals| signals.reals.values[0]).collect()
        };
        (0..3).map(step).collect()
    });
    // y0 = 1 from the first step on; m1 sees it, times ten, in the second: y1 = 2·10 + 1.
    assert_eq!(outputs, [vec![1.0, 1.0], vec![1.0, 21.0], vec![1.0, 21.0]]);
    let calls = calls.lock().unwrap();
    let own: Vec<_> = calls.iter().filter_map(|call| call.strip_prefix("m1 ")).collect();
    let stepping: Vec<_> = own.iter().skip_while(|call| **call != "exit").skip(2).collect();
    assert_eq!(stepping[..3], [&"set", &"step 0.000", &"get"], "FMI 2.0 §4.2.4");
}

/// A unit whose output is right only when its initialisation has ended: the next stage starts with it.
#[test]
fn a_later_stage_starts_with_what_the_initialisation_of_an_earlier_one_has_given() {
    let stage = |stage| Schedule { stage, ..Schedule::default() };
    let structure = structure(&[stage(0), stage(1)], &[(0, 1)], 1.0);
    let calls = Calls::default();
    let late = |mock: Mock| mock.computing_at_exit();
    let units = mocks(&structure, &calls, late);
    let mut system = compiled(&structure, units);
    in_pool(|| system.initialize(|_| 10.0)).unwrap();
    assert_eq!(system.parts[1].inputs.reals.values, [1.0], "y = 2·0 + 1");
    assert_eq!(system.parts[1].outputs.reals.values, [0.0; 0], "nobody takes it");
}

/// A mock's output does not follow its input before it steps, so a circle of mocks settles.
#[test]
fn a_circle_without_feedthrough_settles() {
    let (mut system, _) = system(2, &[(0, 1), (1, 0)], 1.0);
    in_pool(|| system.initialize(|_| 10.0)).unwrap();
}

/// y = 2 u + 1 and u = y / 4 have one solution, y = 2; each sweep halves the error.
#[test]
fn analytic_a_loop_that_halves_its_errors_settles() {
    let mut system = feedthrough(1, &[(0, 0)], 0.25);
    in_pool(|| system.initialize(|_| 10.0)).unwrap();
    let output = system.parts[0].outputs.reals.values[0];
    // The exchange stops at changes of 1e-13, and as much is left of the error.
    assert!((output - 2.0).abs() < 1e-12, "{output}");
}

/// y = 2 u + 1 with u = y grows from sweep to sweep.
#[test]
fn a_loop_that_never_settles_is_refused_with_the_inputs_in_it() {
    let mut system = feedthrough(3, &[(0, 1), (1, 0), (0, 2)], 1.0);
    let message = in_pool(|| system.initialize(|_| 10.0)).unwrap_err().to_string();
    let wanted = "the initial values of m0.u, m1.u, m2.u depend on each other in a loop and do not \
                  settle; give start values that fit, or break the loop";
    assert_eq!(message, wanted);
}

/// Of a long loop the message names the first inputs only.
#[test]
fn a_long_loop_is_told_with_five_of_its_inputs() {
    let ring: Vec<_> = (0..9).map(|from| (from, (from + 1) % 9)).collect();
    let mut system = feedthrough(9, &ring, 1.0);
    let message = in_pool(|| system.initialize(|_| 10.0)).unwrap_err().to_string();
    assert_eq!(message.matches(".u").count(), 5, "{message}");
}

/// A stage takes what the stage before has given in the same step; the order of the components in the
/// structure does not matter.
#[test]
fn analytic_stages_hand_values_on_within_a_step() {
    let stage = |stage| Schedule { stage, ..Schedule::default() };
    let structure = structure(&[stage(2), stage(0), stage(1)], &[(1, 2), (2, 0)], 1.0);
    let units = mocks(&structure, &Calls::default(), |mock| mock);
    let mut system = compiled(&structure, units);
    let outputs = in_pool(|| {
        system.initialize(|_| 10.0).unwrap();
        system.step(0).unwrap();
        [1, 2].map(|number| system.parts[number].inputs.reals.values[0])
    });
    assert_eq!(outputs, [1.0, 3.0], "y = 1 of the first stage, then y = 2·1 + 1 of the second");
    assert_eq!(system.number("m0"), Some(2));
}

/// A giver whose output is the time at the end of its step, and a receiver that steps at every third
/// point: the mean of 0.5, 1.0 and 1.5 s is 1 s, their sum 3 s, the last 1.5 s.
#[test]
fn analytic_a_slower_component_gets_means_sums_or_last_values() {
    for (sampling, expected) in
        [(Sampling::Mean, [1.0, 2.5]), (Sampling::Sum, [3.0, 7.5]), (Sampling::Last, [1.5, 3.0])]
    {
        let calls = Calls::default();
        let schedules = [schedule(0, 1), schedule(1, 3)];
        let mut structure = structure(&schedules, &[(0, 1)], 1.0);
        structure.connections[0].sampling = sampling;
        let mut units = mocks(&structure, &calls, |mock| mock);
        let variables = [("y".to_owned(), "output")];
        units[0] = Box::new(Mock::new("m0", &variables, &calls, |values, time, length| {
            values[0] = time + length;
        }));
        let mut system = compiled(&structure, units);
        let taken = in_pool(|| {
            system.initialize(|_| 10.0).unwrap();
            [0..3, 3..6].map(|steps| {
                steps.for_each(|k| system.step(k).unwrap());
                system.parts[1].inputs.reals.values[0]
            })
        });
        assert_eq!(taken, expected, "{sampling:?}");
        let calls = calls.lock().unwrap();
        let steps: Vec<_> = calls.iter().filter(|call| call.starts_with("m1 step")).collect();
        assert_eq!(steps, ["m1 step 0.000", "m1 step 1.500"]);
    }
}

/// A slow giver holds its output until its next step.
#[test]
fn analytic_what_a_slower_component_gives_is_held() {
    let schedules = [schedule(0, 2), schedule(1, 1)];
    let structure = structure(&schedules, &[(0, 1)], 1.0);
    let units = mocks(&structure, &Calls::default(), |mock| mock);
    let mut system = compiled(&structure, units);
    let taken: Vec<f64> = in_pool(|| {
        system.initialize(|_| 10.0).unwrap();
        let step = |k| {
            system.step(k).unwrap();
            system.parts[1].inputs.reals.values[0]
        };
        (0..3).map(step).collect()
    });
    assert_eq!(taken, [0.0, 1.0, 1.0]);
}

#[test]
fn what_does_not_fit_is_told_in_a_sentence_each() {
    let mut structure = structure(&[Schedule::default(); 2], &[(0, 1), (1, 1)], 1.0);
    let end = |element, connector| Endpoint::new(element, connector);
    for (from, to) in [
        (end("m0", "u"), end("m1", "y")),
        (end("m0", "z"), end("m1", "u")),
        (end("m0", "y"), end("m7", "u")),
    ] {
        structure.connections.push(Connection::of(from, to, Linear::IDENTITY, Sampling::Mean));
    }
    let units = mocks(&structure, &Calls::default(), |mock| mock);
    let error = compile(&structure, units, Clock { start: 0.0, length: STEP }).err().unwrap();
    let CompileError::Unfit(problems) = error else { panic!("{error}") };
    for (problem, wanted) in problems.iter().zip([
        "connection of 'm1.y' to 'm1.u': the latter is connected already",
        "connection of 'm0.u' to 'm1.y': the latter is no input of its FMU",
        "'m0' has a connector 'z'",
        "there is no component 'm7'",
    ]) {
        assert!(problem.contains(wanted), "{problem}");
    }
    assert_eq!(problems.len(), 4);
}

/// A signal is asked for by its name; an output that nobody takes is got from then on.
#[test]
fn a_signal_is_found_by_its_name() {
    let (mut system, _) = system(2, &[(0, 1)], 1.0);
    let tap = |system: &mut System, component, variable| system.tap(component, variable);
    assert!(tap(&mut system, "m0", "u").is_none(), "an input that nothing is connected to");
    assert!(tap(&mut system, "m1", "x").is_none() && tap(&mut system, "m2", "y").is_none());
    let taps = [("m1", "u"), ("m1", "y")].map(|(part, name)| tap(&mut system, part, name).unwrap());
    let values = in_pool(|| {
        system.initialize(|_| 1.0).unwrap();
        system.step(0).unwrap();
        system.step(1).unwrap();
        taps.map(|tap| system.value(&tap))
    });
    assert_eq!(values, [1.0, 3.0]);
    let doubled = taps[1].converted(Linear { factor: 2.0, offset: 1.0 });
    assert_eq!(system.value(&doubled), 7.0);
}

#[test]
fn every_unit_is_told_the_end() {
    let (mut system, calls) = system(2, &[], 1.0);
    in_pool(|| {
        system.initialize(|_| 10.0).unwrap();
        terminate(system.units_mut()).unwrap();
    });
    let calls = calls.lock().unwrap();
    assert_eq!(calls.iter().filter(|call| call.ends_with("terminate")).count(), 2);
}
