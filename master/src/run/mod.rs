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
//! | `export.rs`, `sources.rs` | a scenario's train as a package |
//! | `wiring.rs` | what would be run, without running it |
//! | `workplace.rs`, `error.rs` | threads and the folder of a run, and why it failed |

mod after;
pub mod error;
pub mod expected;
mod export;
mod finished;
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
mod train_tables;
mod wiring;
pub mod workplace;

use std::path::Path;
use std::time::Instant;

use after::{Continued, FailedStep, StepFailure};
use error::RunError;
pub use export::{Exported, export};
use finished::Done;
pub use finished::Finished;
use live::LiveFigures;
pub use options::Options;
use progress::Progress;
use recorder::Recorder;
use setup::Setup;
pub use wiring::wiring;
use workplace::Workplace;

use crate::report::{self, MainFigure};
use crate::system::parallel;
use crate::system::step::WishToEnd;
use crate::system::times::Stopwatch;
use crate::system::unit::terminate;
use crate::train::fmus::Folders;

/// Runs a scenario, the system in a package, or a single FMU.
///
/// # Errors
/// When the scenario or package is wrong or a unit fails.
pub fn run(path: &Path, options: &Options) -> Result<Finished, RunError> {
    let open = |file: &Path| Workplace::open(options.threads, options.results.as_deref(), file);
    if source::is_system(path) {
        let workplace = open(path)?;
        return workplace.pool.install(|| {
            let setup = package::setup(path, options, &workplace)?;
            in_workplace(setup, &workplace, options.quiet)
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
    let workplace = open(&file)?;
    let folders = Folders { fmus: options.fmus.clone(), results: workplace.results.clone() };
    // With one thread all that an FMU sees, from loading to freeing, happens on it.
    workplace.pool.install(|| {
        let setup = scenario::setup(scenario, (&file, text), &folders, workplace.threads)?;
        in_workplace(setup, &workplace, options.quiet)
    })
}

/// Runs what is set up, on the threads of the workplace, and writes its report.
fn in_workplace(
    mut setup: Setup,
    workplace: &Workplace,
    quiet: bool,
) -> Result<Finished, RunError> {
    let Workplace { threads, results, .. } = workplace;
    let done = perform(&mut setup, results, quiet)?;
    let (report, figures) = report::write(results)?;
    let stages = setup.stages_with_units();
    let Setup { system, mut manifest, .. } = setup;
    manifest.figure.clone_from(&figures);
    manifest.write(results)?;
    Ok(Finished {
        name: manifest.system.map(|system| system.name),
        figures: figures.into_iter().filter(MainFigure::is_shown).collect(),
        report,
        done,
        times: system.times,
        stages,
        threads: *threads,
        warnings: manifest.warnings,
    })
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
    // The observed outputs as they are at the start.
    parallel::for_each(&mut setup.system.parts, |part| part.take_outputs(clock.start))
        .map_err(crate::system::start::StartError::from)?;
    recorder.observe(0, &mut setup.system)?;

    let mut progress = Progress::new(steps, stop, quiet);
    let notes = setup.manifest.run.iter().flat_map(|run| &run.notes);
    notes.for_each(|note| progress.tell(note));
    let begin = Instant::now();
    let mut stepping =
        Stepping { setup, recorder: &mut recorder, progress: &mut progress, live: &live };
    let outcome = stepping.run(steps);
    let wall = begin.elapsed();
    let outcome = outcome.and_then(|end| {
        if let Some(end) = end {
            return Ok(Some(end));
        }
        let Setup { system, rails, .. } = &mut *setup;
        let mut run = Continued { system, recorder: &mut recorder, progress: &mut progress };
        rails.continue_after_run(&mut run, rails_run)?;
        Ok(None)
    });
    setup.system.times.after = begin.elapsed() - wall;
    progress.finish();

    let Setup { system, stages, manifest, .. } = setup;
    if let Some(run) = &mut manifest.run {
        run.energy = recorder.energy("train");
    }
    recorder.finish()?;
    let end = terminate(system.units_mut());
    manifest.warnings.extend(system.take_warnings());
    if let Ok(Some(WishToEnd { of, time, .. })) = &outcome {
        manifest.warnings.push(format!("the run ended at {time} s, because {of} wanted it to end"));
    }
    if let Some(run) = &mut manifest.run {
        run.warnings.clone_from(&manifest.warnings);
    }
    let (reached, rails_end) = match &outcome {
        Ok(None) => (rails_end, rails_end),
        Ok(Some(end)) => (end.time, end.time),
        Err(failed) => (failed.time, rails_end),
    };
    let simulated = reached.min(clock.at(steps)) - clock.start;
    manifest.finish(simulated, wall, system, stages);
    manifest.write(results)?;
    outcome.map_err(|failed| RunError::step(failed, results))?;
    end.map_err(RunError::End)?;
    Ok(Done { simulated, rails: rails_end - clock.start, wall, steps })
}

/// Steps and records.
struct Stepping<'r> {
    setup: &'r mut Setup,
    recorder: &'r mut Recorder,
    progress: &'r mut Progress,
    live: &'r LiveFigures,
}

impl Stepping<'_> {
    /// Takes all units through the steps of the run, or until one of them wants it to end.
    fn run(&mut self, steps: u64) -> Result<Option<WishToEnd>, FailedStep> {
        for k in 0..steps {
            let time = self.setup.system.clock.at(k);
            let failed = |source| FailedStep { time, source };
            let Err(source) = self.step(k) else { continue };
            let system = &mut self.setup.system;
            let end = match &source {
                StepFailure::Unit(error) => system.wish_to_end(error),
                StepFailure::Observe(_) => None,
            };
            let end = end.ok_or_else(|| failed(source))?;
            self.recorder.record_end(k, &end, system).map_err(|error| failed(error.into()))?;
            return Ok(Some(end));
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
