//! What comes after the run, with mocks.

use std::time::Duration;

use super::after::{Continued, Rails};
use super::checkpoint::Reached;
use super::progress::Progress;
use super::recorder::Recorder;
use crate::scenario::Heat;
use crate::system::clock::Clock;
use crate::system::compile::compile;
use crate::system::mock::Mock;
use crate::system::parallel;
use crate::system::part::Part;
use crate::system::step::System;
use crate::system::structure::{Component, Connection, Endpoint, Sampling, Schedule, Structure};
use crate::system::times::Timer;
use crate::system::unit::Unit;
use crate::train::layout::Layout;
use crate::train::layout::RailHolder;
use crate::train::tape::Tape;
use crate::train::traffic::Traffic;

/// A rail of 2 exchange steps a step, which gets the time at the end of each step from a wheel: what
/// it got in the run comes again from the tape; alone its inputs are zero.
#[test]
fn a_train_comes_again_as_it_was_and_alone_there_is_none() {
    let calls = Default::default();
    let wheel: Box<dyn Unit> =
        Box::new(Mock::new("wheel", &[("y".to_owned(), "output")], &calls, |v, time, length| {
            v[0] = time + length;
        }));
    let variables = [("u".to_owned(), "input"), ("sum".to_owned(), "output")];
    let rail: Box<dyn Unit> =
        Box::new(Mock::new("rail", &variables, &calls, |v, _, length| v[1] += v[0] * length));
    let component = |name: &str, stage, every| Component {
        name: name.to_owned(),
        schedule: Schedule { stage, every, ..Schedule::default() },
        ..Component::default()
    };
    let (from, to) = (Endpoint::new("wheel", "y"), Endpoint::new("rail", "u"));
    let structure = Structure {
        components: vec![component("wheel", 0, 1), component("rail", 1, 2)],
        connections: vec![Connection::of(
            from,
            to,
            crate::interface::si::Linear::IDENTITY,
            Sampling::Mean,
        )],
        ..Structure::default()
    };
    let clock = Clock { start: 0.0, length: 0.5 };
    let mut system = compile(&structure, vec![wheel, rail], clock).unwrap();
    let holder = RailHolder { component: "rail".to_owned(), side: 0 };
    let layout = Layout { rails: vec![holder], ..Layout::default() };
    // Two trains 10 min apart, and a quarter of an hour alone in two steps of 450 s.
    let plan = "trains = { count = 2, headway_minutes = 10.0 }\ncool_down_minutes = 15.0\n\
                cool_down_step_s = 598.0";
    let traffic = Traffic::of(&toml::from_str::<Heat>(plan).unwrap());
    let folder = tempfile::tempdir().unwrap();
    let mut rails = Rails::new(&layout, &system, traffic, |_| Tape::new(folder.path())).unwrap();
    parallel::pool(1).unwrap().install(|| {
        system.initialize(|_| 10.0).unwrap();
        for k in 0..5 {
            system.step(k).unwrap();
            rails.observe(k, &system).unwrap();
        }
        assert_eq!(rails.time(&system, 5), 2.0, "an unfinished step of the rail does not count");
        let sum = |system: &mut System| {
            let tap = system.tap("rail", "sum").unwrap();
            let Part { unit, outputs, .. } = &mut system.parts[1];
            outputs.get(unit.as_mut()).unwrap();
            system.value(&tap)
        };
        // Means of 0.5 and 1 s, and of 1.5 and 2 s, each for 1 s.
        assert_eq!(sum(&mut system), 0.75 + 1.75);
        let mut recorder = Recorder { every: 1, ..Recorder::default() };
        let mut progress = Progress::new(5, 2.5, true);
        let mut run = Continued {
            system: &mut system,
            recorder: &mut recorder,
            progress: &mut progress,
            checkpoints: None,
            timer: Timer::after(Duration::ZERO),
            stop: &mut |_, _| None,
        };
        rails.continue_after_run(&mut run, 2.0, Reached::Run(5)).unwrap();
        assert_eq!(sum(&mut system), 2.0 * (0.75 + 1.75));
    });
    let calls = calls.lock().unwrap();
    let steps = calls.iter().filter_map(|call| call.strip_prefix("rail step "));
    let steps: Vec<_> = steps.collect();
    assert_eq!(steps, ["0.000", "1.000", "2.000", "600.000", "601.000", "602.000", "1052.000"]);
}
