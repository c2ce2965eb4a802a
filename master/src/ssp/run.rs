//! A run from a package to the results folder.

use std::fmt;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use serde::Serialize;

use super::error::SspError;
use super::read::read;
use super::record::{Recorder, renamed, table_name};
use super::wire::wire;
use crate::files::archive;
use crate::report::{self, ComponentFacts, SystemFacts};
use crate::run::error::RunError;
use crate::run::manifest::{FmuEntry, Origin, fmus, write_toml};
use crate::run::progress::Progress;
use crate::run::stepping::{FailedStep, StepFailure};
use crate::run::workplace::Workplace;
use crate::system::links::Part;
use crate::system::step::System;
use crate::system::structure::Structure;
use crate::system::times::Stopwatch;
use crate::system::unit::{take_warnings, terminate};
use crate::train::lockstep::Clock;

/// How a system is run.
#[derive(Debug, Clone, Default)]
pub struct SystemOptions {
    /// Threads for the components; none: all cores.
    pub threads: Option<usize>,
    /// Folder of the results; none: a new one in `results`.
    pub results: Option<PathBuf>,
    /// Simulated time in place of the package's, s.
    pub duration: Option<f64>,
    /// Step of the exchange in place of the package's, s.
    pub step: Option<f64>,
    /// Time between two records, s.
    pub interval: Option<f64>,
    /// No progress bar.
    pub quiet: bool,
}

/// Step where neither the package nor the user names one, s.
const DEFAULT_STEP: f64 = 1e-3;
/// Simulated time where neither the package nor the user names one, s.
const DEFAULT_DURATION: f64 = 1.0;
/// Time between two records where the user names none, s.
const DEFAULT_INTERVAL: f64 = 0.1;

/// What made the results of a system's run.
#[derive(Debug, Serialize)]
struct SystemManifest {
    #[serde(flatten)]
    origin: Origin,
    /// What the report shows of the run.
    system: SystemFacts,
    fmu: Vec<FmuEntry>,
}

/// What a finished run tells.
#[derive(Debug)]
pub struct FinishedSystem {
    system: String,
    components: usize,
    simulated: f64,
    steps: u64,
    wall: Duration,
    threads: usize,
    warnings: Vec<String>,
    report: PathBuf,
}

/// Times of a run.
struct Times {
    clock: Clock,
    steps: u64,
    every: u64,
}

impl Times {
    /// What the user says, else what the package says.
    fn of(structure: &Structure, options: &SystemOptions) -> Result<Self, RunError> {
        let start = structure.start.unwrap_or(0.0);
        let length = options.step.or(structure.step).unwrap_or(DEFAULT_STEP);
        let in_package = structure.stop.map(|stop| stop - start);
        let duration = options.duration.or(in_package).unwrap_or(DEFAULT_DURATION);
        let interval = options.interval.unwrap_or(DEFAULT_INTERVAL.max(length));
        RunError::check_time("--step", length)?;
        RunError::check_time("--duration", duration)?;
        RunError::check_time("--interval", interval)?;
        Ok(Self {
            clock: Clock { start, length },
            steps: ((duration / length).round() as u64).max(1),
            every: ((interval / length).round() as u64).max(1),
        })
    }

    fn stop(&self) -> f64 {
        self.clock.at(self.steps)
    }
}

/// Runs the system in the package at `path`.
///
/// # Errors
/// When the package is wrong or a component fails.
pub fn run(path: &Path, options: &SystemOptions) -> Result<FinishedSystem, RunError> {
    let Workplace { threads, pool, results } =
        Workplace::open(options.threads, options.results.as_deref(), path)?;
    // The FMUs stay beside the results that they made.
    let package = results.join("package");
    archive::unpack(path, &package).map_err(SspError::from)?;
    let structure = read(&package)?;
    let times = Times::of(&structure, options)?;
    let file = path.display().to_string();
    let mut system = wire(&structure, &package, &file, times.clock)?;
    let facts = SystemFacts {
        name: structure.name,
        package: file,
        simulated_s: 0.0,
        step_s: times.clock.length,
        threads,
        wall_time_s: None,
        recording_s: 0.0,
        component: system.parts.iter().map(component_facts).collect(),
    };
    let mut manifest =
        SystemManifest { origin: Origin::new(), system: facts, fmu: fmus(system.units()) };
    write_toml(&manifest, &results)?;
    let Stepped { steps: done, wall, recording, outcome } =
        pool.install(|| step_and_record(&mut system, &times, &results, options.quiet))?;
    let facts = &mut manifest.system;
    facts.simulated_s = times.clock.at(done) - times.clock.start;
    facts.wall_time_s = Some(wall.as_secs_f64());
    facts.recording_s = recording.as_secs_f64();
    facts.component = system.parts.iter().map(component_facts).collect();
    write_toml(&manifest, &results)?;
    outcome?;
    let (report, _) = report::write(&results)?;
    Ok(FinishedSystem {
        simulated: manifest.system.simulated_s,
        system: manifest.system.name,
        components: system.parts.len(),
        steps: times.steps,
        wall,
        threads,
        warnings: [renamed(&system), take_warnings(system.units_mut())].concat(),
        report,
    })
}

fn component_facts(part: &Part) -> ComponentFacts {
    let file = Path::new(part.unit.source_file()).file_name().unwrap_or_default();
    ComponentFacts {
        name: part.unit.name().to_owned(),
        fmu: file.to_string_lossy().into_owned(),
        series: table_name(part.unit.as_ref()),
        wall_time_s: part.wall.as_secs_f64(),
    }
}

/// How far a run has come, and how it ended.
struct Stepped {
    /// Steps done.
    steps: u64,
    /// Their wall time with recording.
    wall: Duration,
    /// That of recording alone.
    recording: Duration,
    outcome: Result<(), RunError>,
}

/// Initialises, steps and records; whatever happens, what was computed is completed on disk.
fn step_and_record(
    system: &mut System,
    times: &Times,
    results: &Path,
    quiet: bool,
) -> Result<Stepped, RunError> {
    system.initialize(times.stop())?;
    let mut recorder = Recorder::new(system, times.every, &results.join("series"))?;
    recorder.observe(0, system)?;
    let mut progress = Progress::new(times.steps, times.stop(), quiet);
    let begin = Instant::now();
    let (mut steps, mut recording) = (0, Duration::ZERO);
    let mut outcome = Ok(());
    while outcome.is_ok() && steps < times.steps {
        let time = times.clock.at(steps);
        outcome = step(system, &mut recorder, steps, &mut recording)
            .map_err(|source| FailedStep { time, source });
        if outcome.is_ok() {
            steps += 1;
            progress.show_with(steps, times.clock.at(steps), String::new);
        }
    }
    progress.finish();
    let wall = begin.elapsed();
    recorder.finish()?;
    let end = terminate(system.units_mut()).map_err(RunError::End);
    let outcome = outcome.map_err(|failed| RunError::step(failed, results)).and(end);
    Ok(Stepped { steps, wall, recording, outcome })
}

/// Takes the system from point `k` to `k + 1` and records it, which adds to the time of `recording`.
fn step(
    system: &mut System,
    recorder: &mut Recorder,
    k: u64,
    recording: &mut Duration,
) -> Result<(), StepFailure> {
    system.step(k)?;
    let mut watch = Stopwatch::start();
    recorder.observe(k + 1, system)?;
    *recording += watch.lap();
    Ok(())
}

impl fmt::Display for FinishedSystem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let wall = self.wall.as_secs_f64();
        writeln!(
            f,
            "{}: {:.1} s simulated in {wall:.1} s with {} threads, {:.1} µs a step of {} components",
            self.system,
            self.simulated,
            self.threads,
            wall * 1e6 / self.steps as f64,
            self.components,
        )?;
        for warning in &self.warnings {
            writeln!(f, "warning: {warning}")?;
        }
        write!(f, "report: {}", self.report.display())
    }
}
