//! A run from the scenario's file to the results folder.

pub mod error;
pub mod expected;
mod finished;
pub mod manifest;
pub mod observe;
mod observe_outputs;
pub mod observe_rail;
pub mod progress;
pub mod stepping;
pub mod workplace;

use std::path::{Path, PathBuf};
use std::time::Instant;

use crate::report::{self, MainFigure};
use crate::run::error::RunError;
use crate::run::finished::{Done, Finished};
use crate::run::manifest::Manifest;
use crate::run::observe::Recorder;
use crate::run::progress::Progress;
use crate::run::stepping::Stepping;
use crate::run::workplace::Workplace;
use crate::scenario::{self, Scenario, Times};
use crate::system::unit::{take_warnings, terminate};
use crate::train::foresee::wheels_outside;
use crate::train::lockstep::Lockstep;
use crate::train::prepare::{Folders, prepare};
use crate::train::prepare_rail::Extent;
use crate::train::start::{StartError, start_of};
use crate::train::traffic::Traffic;

/// How a scenario is run.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Threads for the vehicles; none: all cores.
    pub threads: Option<usize>,
    /// Folder of the results; none: a new one in `results`.
    pub results: Option<PathBuf>,
    /// Folder of Hotfoot's own FMUs.
    pub fmus: PathBuf,
    /// Times in place of the scenario's.
    pub times: Times,
    /// No progress bar.
    pub quiet: bool,
}

/// Runs a scenario.
///
/// # Errors
/// When the scenario is wrong or a unit fails.
pub fn run(path: &Path, options: &Options) -> Result<Finished, RunError> {
    let (mut scenario, file, text) = scenario::load(path)?;
    for (option, value) in options.times.stated() {
        RunError::check_time(option, value)?;
    }
    options.times.replace_in(&mut scenario, &file)?;
    let Workplace { threads, pool, results } =
        Workplace::open(options.threads, options.results.as_deref(), &file)?;
    let folders = Folders { fmus: options.fmus.clone(), results };

    let mut lockstep = prepare(&scenario, &folders).map_err(RunError::prepare(&file))?;
    let mut manifest = Manifest::new(&scenario, text, threads, &lockstep);
    pool.install(|| {
        run_prepared(&scenario, &mut lockstep, &mut manifest, &folders.results, options.quiet)
    })
    .and_then(|done| {
        let (report, figures) = report::write(&folders.results)?;
        manifest.figure.clone_from(&figures);
        manifest.write(&folders.results)?;
        Ok(Finished {
            figures: figures.into_iter().filter(MainFigure::is_shown).collect(),
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
    let traffic = scenario.heat.as_ref().map(Traffic::of).unwrap_or_default();
    let rails_run = lockstep.rails_time(steps);
    let rails_end = traffic.end(rails_run);
    manifest.write(results)?;
    lockstep
        .initialize(start_of(scenario), scenario.duration_s, rails_end)
        .map_err(StartError::from)?;
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
    let end = terminate(lockstep.units_mut());
    manifest.run.warnings = take_warnings(lockstep.units_mut());
    let reached = outcome.as_ref().map_or_else(|failed| failed.time, |()| rails_end);
    let simulated = reached.min(lockstep.clock.at(steps));
    manifest.finish(simulated, wall, &lockstep.times);
    manifest.write(results)?;
    outcome.map_err(|failed| RunError::step(failed, results))?;
    end.map_err(RunError::End)?;
    Ok(Done { simulated, rails: rails_end, wall, steps })
}
