//! Cost of what a vehicle evaluates for each wheel in each step, and of making a table.

use contact::{
    CreepLaw, ExactRolling, FallingFriction, GeometryTable, ModifiedFastsim, Polach, ProfilePair,
    RailProfile, Reduction, SlipVelocity, WheelPosition, WheelProfile, wheelset_geometry,
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
    c.bench_function("contact search: one patch from the table", |b| {
        let wheel = WheelPosition { shift: 0.00213, descent: 1e-5, roll: -1e-4, yaw_squared: 1e-6 };
        b.iter(|| {
            let wheel = black_box(&wheel);
            let mut patch = table.patch(0, table.row(wheel.shift), wheel)?;
            (patch.sunk(wheel) > 0.0).then(|| patch.pressed(wheel))
        })
    });
    let approach = point.hertz.approach(110e3);
    c.bench_function("loaded patch", |b| {
        b.iter(|| black_box(&point).pressed(black_box(approach), black_box(110e3)))
    });
    let friction = FallingFriction::constant(0.3);
    let reduction = Reduction::EUROSPRINTER;
    for (name, law) in [
        ("exact rolling by table", CreepLaw::ExactRolling(ExactRolling::new(reduction, friction))),
        (
            "modified FASTSIM on line, 10 x 20",
            CreepLaw::Fastsim(ModifiedFastsim::on_line(reduction, friction, 5, 20)),
        ),
        ("Polach", CreepLaw::Polach(Polach::DRY)),
        ("Shen-Hedrick-Elkins", CreepLaw::ShenHedrickElkins(friction.into())),
    ] {
        c.bench_function(&format!("creep law: {name}"), |b| {
            b.iter(|| law.force(black_box(&patch), black_box(&slip), black_box(20.0)))
        });
    }
    c.bench_function("wheelset geometry", |b| {
        b.iter(|| wheelset_geometry(&pair, black_box(0.003), 0.0))
    });
    // A new radius each time makes a new table.
    let mut radius = 0.40;
    c.bench_function("making a table", |b| {
        b.iter(|| {
            radius += 1e-6;
            let pair = ProfilePair { nominal_radius: radius, ..pair.clone() };
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
