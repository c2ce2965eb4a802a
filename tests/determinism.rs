//! Any number of threads gives the same bytes.

use hotfoot_tests::{PAGE, SmallScenario};
use validation::Finding;

/// The recorded series of a run with so many threads.
fn series(threads: &str) -> Vec<(String, Vec<u8>)> {
    let scenario = SmallScenario::new(3.0);
    scenario.run_well(&["--threads", threads]);
    let folder = scenario.results().join("series");
    let mut files: Vec<_> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .map(|path| {
            (path.file_name().unwrap().to_string_lossy().into(), std::fs::read(path).unwrap())
        })
        .collect();
    files.sort();
    files
}

#[test]
fn property_one_two_and_four_threads_record_the_same_bytes() {
    let one = series("1");
    assert_eq!(one.len(), 4, "train, vehicles, wheels, rail");
    assert!(one == series("2"), "two threads differ from one");
    assert!(one == series("4"), "four threads differ from one");
    let (expected, source) = ("the same bytes", "series recorded with 1 thread");
    Finding { case: "series recorded with 2 and 4 threads", expected, source }.stands_in(&PAGE);
}
