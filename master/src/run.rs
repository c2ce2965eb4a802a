//! A run from the scenario's file to the results folder.

use std::fmt;
use std::path::{Path, PathBuf};
use std::time::Duration;

use controller::Motion;
use miette::Diagnostic;

use crate::lockstep::Lockstep;
use crate::manifest::{self, Manifest};
use crate::observe::{ObserveError, Recorder};
use crate::parallel;
use crate::prepare::{Folders, PrepareError, prepare};
use crate::progress::Progress;
use crate::report::{self, MainFigure, ReportError};
use crate::scenario::{self, Scenario, ScenarioError};
use crate::times::{StepTimes, Stopwatch};
use crate::unit::{Unit, UnitError};

/// How a scenario is run.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Threads for the vehicles; none: all cores.
    pub threads: Option<usize>,
    /// Folder of the results; none: a new one in `results`.
    pub results: Option<PathBuf>,
    /// Folder of Hotfoot's own FMUs.
    pub fmus: PathBuf,
    /// Simulated time in place of the scenario's, s.
    pub duration: Option<f64>,
    /// No progress bar.
    pub quiet: bool,
}

/// Why a run failed.
#[derive(Debug, thiserror::Error, Diagnostic)]
pub enum RunError {
    /// The scenario is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Scenario(#[from] ScenarioError),
    /// The units cannot be set up.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// A unit cannot be initialised.
    #[error("initialisation: {0}")]
    Start(UnitError),
    /// A unit failed while running; what was recorded before is kept.
    #[error("at {time} s: {source}; the results until then are in {results}")]
    Step {
        /// Time at which the step began, s.
        time: f64,
        /// Reason.
        source: UnitError,
        /// Folder of the results.
        results: String,
    },
    /// A unit could not complete what it writes.
    #[error("at the end of the run: {0}")]
    End(UnitError),
    /// Recording failed.
    #[error(transparent)]
    Observe(#[from] ObserveError),
    /// The report cannot be written.
    #[error(transparent)]
    Report(#[from] ReportError),
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
    /// The simulated time makes no sense.
    #[error("--duration {0}: must be greater than zero seconds")]
    Duration(f64),
}

/// What a finished run tells.
#[derive(Debug)]
pub struct Finished {
    report: PathBuf,
    simulated: f64,
    wall: Duration,
    times: StepTimes,
    steps: u64,
    vehicles: usize,
    threads: usize,
    figures: Vec<MainFigure>,
    warnings: Vec<String>,
}

/// Runs a scenario.
///
/// # Errors
/// When the scenario is wrong or a unit fails.
pub fn run(path: &Path, options: &Options) -> Result<Finished, RunError> {
    let (mut scenario, file, text) = scenario::load(path)?;
    if let Some(duration) = options.duration {
        if !(duration > 0.0 && duration.is_finite()) {
            return Err(RunError::Duration(duration));
        }
        scenario.duration_s = duration;
    }
    let threads = options.threads.unwrap_or_else(default_threads);
    let pool = parallel::pool(threads).map_err(|source| RunError::Threads { threads, source })?;
    let results = match &options.results {
        Some(folder) => folder.clone(),
        None => new_folder(&scenario_name(&file)),
    };
    let io = |source| RunError::Io { path: results.display().to_string(), source };
    let folders = Folders { fmus: options.fmus.clone(), results: absolute(&results).map_err(io)? };

    let mut lockstep = prepare(&scenario, &folders)?;
    let manifest = Manifest::new(&scenario, text, threads, &lockstep);
    pool.install(|| {
        run_prepared(&scenario, &mut lockstep, manifest, &folders.results, options.quiet)
    })
    .and_then(|(simulated, wall, steps)| {
        let (report, figures) = report::write(&folders.results)?;
        Ok(Finished {
            figures,
            report,
            simulated,
            wall,
            times: lockstep.times,
            steps,
            vehicles: lockstep.vehicles.len(),
            threads,
            warnings: warnings(&mut lockstep),
        })
    })
}

/// Initialises, steps and records; gives simulated time, wall time and steps.
fn run_prepared(
    scenario: &Scenario,
    lockstep: &mut Lockstep,
    mut manifest: Manifest,
    results: &Path,
    quiet: bool,
) -> Result<(f64, Duration, u64), RunError> {
    let steps = (scenario.duration_s / scenario.step_s).round() as u64;
    let start = Motion {
        position: scenario.train.leading_vehicle_position_m,
        velocity: scenario.train.speed_m_per_s,
    };
    manifest.write(results)?;
    lockstep.initialize(start, scenario.duration_s).map_err(RunError::Start)?;
    let mut recorder = Recorder::new(scenario, lockstep, &results.join("series"))?;
    recorder.observe(0, lockstep)?;

    let mut progress = Progress::new(steps, scenario.duration_s, quiet);
    let outcome = steps_of_the_run(steps, lockstep, &mut recorder, &mut progress);
    let wall = progress.finish();

    // Whatever happened, what was computed is completed on disk.
    manifest.run.locomotives = recorder.locomotives();
    manifest.run.energy = recorder.energy();
    recorder.finish()?;
    let end = lockstep.terminate();
    let done = *outcome.as_ref().unwrap_or_else(|failed| &failed.k);
    manifest.finish(lockstep.clock.at(done), wall, &lockstep.times);
    manifest.write(results)?;
    outcome.map_err(|failed| failed.into_error(lockstep, results))?;
    end.map_err(RunError::End)?;
    Ok((lockstep.clock.at(steps), wall, steps))
}

/// A step that failed.
struct FailedStep {
    k: u64,
    source: StepFailure,
}

enum StepFailure {
    Unit(UnitError),
    Observe(ObserveError),
}

impl FailedStep {
    fn into_error(self, lockstep: &Lockstep, results: &Path) -> RunError {
        match self.source {
            StepFailure::Unit(source) => RunError::Step {
                time: lockstep.clock.at(self.k),
                source,
                results: results.display().to_string(),
            },
            StepFailure::Observe(source) => source.into(),
        }
    }
}

/// Steps and records from the first to the last step; gives the number of steps.
fn steps_of_the_run(
    steps: u64,
    lockstep: &mut Lockstep,
    recorder: &mut Recorder,
    progress: &mut Progress,
) -> Result<u64, FailedStep> {
    for k in 0..steps {
        lockstep.step(k).map_err(|e| FailedStep { k, source: StepFailure::Unit(e) })?;
        let mut watch = Stopwatch::start();
        recorder
            .observe(k + 1, lockstep)
            .map_err(|e| FailedStep { k, source: StepFailure::Observe(e) })?;
        progress.show(k + 1, lockstep.clock.at(k + 1), lockstep);
        lockstep.times.recording += watch.lap();
    }
    Ok(steps)
}

fn warnings(lockstep: &mut Lockstep) -> Vec<String> {
    let of_unit = |unit: &mut Box<dyn Unit>| -> Vec<String> {
        let texts = unit.take_warnings();
        texts.into_iter().map(|text| format!("{}: {text}", unit.name())).collect()
    };
    lockstep.units_mut().flat_map(of_unit).collect()
}

/// The scenario's folder names the run, or its file if it is not called `scenario.toml`.
pub fn scenario_name(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let absolute = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
    let folder = absolute.parent().and_then(Path::file_name);
    match (stem.as_str(), folder) {
        ("scenario", Some(folder)) => folder.to_string_lossy().into_owned(),
        _ => stem,
    }
}

/// `results/<name>`, or with a number behind it if that is there: no run overwrites another.
pub fn new_folder(name: &str) -> PathBuf {
    let candidate = |n: u32| match n {
        1 => PathBuf::from("results").join(name),
        n => PathBuf::from("results").join(format!("{name}-{n}")),
    };
    (1..).map(candidate).find(|folder| !folder.exists()).unwrap_or_default()
}

/// Makes the folder if it is not there, and gives its absolute path.
///
/// # Errors
/// When it cannot be made.
pub fn absolute(folder: &Path) -> std::io::Result<PathBuf> {
    std::fs::create_dir_all(folder)?;
    std::path::absolute(folder)
}

/// All cores.
pub fn default_threads() -> usize {
    std::thread::available_parallelism().map_or(1, Into::into)
}

impl From<manifest::ManifestError> for RunError {
    fn from(error: manifest::ManifestError) -> Self {
        Self::Io { path: error.path, source: error.source }
    }
}

impl fmt::Display for Finished {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let wall = self.wall.as_secs_f64();
        writeln!(
            f,
            "{:.1} s simulated in {wall:.1} s: {:.2} times real time with {} threads",
            self.simulated,
            self.simulated / wall,
            self.threads
        )?;
        let per_step = |time: Duration| time.as_secs_f64() * 1e6 / self.steps as f64;
        let times = &self.times;
        write!(f, "per step: train {:.1} µs, ", per_step(times.train))?;
        if self.vehicles > 0 {
            let vehicles = per_step(times.vehicles);
            let each = vehicles * self.threads as f64 / self.vehicles as f64;
            write!(f, "vehicles {vehicles:.1} µs ({each:.2} µs a vehicle and thread), ")?;
            write!(f, "rail {:.1} µs, ", per_step(times.rail))?;
        }
        writeln!(
            f,
            "exchange {:.1} µs, recording {:.1} µs",
            per_step(times.exchange),
            per_step(times.recording)
        )?;
        for MainFigure { name, value, place } in &self.figures {
            writeln!(f, "{name:<46} {value:<24} {place}")?;
        }
        for warning in &self.warnings {
            writeln!(f, "warning: {warning}")?;
        }
        write!(f, "report: {}", self.report.display())
    }
}
