//! Systems of mocks.

use std::sync::{Arc, Mutex};

use super::links::{Link, Part, Place};
use super::step::System;
use crate::interface::si::Linear;
use crate::recording::SeriesReader;
use crate::ssp::record::{Recorder, renamed};
use crate::system::mock::Mock;
use crate::system::unit::terminate;
use crate::train::lockstep::Clock;

type Calls = Arc<Mutex<Vec<String>>>;

/// A system of mocks with the variables u (0) and y (1), linked as pairs of numbers from y to u with
/// a factor; each mock's step is y = 2 u + 1, and those that feed through follow that law also
/// before they step.
fn system(count: usize, links: &[(usize, usize)], factor: f64) -> (System, Calls) {
    system_of(count, links, factor, |mock| mock)
}

fn feedthrough(count: usize, links: &[(usize, usize)], factor: f64) -> System {
    system_of(count, links, factor, Mock::feeding_through).0
}

fn system_of(
    count: usize,
    links: &[(usize, usize)],
    factor: f64,
    kind: fn(Mock) -> Mock,
) -> (System, Calls) {
    let calls = Calls::default();
    let mut system = System::empty(Clock { start: 0.0, length: 0.5 });
    for i in 0..count {
        let variables = [("u".to_owned(), "input"), ("y".to_owned(), "output")];
        let unit = Mock::new(&format!("m{i}"), &variables, &calls, |values, _, _| {
            values[1] = 2.0 * values[0] + 1.0;
        });
        system.parts.push(Part::new(Box::new(kind(unit))));
    }
    for &(from, to) in links {
        let from = Place { part: from, at: system.parts[from].outputs.reals.place(1, f64::NAN) };
        let to = Place { part: to, at: system.parts[to].inputs.reals.place(0, f64::NAN) };
        let way = Linear { factor, offset: 0.0 };
        system.links.reals.push(Link { from, to, way });
    }
    (system, calls)
}

fn in_pool<T: Send>(task: impl FnOnce() -> T + Send) -> T {
    crate::system::parallel::pool(1).unwrap().install(task)
}

/// A chain of three hands each value on by one step: all take the last exchange.
#[test]
fn analytic_every_hop_of_a_chain_takes_one_step() {
    let (mut system, calls) = system(3, &[(0, 1), (1, 2)], 10.0);
    let outputs: Vec<Vec<f64>> = in_pool(|| {
        system.initialize(10.0).unwrap();
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

/// A mock's output does not follow its input before it steps, so a circle of mocks settles.
#[test]
fn a_circle_without_feedthrough_settles() {
    let (mut system, _) = system(2, &[(0, 1), (1, 0)], 1.0);
    in_pool(|| system.initialize(10.0)).unwrap();
}

/// y = 2 u + 1 and u = y / 4 have one solution, y = 2; each sweep halves the error.
#[test]
fn analytic_a_loop_that_halves_its_errors_settles() {
    let mut system = feedthrough(1, &[(0, 0)], 0.25);
    in_pool(|| system.initialize(10.0)).unwrap();
    let output = system.parts[0].outputs.reals.values[0];
    // The exchange stops at changes of 1e-13, and as much is left of the error.
    assert!((output - 2.0).abs() < 1e-12, "{output}");
}

/// y = 2 u + 1 with u = y grows from sweep to sweep.
#[test]
fn a_loop_that_never_settles_is_refused_with_the_inputs_in_it() {
    let mut system = feedthrough(3, &[(0, 1), (1, 0), (0, 2)], 1.0);
    let message = in_pool(|| system.initialize(10.0)).unwrap_err().to_string();
    let wanted = "the initial values of m1.u, m0.u, m2.u depend on each other in a loop and do not \
                  settle; give start values that fit, or break the loop";
    assert_eq!(message, wanted);
}

/// Of a long loop the message names the first inputs only.
#[test]
fn a_long_loop_is_told_with_five_of_its_inputs() {
    let ring: Vec<_> = (0..9).map(|from| (from, (from + 1) % 9)).collect();
    let mut system = feedthrough(9, &ring, 1.0);
    let message = in_pool(|| system.initialize(10.0)).unwrap_err().to_string();
    assert_eq!(message.matches(".u").count(), 5, "{message}");
}

/// Many FMUs have an output for the time, whose name the column of times has already.
#[test]
fn an_output_named_time_is_recorded_beside_the_column_of_times() {
    let unit =
        Mock::new("m", &[("time".to_owned(), "output")], &Calls::default(), |values, _, _| {
            values[0] += 100.0;
        });
    let mut system = System::empty(Clock { start: 0.0, length: 0.5 });
    system.parts.push(Part::new(Box::new(unit)));
    let folder = tempfile::tempdir().unwrap();
    in_pool(|| {
        system.initialize(1.0).unwrap();
        let mut recorder = Recorder::new(&system, 1, folder.path()).unwrap();
        system.step(0).unwrap();
        recorder.observe(1, &mut system).unwrap();
        recorder.finish().unwrap();
    });
    let table = SeriesReader::open(folder.path(), "m").unwrap();
    assert_eq!(table.read("time", &[]).unwrap(), [0.5]);
    assert_eq!(table.read("time (output)", &[]).unwrap(), [100.0]);
    let told = renamed(&system);
    assert!(told[0].contains("'time' of m is recorded as 'time (output)'"), "{told:?}");
}

#[test]
fn every_unit_is_told_the_end() {
    let (mut system, calls) = system(2, &[], 1.0);
    in_pool(|| {
        system.initialize(10.0).unwrap();
        terminate(system.units_mut()).unwrap();
    });
    let calls = calls.lock().unwrap();
    assert_eq!(calls.iter().filter(|call| call.ends_with("terminate")).count(), 2);
}
