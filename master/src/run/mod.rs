//! A run from a scenario's file or a package to the results folder: one way for both.
//!
//! | file | part |
//! |---|---|
//! | `mod.rs` | the run |
//! | `options.rs`, `setup.rs`, `scenario.rs`, `package.rs`, `source.rs` | what is run, and how |
//! | `perform.rs`, `stepping.rs` | its course, and its steps |
//! | `recorder.rs`, `step_table.rs`, `output_table.rs`, `train_tables.rs`, `outputs.rs`, `chosen_outputs.rs`, `observe_error.rs` | what is recorded |
//! | `after.rs` | what the rails go through after the run |
//! | `checkpoint` | from where a run can go on |
//! | `begun.rs`, `manifest.rs`, `finished.rs` | what made the results, and what is told of them |
//! | `expected.rs` | the figures of a run against those expected |
//! | `progress.rs`, `live.rs` | the progress bar |
//! | `stop.rs` | whether the run is to stop before its end |
//! | `export.rs`, `sources.rs` | a scenario's train as a package |
//! | `check_until_start.rs` | a run up to its first step |
//! | `wiring.rs` | what would be run, without running it |
//! | `folder/` | the folder of a run: claimed, and completed after any end |
//! | `open_system/` | a system that the caller steps |
//! | `workplace.rs`, `error.rs` | threads and name of a run, and why it failed |

mod after;
mod begun;
mod check_until_start;
mod checkpoint;
mod chosen_outputs;
pub mod error;
pub mod expected;
mod export;
mod finished;
pub mod folder;
mod live;
mod manifest;
mod observe_error;
pub mod open_system;
mod options;
mod output_table;
mod outputs;
pub mod package;
mod perform;
mod progress;
mod recorder;
pub mod scenario;
mod setup;
mod source;
mod sources;
mod step_table;
mod stepping;
mod stop;
mod train_tables;
mod wiring;
pub mod workplace;

#[cfg(test)]
mod after_tests;

use std::path::{Path, PathBuf};

pub use check_until_start::check_until_start;
use checkpoint::{Beginning, CheckpointError, Checkpoints, Order, Subject};
use error::RunError;
pub use export::{Exported, export};
pub use finished::Finished;
use manifest::Manifest;
pub use manifest::{End, Ended};
pub use options::Options;
use perform::perform;
use setup::Setup;
pub use source::is_system;
pub use stop::{PARENT_GONE, Stopped, signal_name};
pub use wiring::wiring;
use workplace::Workplace;

use crate::report::{self, MainFigure};
use crate::scenario::{Scenario, Times};
use crate::system::substitute::Substitutes;
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
    if is_system(path) {
        RunError::check_no_settings(&options.settings)?;
        let workplace = Workplace::open(options.threads)?;
        // With one thread all that an FMU sees, from loading to freeing, happens on it.
        return workplace.pool.install(|| {
            let beginning = begin(&Order::new(subject, options, results, source::inputs(path)?)?)?;
            let none = &mut Substitutes::new();
            let setup = package::setup((path, written), results, options, workplace.threads, none)?;
            in_workplace(setup, &workplace, results, options.quiet, beginning)
        });
    }
    let (scenario, file, text) = ordered(path, options)?;
    let workplace = Workplace::open(options.threads)?;
    let folders = Folders { fmus: options.fmus.clone(), results: results.to_owned() };
    workplace.pool.install(|| {
        let inputs = [vec![file.clone()], scenario.inputs(), folders.own_fmus()].concat();
        let times = Times { checkpoint: scenario.record.checkpoint_s, ..options.times };
        let ordered = Options { times, ..options.clone() };
        let beginning = begin(&Order::new(subject, &ordered, results, inputs)?)?;
        let none = &mut Substitutes::new();
        let setup = scenario::setup(scenario, (&file, text), &folders, workplace.threads, none)?;
        in_workplace(setup, &workplace, results, options.quiet, beginning)
    })
}

/// The scenario at a path as the options want it, its file and its text.
fn ordered(path: &Path, options: &Options) -> Result<(Scenario, PathBuf, String), RunError> {
    let (mut scenario, file, text) = crate::scenario::load(path, &options.settings)?;
    for (option, value) in options.times.stated() {
        RunError::check_time(option, value)?;
    }
    options.times.replace_in(&mut scenario, &file)?;
    scenario.fmus.tolerance = options.tolerance.or(scenario.fmus.tolerance);
    scenario.checks = options.checks.or(scenario.checks);
    scenario.fmus.same_thread |= options.same_thread;
    scenario.fmus.isolated.clone_from(&options.isolate);
    Ok((scenario, file, text))
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
        caution: manifest.run.and_then(|run| run.rails?.caution()),
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
