//! The run of a system of FMUs without a scenario.

use std::path::Path;

use super::after::Rails;
use super::chosen_outputs::{ChosenOutputs, numbers};
use super::error::RunError;
use super::manifest::{Manifest, component_facts};
use super::observe_error::ObserveError;
use super::options::Options;
use super::output_table::{renamed, same_tables};
use super::setup::{Setup, Subject};
use super::source;
use crate::report::SystemFacts;
use crate::scenario::Times;
use crate::ssp::{self, SspError};
use crate::system::clock::Clock;
use crate::system::step::System;
use crate::system::structure::Structure;
use crate::system::substitute::Substitutes;
use crate::system::unit::Unit;

/// Step where neither the package nor the user names one, s.
const DEFAULT_STEP: f64 = 1e-3;
/// Simulated time where neither the package nor the user names one, s.
const DEFAULT_DURATION: f64 = 1.0;
/// Time between two records where the user names none, s.
const DEFAULT_INTERVAL: f64 = 0.1;

/// Sets the system at a path, which the user has written so, up to be run.
///
/// It is run with so many threads in the folder `results`, where the FMUs of a package stay beside the
/// results that they make.
///
/// # Errors
/// When the package is wrong or does not fit its FMUs.
pub(crate) fn setup(
    (path, written): (&Path, &str),
    results: &Path,
    options: &Options,
    threads: usize,
    substitutes: &mut Substitutes,
) -> Result<Setup, RunError> {
    let (folder, mut structure) = source::read(path, &results.join("package"))?;
    for component in &mut structure.components {
        component.schedule.home = component.schedule.home.max(options.home());
    }
    let file = written.to_owned();
    let imports = ssp::imports(&structure, &folder, &file)?;
    ssp::settle(&mut structure, &imports, &options.isolate, &file)?;
    ssp::leave_out_unmatched(&mut structure, &imports);
    structure.tolerance = options.tolerance;
    if let ([component], None) = (structure.components.as_slice(), structure.stop) {
        let proposed = imports[&component.source].interface().experiment;
        structure.start = structure.start.or(proposed.start);
        structure.stop = proposed.stop.filter(|stop| *stop > structure.start.unwrap_or(0.0));
        structure.step = structure.step.or(proposed.step);
    }
    let (clock, steps, every) = times_of(&structure, &options.times)?;
    let mut system = ssp::open(&structure, &imports, &file, clock, substitutes)?;
    system.set_checks(options.checks.unwrap_or_default());
    let chosen = ChosenOutputs::new(&options.record, &structure.given, &system);
    let chosen = chosen.map_err(ObserveError::from)?;
    let problems = same_tables(&system, &chosen);
    if !problems.is_empty() {
        return Err(SspError::Unfit { file, problems }.into());
    }
    let mut manifest = Manifest::new(&system);
    manifest.warnings.clone_from(&structure.notes);
    manifest.warnings.extend(renamed(&system, &chosen));
    manifest.warnings.extend(without_outputs(&system));
    manifest.system = Some(SystemFacts {
        name: structure.name.clone(),
        package: file,
        simulated_s: 0.0,
        step_s: clock.length,
        threads,
        wall_time_s: None,
        recording_s: 0.0,
        component: component_facts(&system, &chosen),
    });
    let stages = stage_names(&structure, &system);
    let (stop, subject) = (clock.at(steps), Subject::Package(every, chosen));
    let rails = Rails::default();
    Ok(Setup { system, stages, steps, stop, subject, rails, manifest, recorded: false })
}

/// Says of which components nothing is recorded.
fn without_outputs(system: &System) -> Vec<String> {
    let silent = system.units().filter(|unit| numbers(*unit, &|_| true).is_empty());
    let sentence = |unit: &dyn Unit| {
        let (name, file) = (unit.name(), unit.source_file());
        format!("{name} ({file}) has no outputs that are numbers: nothing of it is recorded")
    };
    silent.map(sentence).collect()
}

/// The communication points, the number of steps, and how many there are a record: what the user says,
/// else what the package says.
fn times_of(structure: &Structure, times: &Times) -> Result<(Clock, u64, u64), RunError> {
    let start = structure.start.unwrap_or(0.0);
    let length = times.step.or(structure.step).unwrap_or(DEFAULT_STEP);
    let in_package = structure.stop.map(|stop| stop - start);
    let duration = times.duration.or(in_package).unwrap_or(DEFAULT_DURATION);
    let interval = times.interval.unwrap_or(DEFAULT_INTERVAL.max(length));
    RunError::check_time("--step", length)?;
    RunError::check_time("--duration", duration)?;
    RunError::check_time("--interval", interval)?;
    let steps = |time: f64| ((time / length).round() as u64).max(1);
    Ok((Clock { start, length }, steps(duration), steps(interval)))
}

/// What the stages are called: a single one is all components.
fn stage_names(structure: &Structure, system: &System) -> Vec<String> {
    match system.times.stages.len() {
        _ if !structure.stages.is_empty() => structure.stages.clone(),
        1 => vec!["components".to_owned()],
        count => (1..=count).map(|number| format!("stage {number}")).collect(),
    }
}
