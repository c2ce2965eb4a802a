//! Cost of `model = "energy"` at full size: 130 vehicles of six wheelsets on 7 km of track with elements
//! of 0.1 m, after the train has touched 59 000 of 70 000 elements.
//!
//! `wheels` is a step of 1 ms without conduction, `conduction` one interval of 1 s: a second of the run
//! costs 1000 wheels + conduction. An hour of cooling is 60 conductions of 60 s.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use railheat::creep_force::Contact;
use railheat::energy::bending::Beam;
use railheat::energy::model::Energy;
use railheat::energy::parameters::{Line, Parameters, Resolution, Start, TrainWeather};
use railheat::energy::sun::Sun;
use railheat::energy::weather::{Exchange, Weather};
use railheat::energy::wheels::WheelHeat;
use railheat::material::Material;
use railheat::section::RailFile;
use railheat::wheels::Wheel;

const VEHICLES: usize = 130;
const SPEED: f64 = 16.67;
const WEATHER: Weather = Weather {
    ambient: 298.15,
    wind: 0.0,
    direct: 0.0,
    diffuse: 0.0,
    sun: Sun { elevation: 0.0, azimuth: 0.0 },
};

fn model(resolution: Resolution) -> Energy {
    let outline = RailFile::open("AS60").expect("a section that is built in").outline();
    let section = outline.properties();
    let parameters = Parameters {
        line: Line { begin: -2700.0, element_length: 0.1, elements: 70_000 },
        resolution,
        cell_size: 0.005,
        shortest: 0.0,
        interval: 1.0,
        material: Material::PAPER,
        wheel: WheelHeat {
            partition: 0.5,
            capacity: 160e3,
            cooling: 40.0,
            initial_rise: 5.0,
            contact_quality: 1.0,
        },
        beam: Beam {
            modulus: 207e9,
            second_moment: section.second_moment,
            to_foot: outline.height() - section.centroid,
            track_modulus: 35e6,
            expansion: 11.5e-6,
            loss_factor: 2e-4,
        },
        exchange: Exchange {
            convection: 6.0,
            emissivity: 0.75,
            absorptivity: 0.75,
            filter: 0.5,
            cold_sky: false,
            pad: 0.0,
            track_azimuth: 0.0,
        },
        train: TrainWeather { shade: true, wind_share: 0.0, overhang: 2.8 },
        start: Start::Equilibrium,
        depths: vec![0.02, 0.06],
        threshold: 0.015,
        outline,
    };
    Energy::new(parameters, &[6; VEHICLES], &WEATHER, 0.0).expect("a section of some cells")
}

/// All wheels, the leading vehicle with its middle at `head`.
fn place(wheels: &mut [Wheel], head: f64) {
    for (index, wheel) in wheels.iter_mut().enumerate() {
        let offsets = [7.2, 5.4, 3.6, -3.6, -5.4, -7.2];
        *wheel = Wheel {
            position: head - 20.0 * (index / 6) as f64 + offsets[index % 6],
            speed: SPEED,
            contact: Contact { normal_force: 109_500.0, a: 0.0063, b: 0.0063 },
            friction_power: 400.0,
            ..Wheel::default()
        };
    }
}

/// A model over which the train has run for 200 s.
fn after_the_run(resolution: Resolution) -> (Energy, Vec<Wheel>) {
    let mut model = model(resolution);
    let mut wheels = vec![Wheel::default(); 6 * VEHICLES];
    for step in 0..200 {
        let start = f64::from(step);
        place(&mut wheels, SPEED * (start + 1.0));
        model.step(&wheels, &WEATHER, start, 1.0);
    }
    (model, wheels)
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
        group.bench_function(format!("{name}/conduction"), |bencher| {
            bencher.iter(|| {
                start += 60.0;
                black_box(model.step(&gone, &WEATHER, start - 60.0, 60.0))
            });
        });
    }
    group.finish();
}

criterion_group!(benches, step);
criterion_main!(benches);
