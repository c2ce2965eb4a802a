//! One step of 1 ms of the locomotive in a curve, through the C interface of its FMU as a master
//! calls it: inputs set, step, outputs read. Once with its data in the nearest caches, once in
//! turn with 129 others, as in a train, and in processes of their own: one, and several at once.
//!
//! Needs the packed FMU: `cargo xtask fmus`.

use std::path::Path;
use std::sync::Arc;

use criterion::{Criterion, Throughput, criterion_group};
use hotfoot::{Home, Import, Manner, Unit, roles};

const STEP: f64 = 1e-3;
const CURVE: &str = "alignment = [{ length_m = 1e6, radius_m = 800.0 }]";
const WHEELSETS: usize = 6;
const TRAIN: usize = 130;
/// Vehicles in processes of their own.
const ISOLATED: usize = 8;

/// A vehicle and what a master exchanges with it.
struct Coupled {
    instance: Box<dyn Unit>,
    inputs: Vec<u32>,
    forces: Vec<f64>,
    outputs: Vec<u32>,
    values: Vec<f64>,
    steps: u32,
}

impl Coupled {
    /// The locomotive at 16.67 m/s and `position`, with 100 kN at the rims and at the rear coupler.
    fn new(import: &Arc<Import>, track: &Path, position: f64, home: Home) -> Self {
        let interface = import.interface();
        let reference = |name: &str| interface.variable(name).expect(name).reference;
        let (names, names_of_outputs) = (names("input"), names("output"));
        let force = |name: &String| match name.as_str() {
            "traction.force" | "coupler.rear.force" => 100e3,
            _ => 0.0,
        };
        let manner = Manner { home, ..Manner::default() };
        let mut coupled = Self {
            instance: hotfoot::unit(import, "vehicle", manner).expect("an instance"),
            inputs: names.iter().map(|name| reference(name)).collect(),
            forces: names.iter().map(force).collect(),
            outputs: names_of_outputs.iter().map(|name| reference(name)).collect(),
            values: Vec::new(),
            steps: 0,
        };
        coupled.values = vec![0.0; coupled.outputs.len()];
        let unit = coupled.instance.as_mut();
        let starts = [reference("initial.position"), reference("initial.velocity")];
        unit.set_text(reference("track_file"), &track.display().to_string()).expect("a track");
        unit.set_reals(&starts, &[position, 16.67]).expect("a start");
        unit.enter_initialization(0.0, 1e9).expect("a vehicle");
        unit.set_reals(&coupled.inputs, &coupled.forces).expect("inputs");
        unit.exit_initialization().expect("an equilibrium");
        coupled
    }

    fn step(&mut self) {
        self.begin();
        self.complete();
    }

    fn begin(&mut self) {
        self.instance.set_reals(&self.inputs, &self.forces).expect("inputs");
        self.instance.begin_step(self.time(), STEP).expect("a step");
    }

    fn time(&self) -> f64 {
        f64::from(self.steps) * STEP
    }

    fn complete(&mut self) {
        self.instance.step(self.time(), STEP).expect("a step");
        self.steps += 1;
        self.instance.get_reals(&self.outputs, &mut self.values).expect("outputs");
    }
}

/// What a master sets or reads each step.
fn names(causality: &str) -> Vec<String> {
    let groups = roles::vehicle(WHEELSETS).into_iter().filter(|(_, _, other)| *other == causality);
    let names = |(prefix, variables, _): roles::Group| {
        variables.iter().map(move |variable| format!("{prefix}{}", variable.name))
    };
    groups.flat_map(names).collect()
}

fn steps(criterion: &mut Criterion) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let track = folder.path().join("track.toml");
    std::fs::write(&track, CURVE).expect("the folder is writable");
    let import = Import::open(&hotfoot_tests::fmu("vehicle")).expect("the packed FMU");

    let mut one = Coupled::new(&import, &track, 1000.0, Home::AnyThread);
    criterion.bench_function("vehicle FMU/one", |bencher| bencher.iter(|| one.step()));

    let place = |i: usize| 5000.0 - 20.0 * i as f64;
    let vehicle = |i, home| Coupled::new(&import, &track, place(i), home);
    let mut train: Vec<_> = (0..TRAIN).map(|i| vehicle(i, Home::AnyThread)).collect();
    let mut group = criterion.benchmark_group("vehicle FMU");
    group.throughput(Throughput::Elements(TRAIN as u64));
    group.bench_function("130 in turn", |bencher| {
        bencher.iter(|| train.iter_mut().for_each(Coupled::step));
    });
    group.finish();

    let mut group = criterion.benchmark_group("vehicle FMU in its own process");
    let mut isolated: Vec<_> = (0..ISOLATED).map(|i| vehicle(i, Home::OwnProcess)).collect();
    group.bench_function("one", |bencher| bencher.iter(|| isolated[0].step()));
    group.throughput(Throughput::Elements(ISOLATED as u64));
    group.bench_function("8 at once", |bencher| {
        bencher.iter(|| {
            isolated.iter_mut().for_each(Coupled::begin);
            isolated.iter_mut().for_each(Coupled::complete);
        });
    });
    group.finish();
}

criterion_group!(benches, steps);

fn main() {
    // The processes of isolated FMUs are this program again.
    #[cfg(target_os = "linux")]
    if hotfoot::serve().is_some() {
        return;
    }
    benches();
    Criterion::default().configure_from_args().final_summary();
}
