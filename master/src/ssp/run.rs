//! A run from a package to the results folder.

use std::fmt;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use miette::Diagnostic;
use serde::Serialize;

use super::error::SspError;
use super::read::read;
use super::record::Recorder;
use super::structure::Structure;
use super::system::{StartError, System};
use super::wire::wire;
use crate::archive;
use crate::lockstep::Clock;
use crate::manifest::{FmuEntry, ManifestError, Origin, fmus, write_toml};
use crate::observe::ObserveError;
use crate::parallel;
use crate::progress::Progress;
use crate::run::{absolute, default_threads, new_folder};
use crate::unit::UnitError;

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

/// Why a system's run failed.
#[derive(Debug, thiserror::Error, Diagnostic)]
pub enum SystemRunError {
    /// The package cannot be read, or does not fit its FMUs.
    #[error(transparent)]
    Ssp(#[from] SspError),
    /// A number makes no sense.
    #[error("{name} {value}: must be a number of seconds greater than zero")]
    Number {
        /// Its name.
        name: &'static str,
        /// The number.
        value: f64,
    },
    /// The system cannot be initialised.
    #[error("initialisation: {0}")]
    Start(#[from] StartError),
    /// A component failed while running; what was recorded before is kept.
    #[error("at {time} s: {source}; the results until then are in {results}")]
    Step {
        /// Time at which the step began, s.
        time: f64,
        /// Reason.
        source: UnitError,
        /// Folder of the results.
        results: String,
    },
    /// A component could not complete what it writes.
    #[error("at the end of the run: {0}")]
    End(UnitError),
    /// Recording failed.
    #[error(transparent)]
    Observe(#[from] ObserveError),
    /// A file of the results cannot be written.
    #[error("{path}: {source}")]
    Io {
        /// File or folder.
        path: String,
        /// Reason.
        source: std::io::Error,
    },
    /// The system gives no threads.
    #[error("{threads} threads cannot be started: {source}")]
    Threads {
        /// Threads wanted.
        threads: usize,
        /// Reason.
        source: rayon::ThreadPoolBuildError,
    },
}

impl From<ManifestError> for SystemRunError {
    fn from(error: ManifestError) -> Self {
        Self::Io { path: error.path, source: error.source }
    }
}

/// What made the results of a system's run.
#[derive(Debug, Serialize)]
struct SystemManifest {
    #[serde(flatten)]
    origin: Origin,
    package: String,
    system: String,
    /// Simulated time reached, s; 0 while the run has not ended.
    simulated_s: f64,
    step_s: f64,
    threads: usize,
    wall_time_s: f64,
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
    series: PathBuf,
}

/// Times of a run.
struct Times {
    clock: Clock,
    steps: u64,
    every: u64,
}

impl Times {
    /// What the user says, else what the package says.
    fn of(structure: &Structure, options: &SystemOptions) -> Result<Self, SystemRunError> {
        let start = structure.start.unwrap_or(0.0);
        let length = options.step.or(structure.step).unwrap_or(DEFAULT_STEP);
        let in_package = structure.stop.map(|stop| stop - start);
        let duration = options.duration.or(in_package).unwrap_or(DEFAULT_DURATION);
        let interval = options.interval.unwrap_or(DEFAULT_INTERVAL.max(length));
        let numbers = [("--step", length), ("--duration", duration), ("--interval", interval)];
        for (name, value) in numbers {
            if !(value > 0.0 && value.is_finite()) {
                return Err(SystemRunError::Number { name, value });
            }
        }
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
pub fn run(path: &Path, options: &SystemOptions) -> Result<FinishedSystem, SystemRunError> {
    let threads = options.threads.unwrap_or_else(default_threads);
    let pool =
        parallel::pool(threads).map_err(|source| SystemRunError::Threads { threads, source })?;
    let results = match &options.results {
        Some(folder) => folder.clone(),
        None => new_folder(&path.file_stem().unwrap_or_default().to_string_lossy()),
    };
    let results = absolute(&results)
        .map_err(|source| SystemRunError::Io { path: results.display().to_string(), source })?;
    // The FMUs stay beside the results that they made.
    let package = results.join("package");
    archive::unpack(path, &package).map_err(SspError::from)?;
    let structure = read(&package)?;
    let times = Times::of(&structure, options)?;
    let file = path.display().to_string();
    let mut system = wire(&structure, &package, &file, times.clock)?;
    let mut manifest = SystemManifest {
        origin: Origin::new(),
        package: file,
        system: structure.name.clone(),
        simulated_s: 0.0,
        step_s: times.clock.length,
        threads,
        wall_time_s: 0.0,
        fmu: fmus(system.units()),
    };
    write_toml(&manifest, &results)?;
    let (done, wall, outcome) =
        pool.install(|| step_and_record(&mut system, &times, &results, options.quiet))?;
    manifest.simulated_s = times.clock.at(done) - times.clock.start;
    manifest.wall_time_s = wall.as_secs_f64();
    write_toml(&manifest, &results)?;
    outcome?;
    Ok(FinishedSystem {
        system: structure.name,
        components: system.parts.len(),
        simulated: manifest.simulated_s,
        steps: times.steps,
        wall,
        threads,
        warnings: warnings(&mut system),
        series: results.join("series"),
    })
}

/// Steps done, wall time, and how the run ended.
type Stepped = (u64, Duration, Result<(), SystemRunError>);

/// Initialises, steps and records; whatever happens, what was computed is completed on disk.
fn step_and_record(
    system: &mut System,
    times: &Times,
    results: &Path,
    quiet: bool,
) -> Result<Stepped, SystemRunError> {
    system.initialize(times.stop())?;
    let mut recorder = Recorder::new(system, times.every, &results.join("series"))?;
    recorder.observe(0, system)?;
    let mut progress = Progress::new(times.steps, times.stop(), quiet);
    let begin = Instant::now();
    let mut done = 0;
    let mut outcome = Ok(());
    while outcome.is_ok() && done < times.steps {
        outcome = system
            .step(done)
            .map_err(|source| SystemRunError::Step {
                time: times.clock.at(done),
                source,
                results: results.display().to_string(),
            })
            .and_then(|()| Ok(recorder.observe(done + 1, system)?));
        if outcome.is_ok() {
            done += 1;
            progress.show_with(done, times.clock.at(done), String::new);
        }
    }
    progress.finish();
    let wall = begin.elapsed();
    recorder.finish()?;
    let end = system.terminate().map_err(SystemRunError::End);
    Ok((done, wall, outcome.and(end)))
}

fn warnings(system: &mut System) -> Vec<String> {
    let of_part = |part: &mut super::exchange::Part| {
        let name = part.unit.name().to_owned();
        let warnings = part.unit.take_warnings().into_iter();
        warnings.map(move |text| format!("{name}: {text}")).collect::<Vec<_>>()
    };
    system.parts.iter_mut().flat_map(of_part).collect()
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
        write!(f, "series: {}", self.series.display())
    }
}
