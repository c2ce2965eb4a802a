//! The kept corpus of every reader, and mutations of it, in some seconds.
//!
//! To look for more than a gate has time for, `HOTFOOT_MUTATIONS=100000` sets how many mutations of each
//! file are read; CONTRIBUTING.md, "Fuzzing", has what is done with a file that is found.

use std::collections::BTreeSet;
use std::fs;
use std::panic::catch_unwind;
use std::path::{Path, PathBuf};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use readers::mutation::mutated;
use readers::{READERS, Reader};

/// Mutations of each file of the corpus.
const MUTATIONS: u64 = 40;

/// Longest time of a reader for all its files, beside the further mutations that are asked for.
const LONGEST: Duration = Duration::from_secs(60);

/// Longest time for a file, which is small.
const LONGEST_FILE: Duration = Duration::from_secs(5);

/// Address space of this test in bytes: what takes more ends it.
#[cfg(target_os = "linux")]
const MEMORY: u64 = 4 << 30;

/// Folder of the corpus.
fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus")
}

/// The files of a folder in order.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files
}

/// Reads bytes, which are left in a file for one who looks for what has ended the test.
fn read(name: &str, reader: Reader, file: &Path, number: u64, bytes: &[u8]) {
    let kept = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("read-by-{name}"));
    fs::write(&kept, bytes).unwrap();
    let begin = Instant::now();
    let done = catch_unwind(|| reader(bytes));
    let what = || format!("{name} of mutation {number} of {}, kept as", file.display());
    assert!(done.is_ok(), "panic: {} {}", what(), kept.display());
    assert!(begin.elapsed() < LONGEST_FILE, "too slow: {} {}", what(), kept.display());
}

/// Reads all files of a reader and their mutations.
fn replay(name: &str, reader: Reader, mutations: u64) {
    for file in files(&corpus().join(name)) {
        let bytes = fs::read(&file).unwrap();
        read(name, reader, &file, 0, &bytes);
        for number in 1..=mutations {
            read(name, reader, &file, number, &mutated(&bytes, number));
        }
    }
}

#[test]
fn every_reader_answers_its_corpus_and_mutations_of_it() {
    #[cfg(target_os = "linux")]
    limit_memory();
    let asked = std::env::var("HOTFOOT_MUTATIONS").ok();
    let mutations = asked.map_or(MUTATIONS, |text| text.parse().expect("a number of mutations"));
    let longest = LONGEST * u32::try_from(1 + mutations / MUTATIONS).unwrap();
    let mut wrong = vec![];
    for &(name, reader) in READERS {
        let (done, wait) = mpsc::channel();
        std::thread::spawn(move || {
            replay(name, reader, mutations);
            done.send(())
        });
        // A thread that hangs cannot be ended, and goes with the test.
        if let Err(error) = wait.recv_timeout(longest) {
            wrong.push(format!("{name}: {error}"));
        }
    }
    assert!(wrong.is_empty(), "these readers panicked or hung; see above: {wrong:?}");
}

#[cfg(target_os = "linux")]
fn limit_memory() {
    use rustix::process::{Resource, Rlimit, setrlimit};
    let limit = Rlimit { current: Some(MEMORY), maximum: Some(MEMORY) };
    setrlimit(Resource::As, limit).unwrap();
}

#[test]
fn every_reader_has_a_corpus_and_every_corpus_a_reader() {
    let folders = files(&corpus());
    let names = |path: &PathBuf| path.file_name().unwrap().to_string_lossy().into_owned();
    let folders: BTreeSet<_> = folders.iter().map(names).collect();
    let readers: BTreeSet<_> = READERS.iter().map(|(name, _)| (*name).to_owned()).collect();
    assert_eq!(folders, readers);
    for name in &readers {
        assert!(!files(&corpus().join(name)).is_empty(), "the corpus of {name} is empty");
    }
}

#[test]
fn every_reader_has_a_target_of_cargo_fuzz() {
    let targets = include_str!("../../../fuzz/Cargo.toml");
    let targets = targets.lines().filter_map(|line| line.strip_prefix("name = "));
    let targets: BTreeSet<_> = targets.skip(1).map(|name| name.trim_matches('"')).collect();
    assert_eq!(targets, READERS.iter().map(|(name, _)| *name).collect());
}

/// What is found once is found again, and is not what it was made of.
#[test]
fn mutations_are_the_same_every_time() {
    let bytes = b"duration_s = 10.0\n[train]\nspeed_m_per_s = 16.67\n";
    let all: BTreeSet<_> = (1..=200).map(|number| mutated(bytes, number)).collect();
    assert!(all.len() > 150, "{}", all.len());
    assert_eq!(mutated(bytes, 7), mutated(bytes, 7));
}
