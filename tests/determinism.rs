//! Any number of threads gives the same bytes, on any processor.

use hotfoot_tests::{PAGE, SmallScenario, command};
use validation::Finding;

/// Takes from the C library its versions for newer processors; the files keep their bytes, since the
/// models ask it for no elementary function.
const OLDER_PROCESSOR: (&str, &str) =
    ("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX,-AVX2,-AVX512F,-FMA,-FMA4,-ERMS");

/// The recorded series of a run with so many threads.
fn series(
    scenario: &SmallScenario,
    threads: &str,
    environment: &[(&str, &str)],
) -> Vec<(String, Vec<u8>)> {
    scenario.write();
    let arguments = ["run", "scenario.toml", "--quiet", "--results", threads, "--threads", threads];
    let mut command = command(scenario.folder.path(), &arguments);
    let output = command.envs(environment.iter().copied()).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let results = scenario.folder.path().join(threads);
    let folder = results.join("series");
    let mut files: Vec<_> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .map(|path| {
            (path.file_name().unwrap().to_string_lossy().into(), std::fs::read(path).unwrap())
        })
        .collect();
    std::fs::remove_dir_all(results).unwrap();
    files.sort();
    files
}

#[test]
fn property_threads_and_processors_record_the_same_bytes() {
    // The sun is computed, so that its elementary functions take part.
    let sun = "\"site.latitude\" = -0.4\n\"site.longitude\" = 2.6\n\
               \"site.date_time\" = \"2018-12-21T10:30:00+10:00\"\n";
    for scenario in [SmallScenario::new(1.5), SmallScenario::heating_a_short_rail(1.0, "", sun)] {
        let one = series(&scenario, "1", &[]);
        assert_eq!(one.len(), 4, "train, vehicles, wheels, rail");
        for threads in ["2", "4", "7"] {
            assert!(one == series(&scenario, threads, &[]), "{threads} threads differ from one");
        }
        assert!(one == series(&scenario, "1", &[OLDER_PROCESSOR]), "an older processor differs");
    }
    let (expected, source) = ("the same bytes", "series recorded with 1 thread");
    let case = "series recorded with 2, 4 and 7 threads, and as on a processor without AVX and FMA";
    Finding { case, expected, source }.stands_in(&PAGE);
}
