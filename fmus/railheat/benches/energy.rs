//! Cost of `model = "energy"` at full size: 130 vehicles of six wheelsets on 7 km of track with elements
//! of 0.1 m, after the train has touched 59 000 of 70 000 elements.
//!
//! `wheels` is a step of 1 ms without conduction, `conduction` one interval of 1 s: a second of the run
//! costs 1000 wheels + conduction. `cooling` is an hour without wheels, in steps of a minute.

mod train;

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use railheat::HeatModel;
use railheat::contact::{Wheel, WheelHeat};
use railheat::energy::{EnergyModel, Parameters, Resolution};
use railheat::line::Line;
use railheat::section::RailFile;
use railheat::weather::Weather;
use train::{SPEED, VEHICLES, wheels};

const WEATHER: Weather = Weather::still(298.15);

fn model(resolution: Resolution) -> EnergyModel {
    let outline = RailFile::open("AS60").expect("a section that is built in").outline();
    let line = Line { begin: -2700.0, element_length: 0.1, elements: 70_000 };
    let parameters = Parameters {
        resolution,
        wheel: WheelHeat { initial_rise: 5.0, ..WheelHeat::TYPICAL },
        depths: vec![0.02, 0.06],
        ..Parameters::new(outline, line)
    };
    EnergyModel::new(parameters, &[6; VEHICLES], &WEATHER, 0.0).expect("a section of some cells")
}

/// A model over which the train has run for 200 s.
fn after_the_run(resolution: Resolution) -> (EnergyModel, Vec<Wheel>) {
    let mut model = model(resolution);
    let at = |time: f64| wheels(SPEED * time, |_, wheel| Wheel { friction_power: 400.0, ..wheel });
    for step in 0..200 {
        let start = f64::from(step);
        model.step(&at(start + 1.0), &WEATHER, start, 1.0);
    }
    (model, at(200.0))
}

fn step(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("energy");
    group.sample_size(10);
    for (name, resolution) in [("column", Resolution::Column), ("2d", Resolution::Plane)] {
        let (mut model, mut wheels) = after_the_run(resolution);
        let distance = SPEED * 1e-3;
        group.bench_function(format!("{name}/wheels"), |bencher| {
            bencher.iter(|| {
                wheels.iter_mut().for_each(|wheel| wheel.position += distance);
                // Always the same millisecond, so that no interval ends.
                black_box(model.step(&wheels, &WEATHER, 200.0, 1e-3))
            });
        });
        let gone = vec![Wheel::default(); 6 * VEHICLES];
        let mut start = 200.0;
        for (what, length) in [("conduction", 1.0), ("cooling", 3600.0)] {
            group.bench_function(format!("{name}/{what}"), |bencher| {
                bencher.iter(|| {
                    start += length;
                    black_box(model.step(&gone, &WEATHER, start - length, length))
                });
            });
        }
    }
    group.finish();
}

criterion_group!(benches, step);
criterion_main!(benches);
