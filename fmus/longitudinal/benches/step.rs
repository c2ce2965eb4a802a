//! Cost of a step of 1 ms of the paper's train through its FMI interface.
//!
//! Divide by its 2 locomotives and 128 wagons for the cost of a vehicle.

use std::path::Path;

use criterion::{Criterion, criterion_group, criterion_main};
use fmu::{Declaration, Interval, Log, Model};
use longitudinal::Train;

const STOCK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../stock");
const CONSIST: &str = "vehicle = [{ type = 'locomotive-coco-134t', count = 2 },
                                  { type = 'wagon-coco-134t-unpowered', count = 128 }]";

/// Steps the train, which starts at 16.67 m/s on the curve of the paper, under one command.
fn bench_step(criterion: &mut Criterion, name: &str, command: &str) {
    let folder = tempfile::tempdir().expect("a folder for the resources");
    let write = |name: &str, text: &str| {
        std::fs::write(folder.path().join(name), text).expect("a file of the resources");
    };
    write("consist.toml", CONSIST);
    write("driver.toml", &format!("command = [{{ from_s = 0, {command} }}]"));
    write("track.toml", "alignment = [{ length_m = 300 }, { length_m = 9e6, radius_m = 800 }]");
    for part in ["vehicles", "draft_gears"] {
        let to = folder.path().join("stock").join(part);
        std::fs::create_dir_all(&to).expect("a folder of the stock");
        for file in std::fs::read_dir(Path::new(STOCK).join(part)).expect("the shipped stock") {
            let file = file.expect("a file of the stock");
            std::fs::copy(file.path(), to.join(file.file_name())).expect("a copy of it");
        }
    }
    let mut declaration = Declaration::default();
    let signals = Train::declare(folder.path(), &mut declaration).expect("a consist that is right");
    let mut values = declaration.start_values().clone();
    values[signals.train.initial.velocity] = 16.67;
    let mut log = Log::default();
    let mut train = Train::initialize(&signals, &mut values, folder.path(), 0.0, &mut log)
        .expect("resources that are right");
    let mut k = 0;
    criterion.bench_function(name, |bencher| {
        bencher.iter(|| {
            let interval = Interval { start: f64::from(k) * 1e-3, length: 1e-3 };
            k += 1;
            train.step(&signals, &mut values, interval, &mut log).expect("a step");
        });
    });
}

fn benches(criterion: &mut Criterion) {
    bench_step(criterion, "130 vehicles, notch 8", "notch = 8");
    bench_step(criterion, "130 vehicles, train brake", "train_brake = 0.05");
}

criterion_group!(step, benches);
criterion_main!(step);
