//! Time of one step of 1 ms on straight track and in a curve of 800 m.

use std::hint::black_box;
use std::path::Path;
use std::sync::Arc;

use criterion::{Criterion, criterion_group, criterion_main};
use track::Track;
use vehicle::dynamics::Dynamics;
use vehicle::dynamics::inputs::Inputs;
use vehicle::structure::Structure;
use vehicle::track::Line;

fn structure() -> Arc<Structure> {
    let stock = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../stock");
    let library = stock::Library::open(stock).expect("the stock library");
    let vehicle = library.vehicle("locomotive-coco-134t").expect("the vehicle");
    Arc::new(Structure::new(&vehicle).expect("its structure"))
}

fn steps(criterion: &mut Criterion) {
    let curve = "alignment = [{ length_m = 1e6, radius_m = 800.0 }]";
    let inputs = Inputs { traction: 100e3, rear_coupler: 100e3, ..Inputs::none(0.36) };
    for (name, text) in [("straight", ""), ("curve of 800 m", curve)] {
        let track = Arc::new(Line::smooth(Track::from_toml(text, name).expect("a track")));
        let mut vehicle = Dynamics::new(structure(), track);
        vehicle.start(1000.0, 16.67, &inputs);
        criterion.bench_function(&format!("step/{name}"), |bencher| {
            bencher.iter(|| vehicle.step(black_box(1e-3), &inputs));
        });
    }
    let track = Arc::new(Line::smooth(Track::from_toml(curve, "curve").expect("a track")));
    let mut vehicle = Dynamics::new(structure(), track);
    criterion.bench_function("start/curve of 800 m", |bencher| {
        bencher.iter(|| vehicle.start(black_box(1000.0), 16.67, &inputs));
    });
}

criterion_group!(benches, steps);
criterion_main!(benches);
