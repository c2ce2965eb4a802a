//! A step, with what goes in and out, allocates no memory.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use fmu::Status;

use crate::tool::Fmu;

/// The system's allocator, which counts what each thread asks for.
struct Counting;

thread_local! {
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: the system's allocator does the work; counting touches no memory of its.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.set(COUNT.get() + 1);
        // SAFETY: the caller keeps to the contract of `alloc`.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller keeps to the contract of `dealloc`.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Number of allocations of this thread while it does something.
fn allocations(action: impl FnOnce()) -> usize {
    let before = COUNT.get();
    action();
    COUNT.get() - before
}

#[test]
fn allocations_are_counted() {
    assert_eq!(allocations(|| drop(std::hint::black_box(Box::new(1)))), 1);
}

#[test]
fn setting_stepping_and_getting_allocate_nothing() {
    let fmu = Fmu::running();
    let force = fmu.reference("force");
    let position = fmu.reference("position");
    let mut value = 0.0;
    let count = allocations(|| {
        for index in 0..100 {
            let start = f64::from(index) * 0.01;
            // SAFETY: the component lives, and there is one value.
            let statuses = unsafe {
                [
                    crate::fmi2::fmi2SetReal(fmu.component, &force, 1, &start),
                    crate::fmi2::fmi2DoStep(fmu.component, start, 0.01, 1),
                    crate::fmi2::fmi2GetReal(fmu.component, &position, 1, &mut value),
                ]
            };
            assert_eq!(statuses, [Status::Ok; 3]);
        }
    });
    assert_eq!(count, 0);
}

#[test]
fn saving_into_a_state_that_is_there_allocates_nothing() {
    let fmu = Fmu::running();
    let mut state = fmu.save();
    let count = allocations(|| assert_eq!(fmu.save_into(&mut state), Status::Ok));
    assert_eq!(count, 0);
    assert_eq!(fmu.free_state(&mut state), Status::Ok);
}
