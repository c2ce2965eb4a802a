//! A step of the vehicle allocates nothing, whatever the vehicle and its track.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::sync::Arc;

use fmu::Instance;
use hotfoot_tests::resources;
use track::TrackFile;
use vehicle::Vehicle;
use vehicle::dynamics::Dynamics;
use vehicle::dynamics::inputs::Inputs;
use vehicle::structure::Structure;
use vehicle::track::Line;

thread_local! {
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

/// Counts what this thread allocates.
struct Counting;

#[allow(unsafe_code)]
// SAFETY: every call is handed on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        // SAFETY: the caller keeps the contract of `alloc`.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        // SAFETY: the caller keeps the contract of `dealloc`, and the memory is the system's.
        unsafe { System.dealloc(memory, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

const TRACK: &str = "
    alignment = [{ length_m = 1e4, radius_m = 800.0, cant_mm = 40.0 }]
    friction = [{ chainage_m = 0.0, factor = 0.9 }, { chainage_m = 1001.0, factor = 0.8 }]
    [irregularity]
    spectrum = { quality = 'erri-low', seed = 1, begin_m = 900.0, length_m = 200.0 }
    [support]
    lateral_stiffness_n_m = 25e6
    lateral_damping_n_s_m = 50e3
    vertical_stiffness_n_m = 60e6
    vertical_damping_n_s_m = 100e3";

#[test]
fn property_a_step_allocates_nothing() {
    let library = stock::Library::open(hotfoot_tests::root().join("stock")).unwrap();
    for name in ["locomotive-coco-134t", "wagon-ore-40t"] {
        let structure = Structure::shared(&library.vehicle(name).unwrap()).unwrap();
        let line = Line::new(&TrackFile::new(TRACK, "t").unwrap()).unwrap();
        let mut vehicle = Dynamics::new(structure, Arc::new(line));
        let inputs = Inputs { traction: 50e3, rear_coupler: 50e3, ..Inputs::none(0.36) };
        vehicle.start(1000.0, 15.0, &inputs);
        vehicle.step(5e-4, &inputs);
        let before = COUNT.with(Cell::get);
        for _ in 0..100 {
            vehicle.step(5e-4, &inputs);
        }
        let allocated = COUNT.with(Cell::get) - before;
        assert_eq!(allocated, 0, "{name}");
    }
}

/// Nor does what the FMU does around it: inputs, checks, outputs.
#[test]
fn property_a_step_of_the_fmu_allocates_nothing() {
    let folder = resources("vehicle");
    std::fs::write(folder.path().join("track.toml"), TRACK).unwrap();
    let mut instance = Instance::<Vehicle>::new(folder.path(), "v", Box::new(|_, _| {})).unwrap();
    let variables = instance.declaration().variables();
    let reference =
        |name: &str| variables.iter().find(|variable| variable.name == name).unwrap().reference;
    let starts = ["initial.position", "initial.velocity"].map(reference);
    let inputs = ["traction.force", "friction.coefficient"].map(reference);
    let outputs = ["position", "wheelset[1].left.friction_power"].map(reference);
    instance.set_real(&starts, [1000.0, 15.0]).unwrap();
    instance.setup_experiment(0.0, None).unwrap();
    instance.enter_initialization_mode().unwrap();
    instance.exit_initialization_mode().unwrap();
    let mut before = 0;
    for step in 0..100 {
        if step == 1 {
            before = COUNT.with(Cell::get);
        }
        instance.set_real(&inputs, [50e3, 0.36]).unwrap();
        instance.do_step(f64::from(step) * 1e-3, 1e-3).unwrap();
        assert!(instance.get_real(&outputs).unwrap().all(f64::is_finite));
    }
    assert_eq!(COUNT.with(Cell::get) - before, 0);
}
