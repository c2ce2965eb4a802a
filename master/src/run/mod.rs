//! A run from a scenario's file or a package to the results folder: one way for both.
//!
//! | file | part |
//! |---|---|
//! | `mod.rs` | the run |
//! | `options.rs`, `setup.rs`, `scenario.rs`, `package.rs`, `source.rs` | what is run, and how |
//! | `recorder.rs`, `step_table.rs`, `output_table.rs`, `train_tables.rs`, `outputs.rs`, `observe_error.rs` | what is recorded |
//! | `after.rs` | what the rails go through after the run |
//! | `checkpoint` | from where a run can go on |
//! | `begun.rs`, `manifest.rs`, `finished.rs` | what made the results, and what is told of them |
//! | `expected.rs` | the figures of a run against those expected |
//! | `progress.rs`, `live.rs` | the progress bar |
//! | `stop.rs` | whether the run is to stop before its end |
//! | `export.rs`, `sources.rs` | a scenario's train as a package |
//! | `wiring.rs` | what would be run, without running it |
//! | `folder/` | the folder of a run: claimed, and completed after any end |
//! | `workplace.rs`, `error.rs` | threads and name of a run, and why it failed |

mod after;
mod begun;
mod checkpoint;
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

#[cfg(test)]
mod after_tests;

use std::path::{Path, PathBuf};

use after::{Continued, FailedStep, StepFailure};
use checkpoint::{Beginning, CheckpointError, Checkpoints, Order, Reached, Subject};
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
use crate::scenario::Times;
use crate::system::times::{Stopwatch, Timer};
use crate::system::unit::terminate;
use crate::train::fmus::Folders;

/// Runs a scenario, the system in a package, or a single FMU; the results go into the folder `results`,
/// an absolute path, which the caller has claimed for it.
///
/// # Errors
/// When the scenario or package is wrong or a unit fails; what was recorded is complete.
pub fn run(path: &Path, results: &Path, options: &Options) -> Result<Finished, RunError> {
    run_or_resume(&Subject::new(path)?, results, options, checkpoint::begin)
}

/// Goes on with the run in a claimed folder of results, from its newest whole checkpoint.
///
/// What it writes is what it would have written anyway, on any number of threads. Of the `options` the threads
/// count and whether it is quiet.
///
/// # Errors
/// When there is no run that can go on, or a unit fails.
pub fn resume(results: &Path, options: &Options) -> Result<Finished, RunError> {
    let order = checkpoint::order_of(results)?;
    let options = order.options(options);
    // Its folder as it was written then: FMUs have it in their states.
    run_or_resume(&order.subject, &order.results, &options, checkpoint::resume)
}

fn run_or_resume(
    subject: &Subject,
    results: &Path,
    options: &Options,
    begin: fn(&Order) -> Result<Beginning, CheckpointError>,
) -> Result<Finished, RunError> {
    let Subject { path, written } = subject;
    if source::is_system(path) {
        let workplace = Workplace::open(options.threads)?;
        // With one thread all that an FMU sees, from loading to freeing, happens on it.
        return workplace.pool.install(|| {
            let beginning = begin(&Order::new(subject, options, results, source::inputs(path)?)?)?;
            let setup = package::setup((path, written), results, options, workplace.threads)?;
            in_workplace(setup, &workplace, results, options.quiet, beginning)
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
    let workplace = Workplace::open(options.threads)?;
    let folders = Folders { fmus: options.fmus.clone(), results: results.to_owned() };
    workplace.pool.install(|| {
        let inputs = [vec![file.clone()], scenario.inputs(), folders.own_fmus()].concat();
        let times = Times { checkpoint: scenario.record.checkpoint_s, ..options.times };
        let ordered = Options { times, ..options.clone() };
        let beginning = begin(&Order::new(subject, &ordered, results, inputs)?)?;
        let setup = scenario::setup(scenario, (&file, text), &folders, workplace.threads)?;
        in_workplace(setup, &workplace, results, options.quiet, beginning)
    })
}

/// Runs what is set up, on the threads of the workplace, and writes its report, also of a run that has
/// failed.
fn in_workplace(
    mut setup: Setup,
    workplace: &Workplace,
    results: &Path,
    quiet: bool,
    mut beginning: Beginning,
) -> Result<Finished, RunError> {
    let outcome = perform(&mut setup, results, quiet, &mut beginning);
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
    if done.stopped.is_none() {
        beginning.checkpoints.map_or(Ok(()), Checkpoints::remove)?;
    }
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
fn perform(
    setup: &mut Setup,
    results: &Path,
    quiet: bool,
    beginning: &mut Beginning,
) -> Result<Done, RunError> {
    let Setup { steps, stop, .. } = *setup;
    let clock = setup.system.clock;
    let rails_run = setup.rails.time(&setup.system, steps);
    let rails_end = setup.rails.traffic.end(rails_run);
    setup.check_states(beginning)?;
    setup.manifest.write(results)?;
    let Setup { system, rails, .. } = setup;
    system.initialize(|part| if rails.contain(part) { rails_end } else { stop })?;
    let mut recorder = setup.recorder(&results.join("series"))?;
    let live = setup.live_figures();
    setup.describe()?;
    // From now on a run that is killed can be reported.
    setup.manifest.write(results)?;
    let mut progress = Progress::new(steps, stop, quiet);
    let reached = setup.begin(beginning.state.take(), &mut recorder, &mut progress)?;
    let notes = setup.manifest.run.iter().flat_map(|run| &run.notes);
    beginning.notes.iter().chain(notes).for_each(|note| progress.tell(note));

    let timer = Timer::after(setup.system.times.run);
    let checkpoints = beginning.checkpoints.as_mut();
    let (recorded, shown) = (&mut recorder, &mut progress);
    let mut stepping =
        Stepping { setup, recorder: recorded, progress: shown, live: &live, checkpoints, timer };
    let mut outcome = stepping.run(reached);
    if let Reached::Run(_) = reached {
        setup.system.times.run = stepping.timer.elapsed();
    }
    if matches!(outcome, Ok(None)) {
        let Setup { system, rails, .. } = &mut *setup;
        let timer = Timer::after(system.times.after);
        let checkpoints = beginning.checkpoints.as_mut();
        let (recorder, progress) = (&mut recorder, &mut progress);
        let mut run = Continued { system, recorder, progress, checkpoints, timer };
        let stopped = rails.continue_after_run(&mut run, rails_run, reached);
        outcome = stopped.map(|stopped| stopped.map(Early::Stopped));
        run.system.times.after = run.timer.elapsed();
    }
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
    let wall = system.times.run;
    manifest.finish(system, stages);
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
    checkpoints: Option<&'r mut Checkpoints>,
    timer: Timer,
}

impl Stepping<'_> {
    /// Takes all units through the steps of the run behind what is reached, until somebody wants it to end.
    fn run(&mut self, reached: Reached) -> Result<Option<Early>, FailedStep> {
        let Reached::Run(done) = reached else { return Ok(None) };
        for k in done..self.setup.steps {
            let time = self.setup.system.clock.at(k);
            let failed = |source| FailedStep { time, source };
            if let Some(stopped) = stopped(k, time) {
                self.write_checkpoint(k).map_err(failed)?;
                return Ok(Some(Early::Stopped(stopped)));
            }
            let Err(source) = self.step(k) else { continue };
            let system = &mut self.setup.system;
            let wish = match &source {
                StepFailure::Unit(error) => system.wish_to_end(error),
                StepFailure::Observe(_) | StepFailure::Checkpoint(_) => None,
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
        let end = system.clock.at(k + 1);
        match self.checkpoints.as_ref().is_some_and(|checkpoints| checkpoints.is_due(end)) {
            true => self.write_checkpoint(k + 1),
            false => Ok(()),
        }
    }

    /// Writes a checkpoint at point `k`, if the run writes any.
    fn write_checkpoint(&mut self, k: u64) -> Result<(), StepFailure> {
        let Some(checkpoints) = &mut self.checkpoints else { return Ok(()) };
        let Setup { system, rails, .. } = &mut *self.setup;
        system.times.run = self.timer.elapsed();
        let reached = (Reached::Run(k), system.clock.at(k));
        Ok(checkpoints.write(reached, rails.save()?, system, self.recorder)?)
    }
}
