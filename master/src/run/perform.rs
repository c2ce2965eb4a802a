//! The course of a run that is set up: it starts, steps, and is completed.
//!
//! Whatever happens, what was computed is whole on disk. A run goes through all of it at once; an open system is
//! taken through it by its caller.

use std::path::Path;

use super::after::{Continued, FailedStep, Stop};
use super::checkpoint::{Beginning, Checkpoints, Reached};
use super::error::RunError;
use super::finished::Done;
use super::folder;
use super::live::LiveFigures;
use super::manifest::{End, Ended};
use super::progress::Progress;
use super::recorder::Recorder;
use super::setup::Setup;
use super::stepping::Stepping;
use super::stop::{Early, stopped};
use crate::system::times::Timer;
use crate::system::unit::terminate;

/// Initialises, steps, records and completes.
///
/// # Errors
/// When a unit fails or nothing can be written.
pub fn perform(
    setup: &mut Setup,
    results: &Path,
    quiet: bool,
    beginning: &mut Beginning,
) -> Result<Done, RunError> {
    let mut started = start(setup, results, quiet, beginning)?;
    let notes = setup.manifest.run.iter().flat_map(|run| &run.notes);
    beginning.notes.iter().chain(notes).for_each(|note| started.progress.tell(note));
    let outcome = step_through(setup, &mut started, beginning.checkpoints.as_mut());
    started.progress.finish();
    complete(setup, results, started.recorder, outcome)
}

/// A run whose units are initialised.
pub struct Started {
    /// Records it.
    pub recorder: Recorder,
    progress: Progress,
    live: LiveFigures,
    /// Where it goes on.
    reached: Reached,
}

impl Started {
    /// A run that tells and records nothing.
    pub fn unrecorded(setup: &Setup) -> Self {
        Self {
            recorder: Recorder::default(),
            progress: Progress::new(setup.steps, setup.stop, true),
            live: LiveFigures::default(),
            reached: Reached::Run(0),
        }
    }

    /// Takes all units on from the `done` steps, which it counts, to so many.
    ///
    /// It says if somebody wants the run to end before.
    ///
    /// # Errors
    /// When a unit fails or nothing can be written.
    pub fn step(
        &mut self,
        setup: &mut Setup,
        (done, until): (&mut u64, u64),
        checkpoints: Option<&mut Checkpoints>,
    ) -> Result<Option<Early>, FailedStep> {
        let Self { recorder, progress, live, .. } = self;
        let timer = Timer::after(setup.system.times.run);
        let mut stepping = Stepping { setup, recorder, progress, live, checkpoints, timer };
        let early = stepping.run(done, until);
        stepping.setup.system.times.run = stepping.timer.elapsed();
        early
    }

    /// Takes the rails through what follows the run, until `stop` wants it to end.
    ///
    /// # Errors
    /// When a rail fails or nothing can be written.
    pub fn continue_rails(
        &mut self,
        setup: &mut Setup,
        checkpoints: Option<&mut Checkpoints>,
        stop: &mut Stop<'_>,
    ) -> Result<Option<Early>, FailedStep> {
        let rails_run = setup.rails_run();
        let Setup { system, rails, .. } = setup;
        let Self { recorder, progress, reached, .. } = self;
        let timer = Timer::after(system.times.after);
        let mut run = Continued { system, recorder, progress, checkpoints, timer, stop };
        let stopped = rails.continue_after_run(&mut run, rails_run, *reached);
        run.system.times.after = run.timer.elapsed();
        Ok(stopped?.map(Early::Stopped))
    }
}

/// Initialises the units and begins to record, or goes on where the run before has ended.
///
/// # Errors
/// When a unit refuses or nothing can be written.
pub fn start(
    setup: &mut Setup,
    results: &Path,
    quiet: bool,
    beginning: &mut Beginning,
) -> Result<Started, RunError> {
    let (steps, stop) = (setup.steps, setup.stop);
    setup.check_states(beginning)?;
    setup.manifest.write(results)?;
    setup.initialize()?;
    let mut recorder = setup.recorder(&results.join("series"))?;
    let live = setup.live_figures();
    setup.describe()?;
    // From now on a run that is killed can be reported.
    setup.manifest.write(results)?;
    let mut progress = Progress::new(steps, stop, quiet);
    let reached = setup.begin(beginning.state.take(), &mut recorder, &mut progress)?;
    Ok(Started { recorder, progress, live, reached })
}

/// Takes all units through the run, and the rails through what follows it, until somebody wants it to end.
fn step_through(
    setup: &mut Setup,
    started: &mut Started,
    mut checkpoints: Option<&mut Checkpoints>,
) -> Result<Option<Early>, FailedStep> {
    if let Reached::Run(mut done) = started.reached {
        let steps = (&mut done, setup.steps);
        if let Some(early) = started.step(setup, steps, checkpoints.as_deref_mut())? {
            return Ok(Some(early));
        }
    }
    started.continue_rails(setup, checkpoints, &mut stopped)
}

/// Completes the tables, terminates the units, and writes into the manifest how the run has ended.
///
/// # Errors
/// Those of the outcome, and when nothing can be written.
pub fn complete(
    setup: &mut Setup,
    results: &Path,
    recorder: Recorder,
    outcome: Result<Option<Early>, FailedStep>,
) -> Result<Done, RunError> {
    let (steps, rails_end) = (setup.steps, setup.rails_end());
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
    let terminated = terminate(system.units_mut()).map_err(RunError::End);
    manifest.warnings.extend(system.take_warnings());
    if let Ok(Some(wish @ Early::Wished(_))) = &outcome {
        manifest.warnings.push(wish.to_string());
    }
    if let Some(run) = &mut manifest.run {
        run.warnings.clone_from(&manifest.warnings);
    }
    let clock = system.clock;
    let reached = match &outcome {
        Ok(None) => rails_end,
        Ok(Some(early)) => early.time(),
        Err(failed) => failed.time,
    };
    let simulated = reached.min(clock.at(steps)) - clock.start;
    manifest.finish(system, stages);
    let outcome = outcome.map_err(|failed| RunError::step(failed, results));
    let outcome = outcome.and_then(|early| recorded.and(terminated).map(|()| early));
    manifest.end(simulated, ended(&outcome));
    let written = manifest.write(results);
    let stopped = match outcome? {
        Some(Early::Stopped(stopped)) => Some(stopped),
        Some(Early::Wished(_) | Early::Left { .. }) | None => None,
    };
    written?;
    let steps = ((simulated / clock.length).round() as u64).max(1);
    let (rails, wall) = (reached - clock.start, system.times.run);
    Ok(Done { simulated, rails, wall, steps, stopped })
}

/// How a run has ended, for its manifest.
fn ended(outcome: &Result<Option<Early>, RunError>) -> Ended {
    match outcome {
        Ok(None) => Ended { end: End::Complete, end_reason: None },
        Ok(Some(wish @ Early::Wished(_))) => Ended::because(End::Complete, wish.to_string()),
        Ok(Some(stop @ (Early::Stopped(_) | Early::Left { .. }))) => {
            Ended::because(End::Interrupted, stop.to_string())
        }
        Err(error) => Ended::because(End::Failed, error.to_string()),
    }
}
