//! A run from a scenario's file or a package to the results folder: one way for both.
//!
//! | file | part |
//! |---|---|
//! | `mod.rs` | the run |
//! | `options.rs`, `setup.rs`, `scenario.rs`, `package.rs`, `source.rs` | what is run, and how |
//! | `recorder.rs`, `step_table.rs`, `output_table.rs`, `train_tables.rs`, `outputs.rs`, `observe_error.rs` | what is recorded |
//! | `after.rs` | what the rails go through after the run |
//! | `manifest.rs`, `finished.rs` | what made the results, and what is told of them |
//! | `expected.rs` | the figures of a run against those expected |
//! | `progress.rs`, `live.rs` | the progress bar |
//! | `stop.rs` | whether the run is to stop before its end |
//! | `export.rs`, `sources.rs` | a scenario's train as a package |
//! | `wiring.rs` | what would be run, without running it |
//! | `folder/` | the folder of a run: claimed, and completed after any end |
//! | `workplace.rs`, `error.rs` | threads and name of a run, and why it failed |

mod after;
pub mod error;
pub mod expected;
mod export;
mod finished;
pub mod folder;
mod live;
mod manifest;
mod observe_error;
mod options;
mod output_table;
mod outputs;
pub mod package;
mod progress;
mod recorder;
pub mod scenario;
mod setup;
mod source;
mod sources;
mod step_table;
mod stop;
mod train_tables;
mod wiring;
pub mod workplace;

use std::path::{Path, PathBuf};
use std::time::Instant;

use after::{Continued, FailedStep, StepFailure};
use error::RunError;
pub use export::{Exported, export};
use finished::Done;
pub use finished::Finished;
use live::LiveFigures;
use manifest::Manifest;
pub use manifest::{End, Ended};
pub use options::Options;
use progress::Progress;
use recorder::Recorder;
use setup::Setup;
use stop::{Early, stopped};
pub use stop::{PARENT_GONE, Stopped, signal_name};
pub use wiring::wiring;
use workplace::Workplace;

use crate::report::{self, MainFigure};
use crate::system::parallel;
use crate::system::times::Stopwatch;
use crate::system::unit::terminate;
use crate::train::fmus::Folders;

/// Runs a scenario, the system in a package, or a single FMU; the results go into the folder `results`,
/// an absolute path, which the caller has claimed for it.
///
/// # Errors
/// When the scenario or package is wrong or a unit fails; what was recorded is complete.
pub fn run(path: &Path, results: &Path, options: &Options) -> Result<Finished, RunError> {
    if source::is_system(path) {
        let workplace = Workplace::open(options.threads)?;
        return workplace.pool.install(|| {
            let setup = package::setup(path, results, options, workplace.threads)?;
            in_workplace(setup, &workplace, results, options.quiet)
        });
    }
    let (mut scenario, file, text) = crate::scenario::load(path)?;
    for (option, value) in options.times.stated() {
        RunError::check_time(option, value)?;
    }
    options.times.replace_in(&mut scenario, &file)?;
    scenario.fmus.tolerance = options.tolerance.or(scenario.fmus.tolerance);
    scenario.checks = options.checks.or(scenario.checks);
    scenario.fmus.same_thread |= options.same_thread;
    scenario.fmus.isolated.clone_from(&options.isolate);
    let workplace = Workplace::open(options.threads)?;
    let folders = Folders { fmus: options.fmus.clone(), results: results.to_owned() };
    // With one thread all that an FMU sees, from loading to freeing, happens on it.
    workplace.pool.install(|| {
        let setup = scenario::setup(scenario, (&file, text), &folders, workplace.threads)?;
        in_workplace(setup, &workplace, results, options.quiet)
    })
}

/// Runs what is set up, on the threads of the workplace, and writes its report, also of a run that has
/// failed.
fn in_workplace(
    mut setup: Setup,
    workplace: &Workplace,
    results: &Path,
    quiet: bool,
) -> Result<Finished, RunError> {
    let outcome = perform(&mut setup, results, quiet);
    let done = match outcome {
        Ok(done) => done,
        Err(error) => {
            // What was recorded has a report nevertheless.
            if setup.recorded {
                let _ = write_report(&mut setup.manifest, results);
            }
            return Err(error);
        }
    };
    let (report, figures) = write_report(&mut setup.manifest, results)?;
    let stages = setup.stages_with_units();
    let Setup { system, manifest, .. } = setup;
    Ok(Finished {
        name: manifest.system.map(|system| system.name),
        figures: figures.into_iter().filter(MainFigure::is_shown).collect(),
        report,
        done,
        stages,
        threads: workplace.threads,
        warnings: manifest.warnings,
        system,
    })
}

/// Writes the report, and its figures into the manifest.
fn write_report(
    manifest: &mut Manifest,
    results: &Path,
) -> Result<(PathBuf, Vec<MainFigure>), RunError> {
    let (report, figures) = report::write(results)?;
    manifest.figure.clone_from(&figures);
    manifest.write(results)?;
    Ok((report, figures))
}

/// Initialises, steps and records; whatever happens, what was computed is completed on disk.
fn perform(setup: &mut Setup, results: &Path, quiet: bool) -> Result<Done, RunError> {
    let Setup { steps, stop, .. } = *setup;
    let clock = setup.system.clock;
    let rails_run = setup.rails.time(&setup.system, steps);
    let rails_end = setup.rails.traffic.end(rails_run);
    setup.manifest.write(results)?;
    let Setup { system, rails, .. } = setup;
    system.initialize(|part| if rails.contain(part) { rails_end } else { stop })?;
    let mut recorder = setup.recorder(&results.join("series"))?;
    let live = setup.live_figures();
    setup.describe()?;
    // From now on a run that is killed can be reported.
    setup.manifest.write(results)?;
    // The observed outputs as they are at the start.
    parallel::for_each(&mut setup.system.parts, |part| part.take_outputs(clock.start))
        .map_err(crate::system::start::StartError::from)?;
    recorder.observe(0, &mut setup.system)?;
    setup.recorded = true;

    let mut progress = Progress::new(steps, stop, quiet);
    let notes = setup.manifest.run.iter().flat_map(|run| &run.notes);
    notes.for_each(|note| progress.tell(note));
    let begin = Instant::now();
    let mut stepping =
        Stepping { setup, recorder: &mut recorder, progress: &mut progress, live: &live };
    let mut outcome = stepping.run(steps);
    let wall = begin.elapsed();
    if matches!(outcome, Ok(None)) {
        let Setup { system, rails, .. } = &mut *setup;
        let mut run = Continued { system, recorder: &mut recorder, progress: &mut progress };
        outcome =
            rails.continue_after_run(&mut run, rails_run).map(|stop| stop.map(Early::Stopped));
    }
    setup.system.times.after = begin.elapsed() - wall;
    progress.finish();

    let Setup { system, stages, manifest, .. } = setup;
    if let Some(run) = &mut manifest.run {
        run.energy = recorder.energy("train");
    }
    // A record that has failed is in some of the tables only.
    let recorded = match &outcome {
        Ok(_) => recorder.finish().map_err(RunError::from),
        Err(_) => {
            drop(recorder);
            let completed = folder::complete::series(results, manifest.run.is_some());
            completed.map(|_| ()).map_err(|error| RunError::Observe(error.into()))
        }
    };
    let end = terminate(system.units_mut()).map_err(RunError::End);
    manifest.warnings.extend(system.take_warnings());
    if let Ok(Some(wish @ Early::Wished(_))) = &outcome {
        manifest.warnings.push(wish.to_string());
    }
    if let Some(run) = &mut manifest.run {
        run.warnings.clone_from(&manifest.warnings);
    }
    let reached = match &outcome {
        Ok(None) => rails_end,
        Ok(Some(early)) => early.time(),
        Err(failed) => failed.time,
    };
    let simulated = reached.min(clock.at(steps)) - clock.start;
    manifest.finish(wall, system, stages);
    let outcome = outcome.map_err(|failed| RunError::step(failed, results));
    let outcome = outcome.and_then(|early| recorded.and(end).map(|()| early));
    manifest.end(simulated, ended(&outcome));
    let written = manifest.write(results);
    let stopped = match outcome? {
        Some(Early::Stopped(stopped)) => Some(stopped),
        Some(Early::Wished(_)) | None => None,
    };
    written?;
    let rails = reached - clock.start;
    let steps = ((simulated / clock.length).round() as u64).max(1);
    Ok(Done { simulated, rails, wall, steps, stopped })
}

/// How a run has ended, for its manifest.
fn ended(outcome: &Result<Option<Early>, RunError>) -> Ended {
    match outcome {
        Ok(None) => Ended { end: End::Complete, end_reason: None },
        Ok(Some(wish @ Early::Wished(_))) => Ended::because(End::Complete, wish.to_string()),
        Ok(Some(stop @ Early::Stopped(_))) => Ended::because(End::Interrupted, stop.to_string()),
        Err(error) => Ended::because(End::Failed, error.to_string()),
    }
}

/// Steps and records.
struct Stepping<'r> {
    setup: &'r mut Setup,
    recorder: &'r mut Recorder,
    progress: &'r mut Progress,
    live: &'r LiveFigures,
}

impl Stepping<'_> {
    /// Takes all units through the steps of the run, until somebody wants it to end.
    fn run(&mut self, steps: u64) -> Result<Option<Early>, FailedStep> {
        for k in 0..steps {
            let time = self.setup.system.clock.at(k);
            let failed = |source| FailedStep { time, source };
            if let Some(stopped) = stopped(k, time) {
                return Ok(Some(Early::Stopped(stopped)));
            }
            let Err(source) = self.step(k) else { continue };
            let system = &mut self.setup.system;
            let wish = match &source {
                StepFailure::Unit(error) => system.wish_to_end(error),
                StepFailure::Observe(_) => None,
            };
            let wish = wish.ok_or_else(|| failed(source))?;
            self.recorder.record_end(k, &wish, system).map_err(|error| failed(error.into()))?;
            return Ok(Some(Early::Wished(wish)));
        }
        Ok(None)
    }

    fn step(&mut self, k: u64) -> Result<(), StepFailure> {
        let Setup { system, rails, .. } = &mut *self.setup;
        system.step(k)?;
        let mut watch = Stopwatch::start();
        rails.observe(k, system)?;
        self.recorder.observe(k + 1, system)?;
        self.progress.show(k + 1, system.clock.at(k + 1), || self.live.text(system));
        system.times.recording += watch.lap();
        Ok(())
    }
}
