//! A train of mocks: who gets what, when and in which order.

use std::collections::HashMap;
use std::sync::{Arc, Mutex};

use ::controller::Gains;

use super::controller::{self, ControllerUnit};
use super::layout::{Layout, RailHolder, VehicleHolder};
use super::roles;
use super::wiring::connections;
use crate::interface::Interface;
use crate::system::clock::Clock;
use crate::system::compile::compile;
use crate::system::mock::Mock;
use crate::system::step::System;
use crate::system::structure::{Component, Parameter, Schedule, Structure, Value};
use crate::system::unit::{Unit, terminate};

const VEHICLES: usize = 2;
const STEP: f64 = 0.5;
/// Gain of the controllers on the position error, N/m.
const KP: f64 = 2.0;

type Calls = Arc<Mutex<Vec<String>>>;

/// Whether train, vehicles and rail follow one another in a step.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Scheme {
    Sequential,
    Jacobi,
}

/// The variables of a role.
fn variables(groups: &[roles::Group]) -> Vec<(String, &'static str)> {
    let of_group = |(prefix, variables, causality): &roles::Group| {
        let named =
            |variable: &roles::RoleVariable| (format!("{prefix}{}", variable.name), *causality);
        variables.iter().map(named).collect::<Vec<_>>()
    };
    groups.iter().flat_map(of_group).collect()
}

/// A mock that sets outputs by their names in each step.
fn mock(
    name: &str,
    groups: &[roles::Group],
    calls: &Calls,
    mut step: impl FnMut(&dyn Fn(&str) -> usize, &mut [f64], f64) + Send + 'static,
) -> Box<dyn Unit> {
    let variables = variables(groups);
    let index: HashMap<String, usize> =
        variables.iter().map(|(name, _)| name.clone()).zip(0..).collect();
    Box::new(Mock::new(name, &variables, calls, move |values, time, length| {
        step(&|name| index[name], values, time + length);
    }))
}

/// The train's coupler forces are the time at the end of the step, plus 100 for each vehicle; the heat
/// of its brakes is ten times that.
fn train(calls: &Calls) -> Box<dyn Unit> {
    mock("train", &roles::longitudinal(VEHICLES), calls, |index, values, end| {
        for i in 0..VEHICLES {
            let value = end + 100.0 * i as f64;
            values[index(&format!("vehicle[{}].coupler.front.force", i + 1))] = value;
            values[index(&format!("vehicle[{}].wheel.brake_power", i + 1))] = 10.0 * value;
        }
    })
}

/// A vehicle's position is the time, that of its wheelset the force that it got; its wheels' friction
/// power is the time.
fn vehicle(name: &str, calls: &Calls) -> Box<dyn Unit> {
    mock(name, &roles::vehicle(1), calls, |index, values, end| {
        values[index("position")] = end;
        values[index("wheelset[1].position")] = values[index("coupler.front.force")];
        values[index("wheelset[1].left.friction_power")] = end;
    })
}

/// A train of two vehicles with one wheelset each on a rail that steps at every so many points.
fn system(scheme: Scheme, every: u64) -> (System, Calls) {
    let calls = Calls::default();
    let numbers = 1..=VEHICLES;
    let layout = Layout {
        train: "train".to_owned(),
        count: VEHICLES,
        vehicles: numbers
            .map(|i| VehicleHolder {
                component: format!("vehicle[{i}]"),
                wheelsets: 1,
                controller: format!("controller[{i}]"),
                ..VehicleHolder::default()
            })
            .collect(),
        rails: vec![RailHolder { component: "rail".to_owned(), side: 0 }],
    };
    let mut units = vec![(train(&calls), 0)];
    for holder in &layout.vehicles {
        units.push((vehicle(&holder.component, &calls), 1));
        units.push((Box::new(ControllerUnit::new(&holder.controller, "a test")), 0));
    }
    units.push((mock("rail", &roles::railheat(&[1; VEHICLES]), &calls, |_, _, _| {}), 2));
    let interfaces: HashMap<&str, &Interface> =
        units.iter().map(|(unit, _)| (unit.name(), unit.interface())).collect();
    let limit = f64::INFINITY;
    let gains = Gains { proportional: KP, integral: 0.0, derivative: 0.0, limit };
    let parameters = |name: &str| match name {
        "train" => vec![Parameter::new("initial.velocity", Value::Real(1.0))],
        name if name.starts_with("controller") => controller::parameters(&gains),
        _ => vec![],
    };
    let component = |(unit, stage): &(Box<dyn Unit>, usize)| Component {
        name: unit.name().to_owned(),
        parameters: parameters(unit.name()),
        schedule: Schedule {
            stage: if scheme == Scheme::Jacobi { 0 } else { *stage },
            every: if unit.name() == "rail" { every } else { 1 },
            ..Schedule::default()
        },
        ..Component::default()
    };
    let structure = Structure {
        components: units.iter().map(component).collect(),
        connections: connections(&layout, &interfaces),
        ..Structure::default()
    };
    assert_eq!(structure.connections.len(), VEHICLES * (6 + 4 + 10), "all that the table says");
    let units = units.into_iter().map(|(unit, _)| unit).collect();
    let system = compile(&structure, units, Clock { start: 0.0, length: STEP }).unwrap();
    (system, calls)
}

/// Initialises and runs so many steps.
fn run(system: &mut System, steps: u64) {
    crate::system::parallel::pool(1).unwrap().install(|| {
        system.initialize(|_| 10.0).unwrap();
        (0..steps).for_each(|k| system.step(k).unwrap());
    });
}

/// The values that components got for their last step.
fn inputs<const N: usize>(system: &mut System, inputs: [(&str, &str); N]) -> [f64; N] {
    inputs.map(|(component, variable)| {
        let tap = system.tap(component, variable).expect("a connected input");
        system.value(&tap)
    })
}

const FRONT: &str = "coupler.front.force";
const FORCES: [(&str, &str); 2] = [("vehicle[1]", FRONT), ("vehicle[2]", FRONT)];
const POSITION: (&str, &str) = ("rail", "vehicle[1].wheelset[1].position");
const POWER: (&str, &str) = ("rail", "vehicle[1].wheelset[1].friction_power");

#[test]
fn sequential_vehicles_get_the_forces_of_the_end_of_the_step() {
    let (mut system, _) = system(Scheme::Sequential, 1);
    run(&mut system, 2);
    assert_eq!(inputs(&mut system, FORCES), [1.0, 101.0]);
    assert_eq!(inputs(&mut system, [POSITION, POWER]), [1.0, 1.0]);
}

#[test]
fn jacobi_vehicles_get_the_forces_of_the_beginning_of_the_step() {
    let (mut system, _) = system(Scheme::Jacobi, 1);
    run(&mut system, 2);
    assert_eq!(inputs(&mut system, FORCES), [0.5, 100.5]);
    assert_eq!(inputs(&mut system, [POWER]), [0.5]);
}

/// The error of position is the time, as the train's position in the mock is zero.
#[test]
fn the_controllers_force_acts_at_once_or_as_that_of_a_unit_one_step_later() {
    for (scheme, expected) in
        [(Scheme::Sequential, [0.0, -0.5 * KP, -KP]), (Scheme::Jacobi, [0.0, 0.0, -0.5 * KP])]
    {
        let force = |steps| {
            let (mut system, _) = system(scheme, 1);
            run(&mut system, steps);
            inputs(&mut system, [("vehicle[1]", "sync.force")])[0]
        };
        assert_eq!([1, 2, 3].map(force), expected, "{scheme:?}");
    }
}

#[test]
fn a_slower_rail_gets_means_and_the_last_position() {
    let (mut system, calls) = system(Scheme::Sequential, 2);
    run(&mut system, 4);
    assert_eq!(inputs(&mut system, [POSITION, POWER]), [2.0, (1.5 + 2.0) / 2.0]);
    let calls = calls.lock().unwrap();
    let steps: Vec<_> = calls.iter().filter(|call| call.starts_with("rail step")).collect();
    assert_eq!(steps, ["rail step 0.000", "rail step 1.000"]);
}

#[test]
fn the_rail_gets_the_brake_heat_that_the_train_tells() {
    let (mut system, _) = system(Scheme::Sequential, 2);
    run(&mut system, 4);
    let names = [1, 2].map(|i| format!("vehicle[{i}].wheelset[1].brake_power"));
    let heat = inputs(&mut system, [("rail", &*names[0]), ("rail", &*names[1])]);
    assert_eq!(heat, [17.5, 1017.5], "means of the steps that end at 1.5 and 2 s");
}

/// FMI 2.0 §4.2.4: in stepping, no output is got after a set without a step in between.
#[test]
fn no_unit_is_read_between_a_set_and_its_step() {
    for scheme in [Scheme::Sequential, Scheme::Jacobi] {
        let (mut system, calls) = system(scheme, 1);
        run(&mut system, 3);
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

/// What a vehicle's initialisation costs is spent once: it gets its inputs before it is asked.
#[test]
fn a_vehicle_is_asked_only_when_its_first_inputs_are_known() {
    let (mut system, calls) = system(Scheme::Sequential, 1);
    run(&mut system, 0);
    let calls = calls.lock().unwrap();
    let own: Vec<_> = calls.iter().filter_map(|call| call.strip_prefix("vehicle[1] ")).collect();
    assert_eq!(own[..3], ["enter", "set", "get"]);
}

#[test]
fn every_unit_is_told_the_end() {
    let (mut system, calls) = system(Scheme::Sequential, 1);
    run(&mut system, 1);
    terminate(system.units_mut()).unwrap();
    let calls = calls.lock().unwrap();
    assert_eq!(calls.iter().filter(|call| call.ends_with("terminate")).count(), 4);
}
