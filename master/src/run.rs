//! A run from the scenario's file to the results folder.

use std::path::{Path, PathBuf};
use std::time::Instant;

use controller::Motion;
use miette::Diagnostic;

use crate::finished::{Done, Finished};
use crate::foresee::wheels_outside;
use crate::lockstep::Lockstep;
use crate::manifest::{self, Manifest};
use crate::observe::{ObserveError, Recorder};
use crate::parallel;
use crate::prepare::{Folders, PrepareError, prepare};
use crate::prepare_rail::Extent;
use crate::progress::Progress;
use crate::report::{self, MainFigure, ReportError};
use crate::scenario::{self, Scenario, ScenarioError};
use crate::stepping::{FailedStep, StepFailure, Stepping};
use crate::traffic::Traffic;
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
    #[error(
        "at {time} s: {source}; the results until then are in {results}, and `hotfoot report {results}` \
         makes their report"
    )]
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
        None => new_results(&file),
    };
    let io = |source| RunError::Io { path: results.display().to_string(), source };
    let folders = Folders { fmus: options.fmus.clone(), results: absolute(&results).map_err(io)? };

    let mut lockstep = prepare(&scenario, &folders)?;
    let mut manifest = Manifest::new(&scenario, text, threads, &lockstep);
    pool.install(|| {
        run_prepared(&scenario, &mut lockstep, &mut manifest, &folders.results, options.quiet)
    })
    .and_then(|done| {
        let (report, figures) = report::write(&folders.results)?;
        manifest.figure.clone_from(&figures);
        manifest.write(&folders.results)?;
        Ok(Finished {
            figures: figures.into_iter().filter(MainFigure::is_told).collect(),
            report,
            done,
            times: lockstep.times,
            vehicles: lockstep.vehicles.len(),
            threads,
            warnings: manifest.run.warnings,
        })
    })
}

/// Initialises, steps and records.
fn run_prepared(
    scenario: &Scenario,
    lockstep: &mut Lockstep,
    manifest: &mut Manifest,
    results: &Path,
    quiet: bool,
) -> Result<Done, RunError> {
    let steps = (scenario.duration_s / scenario.step_s).round() as u64;
    let start = Motion {
        position: scenario.train.leading_vehicle_position_m,
        velocity: scenario.train.speed_m_per_s,
    };
    let traffic = scenario.heat.as_ref().map(Traffic::of).unwrap_or_default();
    let rails_run = lockstep.rails_time(steps);
    let rails_end = traffic.end(rails_run);
    manifest.write(results)?;
    lockstep.initialize(start, scenario.duration_s, rails_end).map_err(RunError::Start)?;
    let mut recorder = Recorder::new(scenario, lockstep, &results.join("series"))?;
    recorder.observe(0, lockstep)?;

    let mut progress = Progress::new(steps, scenario.duration_s, quiet);
    if let (Some(rail), Some(heat)) = (lockstep.rails.first(), &scenario.heat) {
        let extent = Extent::of(scenario, heat);
        manifest.run.notes = wheels_outside(rail, &extent, scenario.duration_s);
    }
    manifest.run.notes.iter().for_each(|note| progress.tell(note));
    let begin = Instant::now();
    let mut stepping = Stepping { lockstep, recorder: &mut recorder, progress: &mut progress };
    let outcome = stepping.run(steps);
    let wall = begin.elapsed();
    let outcome = outcome.and_then(|()| stepping.go_on(&traffic, rails_run));
    lockstep.times.rails_after = begin.elapsed() - wall;
    progress.finish();

    // Whatever happened, what was computed is completed on disk.
    manifest.run.locomotives = recorder.locomotives();
    manifest.run.energy = recorder.energy();
    recorder.finish()?;
    let end = lockstep.terminate();
    manifest.run.warnings = warnings(lockstep);
    let reached = outcome.as_ref().map_or_else(|failed| failed.time, |()| rails_end);
    let simulated = reached.min(lockstep.clock.at(steps));
    manifest.finish(simulated, wall, &lockstep.times);
    manifest.write(results)?;
    outcome.map_err(|failed| step_error(failed, results))?;
    end.map_err(RunError::End)?;
    Ok(Done { simulated, rails: rails_end, wall, steps })
}

fn step_error(failed: FailedStep, results: &Path) -> RunError {
    let FailedStep { time, source } = failed;
    match source {
        StepFailure::Unit(source) => {
            RunError::Step { time, source, results: results.display().to_string() }
        }
        StepFailure::Observe(source) => source.into(),
    }
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

/// The folder for the results of a scenario whose user names none.
pub fn new_results(scenario: &Path) -> PathBuf {
    new_folder(&scenario_name(&scenario::file_of(scenario)))
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
