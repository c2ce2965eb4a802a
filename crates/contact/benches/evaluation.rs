//! Cost of what a vehicle evaluates for each wheel in each step, and of making a table.

use contact::{
    GeometryTable, Polach, ProfilePair, RailProfile, SlipVelocity, WheelProfile, wheelset_geometry,
};
use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;

fn evaluation(c: &mut Criterion) {
    let wheel = WheelProfile::S1002;
    let pair = ProfilePair::standard_gauge(wheel, RailProfile::Rail60E1, 1.0 / 40.0, 0.46);
    let table = GeometryTable::shared(&pair).expect("a pair that exists");
    let point = table.at(0.002);
    let patch = point.patch(110e3);
    let slip = SlipVelocity { longitudinal: 0.05, lateral: 0.02, spin: 1.0 };
    c.bench_function("table lookup", |b| b.iter(|| table.at(black_box(0.00213))));
    c.bench_function("loaded patch", |b| b.iter(|| black_box(&point).patch(black_box(110e3))));
    c.bench_function("Polach", |b| {
        b.iter(|| Polach::DRY.force(black_box(&patch), black_box(&slip), black_box(20.0)))
    });
    c.bench_function("wheelset geometry", |b| {
        b.iter(|| wheelset_geometry(&pair, black_box(0.003), 0.0))
    });
    // A new radius each time makes a new table.
    let mut radius = 0.40;
    c.bench_function("making a table", |b| {
        b.iter(|| {
            radius += 1e-6;
            let pair = ProfilePair { nominal_radius: radius, ..pair };
            GeometryTable::shared(&pair)
        })
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = evaluation
}
criterion_main!(benches);
