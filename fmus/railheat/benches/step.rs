//! Cost of a 1 ms step of the rail heat of the paper's train: 130 vehicles with six wheels on this
//! rail, after 200 s, when the train has touched 59 000 of 70 000 elements.
//!
//! `wheels` has no conduction step, `conduction` one interval of 50 ms: the average step costs
//! wheels + conduction / 50.

mod train;

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use railheat::HeatModel;
use railheat::contact::{Friction, Material, Wheel};
use railheat::line::Line;
use railheat::paper::{Grid, PaperModel, Parameters, RunningSurface};
use railheat::weather::Weather;
use train::{SPEED, VEHICLES, wheels};

const WEATHER: Weather = Weather { direct: 1366.0, ..Weather::still(298.15) };

/// The end of the conduction interval that comes next never arrives in `wheels`: each iteration
/// tells the model of the same millisecond, with the wheels further on.
const START: f64 = 200.0;

/// 7 km of track.
fn model() -> PaperModel {
    let parameters = Parameters {
        grid: Grid {
            line: Line { begin: -2700.0, element_length: 0.1, elements: 70_000 },
            cell_size: 0.005,
            cells: 34,
        },
        width: 0.075,
        conduction_interval: 0.05,
        material: Material::PAPER,
        friction: Friction::PAPER,
        surface: RunningSurface::PAPER,
        initial_temperature: RunningSurface::PAPER.equilibrium(&WEATHER),
        depths: vec![0.02, 0.06],
    };
    PaperModel::new(parameters, 6 * VEHICLES, 0.0).expect("a stable interval")
}

/// A model over which the train has run for 200 s.
fn after_the_run() -> (PaperModel, Vec<Wheel>) {
    let mut model = model();
    let at = |time: f64| {
        let creepage = |vehicle: usize| 1e-3 / (1 + vehicle) as f64;
        wheels(SPEED * time, |vehicle, wheel| Wheel { creepage: creepage(vehicle), ..wheel })
    };
    for step in 0..200 {
        let start = f64::from(step);
        model.step(&at(start + 1.0), &WEATHER, start, 1.0);
    }
    (model, at(200.0))
}

fn step(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("railheat");
    group.sample_size(20);
    let (mut model, mut wheels) = after_the_run();
    let distance = SPEED * 1e-3;
    group.bench_function("wheels", |bencher| {
        bencher.iter(|| {
            wheels.iter_mut().for_each(|wheel| wheel.position += distance);
            black_box(model.step(&wheels, &WEATHER, START, 1e-3))
        });
    });
    let (mut model, _) = after_the_run();
    let mut count = 0u32;
    group.bench_function("conduction", |bencher| {
        bencher.iter(|| {
            let start = START + 0.05 * f64::from(count);
            count += 1;
            black_box(model.step(&[], &WEATHER, start, 0.05))
        });
    });
    group.finish();
}

criterion_group!(benches, step);
criterion_main!(benches);
