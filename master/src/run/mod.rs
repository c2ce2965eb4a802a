//! A run from a scenario's file or a package to the results folder: one way for both.
//!
//! | file | part |
//! |---|---|
//! | `mod.rs` | the run |
//! | `setup.rs`, `scenario.rs`, `package.rs` | what is run |
//! | `recorder.rs`, `step_table.rs`, `output_table.rs`, `train_tables.rs`, `outputs.rs`, `observe_error.rs` | what is recorded |
//! | `after.rs` | what the rails go through after the run |
//! | `checkpoint` | from where a run can go on |
//! | `manifest.rs`, `finished.rs` | what made the results, and what is told of them |
//! | `expected.rs` | the figures of a run against those expected |
//! | `progress.rs`, `live.rs` | the progress bar |
//! | `export.rs`, `sources.rs` | a scenario's train as a package |
//! | `wiring.rs` | what would be run, without running it |
//! | `workplace.rs`, `error.rs` | threads and the folder of a run, and why it failed |

mod after;
mod checkpoint;
pub mod error;
pub mod expected;
mod export;
mod finished;
mod live;
mod manifest;
mod observe_error;
mod output_table;
mod outputs;
pub mod package;
mod progress;
mod recorder;
pub mod scenario;
mod setup;
mod sources;
mod step_table;
mod train_tables;
mod wiring;
pub mod workplace;

#[cfg(test)]
mod after_tests;

use std::ops::Range;
use std::path::{Path, PathBuf};

use after::{Continued, FailedStep, StepFailure};
use checkpoint::{Beginning, CheckpointError, Checkpoints, Order, Reached, Subject};
use error::RunError;
pub use export::{Exported, export};
use finished::Done;
pub use finished::Finished;
use live::LiveFigures;
use progress::Progress;
use recorder::Recorder;
use setup::Setup;
pub use wiring::wiring;
use workplace::Workplace;

use crate::report::{self, MainFigure};
use crate::scenario::Times;
use crate::system::times::{Stopwatch, Timer};
use crate::system::unit::{take_warnings, terminate};
use crate::train::fmus::Folders;

/// How a scenario or a package is run.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Threads for the units; none: all cores.
    pub threads: Option<usize>,
    /// Folder of the results; none: a new one in `results`.
    pub results: Option<PathBuf>,
    /// Folder of Hotfoot's own FMUs.
    pub fmus: PathBuf,
    /// Times instead of the scenario's or the package's.
    pub times: Times,
    /// No progress bar.
    pub quiet: bool,
}

/// Whether a file is an SSP package; otherwise it is a scenario.
pub fn is_package(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "ssp")
}

/// Runs a scenario or the system in a package.
///
/// # Errors
/// When the scenario or package is wrong or a unit fails.
pub fn run(path: &Path, options: &Options) -> Result<Finished, RunError> {
    run_or_resume(&Subject::new(path)?, options, checkpoint::begin)
}

/// Goes on with the run in a folder of results, from its newest checkpoint that is whole.
///
/// What it writes is what it would have written anyway, on any number of threads. Of the `options` the threads
/// count and whether it is quiet.
///
/// # Errors
/// When there is no run that can go on, or a unit fails.
pub fn resume(results: &Path, options: &Options) -> Result<Finished, RunError> {
    let order = checkpoint::order_of(results)?;
    let options = Options {
        threads: options.threads,
        // As it was written then: FMUs have it in their states.
        results: Some(order.results),
        fmus: order.fmus,
        times: order.times,
        quiet: options.quiet,
    };
    run_or_resume(&order.subject, &options, checkpoint::resume)
}

fn run_or_resume(
    subject: &Subject,
    options: &Options,
    begin: fn(&Order) -> Result<Beginning, CheckpointError>,
) -> Result<Finished, RunError> {
    let Options { threads, results, fmus, times, quiet } = options;
    let Subject { path, written } = subject;
    let open = |file: &Path| Workplace::open(*threads, results.as_deref(), file);
    if is_package(path) {
        let workplace = open(path)?;
        let folders = (workplace.results.as_path(), fmus.as_path());
        let beginning = begin(&Order::new(subject, *times, folders, vec![path.clone()])?)?;
        let package = (path.as_path(), written.as_str());
        let setup = package::setup(package, &workplace.results, times, workplace.threads)?;
        return in_workplace(setup, &workplace, *quiet, beginning);
    }
    let (mut scenario, file, text) = crate::scenario::load(path)?;
    for (option, value) in times.stated() {
        RunError::check_time(option, value)?;
    }
    times.replace_in(&mut scenario, &file)?;
    let workplace = open(&file)?;
    let folders = Folders { fmus: fmus.clone(), results: workplace.results.clone() };
    let times = Times { checkpoint: scenario.record.checkpoint_s, ..*times };
    let inputs = [vec![file.clone()], scenario.inputs(), folders.own_fmus()].concat();
    let beginning = begin(&Order::new(subject, times, (&folders.results, fmus), inputs)?)?;
    let setup = scenario::setup(scenario, (&file, text), &folders, workplace.threads)?;
    in_workplace(setup, &workplace, *quiet, beginning)
}

/// Runs what is set up, and writes its report.
fn in_workplace(
    mut setup: Setup,
    workplace: &Workplace,
    quiet: bool,
    mut beginning: Beginning,
) -> Result<Finished, RunError> {
    let Workplace { threads, pool, results } = workplace;
    let done = pool.install(|| perform(&mut setup, results, quiet, &mut beginning))?;
    let (report, figures) = report::write(results)?;
    let stages = setup.stages_with_units();
    let Setup { system, mut manifest, .. } = setup;
    manifest.figure.clone_from(&figures);
    manifest.write(results)?;
    beginning.checkpoints.map_or(Ok(()), Checkpoints::remove)?;
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
    let mut progress = Progress::new(steps, stop, quiet);
    let reached = setup.begin(beginning.state.take(), &mut recorder, &mut progress)?;
    let notes = setup.manifest.run.iter().flat_map(|run| &run.notes);
    beginning.notes.iter().chain(notes).for_each(|note| progress.tell(note));

    let timer = Timer::after(setup.system.times.run);
    let checkpoints = beginning.checkpoints.as_mut();
    let (recorded, shown) = (&mut recorder, &mut progress);
    let mut stepping =
        Stepping { setup, recorder: recorded, progress: shown, live: &live, checkpoints, timer };
    let first = match reached {
        Reached::Run(done) => done,
        Reached::After(..) => steps,
    };
    let mut outcome = stepping.run(first..steps);
    if let Reached::Run(_) = reached {
        setup.system.times.run = stepping.timer.elapsed();
    }
    if outcome.is_ok() {
        let Setup { system, rails, .. } = &mut *setup;
        let timer = Timer::after(system.times.after);
        let checkpoints = beginning.checkpoints.as_mut();
        let (recorder, progress) = (&mut recorder, &mut progress);
        let mut run = Continued { system, recorder, progress, checkpoints, timer };
        outcome = rails.continue_after_run(&mut run, rails_run, reached);
        run.system.times.after = run.timer.elapsed();
    }
    progress.finish();

    let Setup { system, stages, manifest, .. } = setup;
    if let Some(run) = &mut manifest.run {
        run.energy = recorder.energy("train");
    }
    recorder.finish()?;
    let end = terminate(system.units_mut());
    manifest.warnings.extend(take_warnings(system.units_mut()));
    if let Some(run) = &mut manifest.run {
        run.warnings.clone_from(&manifest.warnings);
    }
    let until = outcome.as_ref().map_or_else(|failed| failed.time, |()| rails_end);
    let simulated = until.min(clock.at(steps)) - clock.start;
    manifest.finish(simulated, system, stages);
    manifest.write(results)?;
    outcome.map_err(|failed| RunError::step(failed, results))?;
    end.map_err(RunError::End)?;
    let wall = system.times.run;
    Ok(Done { simulated, rails: rails_end - clock.start, wall, steps })
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
    /// Takes all units through these steps of the run.
    fn run(&mut self, steps: Range<u64>) -> Result<(), FailedStep> {
        for k in steps {
            let time = self.setup.system.clock.at(k);
            self.step(k).map_err(|source| FailedStep { time, source })?;
        }
        Ok(())
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
        if let Some(checkpoints) = self.checkpoints.as_mut().filter(|c| c.is_due(end)) {
            system.times.run = self.timer.elapsed();
            let reached = (Reached::Run(k + 1), end);
            checkpoints.write(reached, rails.save()?, system, self.recorder)?;
        }
        Ok(())
    }
}
