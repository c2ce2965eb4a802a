//! The run of an SSP package.

use std::path::Path;

use super::after::Rails;
use super::error::RunError;
use super::manifest::{Manifest, component_facts};
use super::output_table::renamed;
use super::setup::{Setup, Subject};
use crate::files::archive;
use crate::report::SystemFacts;
use crate::scenario::Times;
use crate::ssp::{self, SspError};
use crate::system::clock::Clock;
use crate::system::step::System;
use crate::system::structure::Structure;

/// Step where neither the package nor the user names one, s.
const DEFAULT_STEP: f64 = 1e-3;
/// Simulated time where neither the package nor the user names one, s.
const DEFAULT_DURATION: f64 = 1.0;
/// Time between two records where the user names none, s.
const DEFAULT_INTERVAL: f64 = 0.1;

/// Sets the package at a path, which the user has written so, up to be run.
///
/// It is run with so many threads in the folder `results`, where its FMUs stay beside the results that they
/// make.
///
/// # Errors
/// When the package is wrong or does not fit its FMUs.
pub fn setup(
    (path, written): (&Path, &str),
    results: &Path,
    times: &Times,
    threads: usize,
) -> Result<Setup, RunError> {
    let package = results.join("package");
    archive::unpack(path, &package).map_err(SspError::from)?;
    let structure = ssp::read(&package)?;
    let (clock, steps, every) = times_of(&structure, times)?;
    let file = written.to_owned();
    let system = ssp::open(&structure, &package, &file, clock)?;
    let mut manifest = Manifest::new(&system);
    manifest.warnings = renamed(&system);
    manifest.system = Some(SystemFacts {
        name: structure.name.clone(),
        package: file,
        simulated_s: 0.0,
        step_s: clock.length,
        threads,
        wall_time_s: None,
        recording_s: 0.0,
        component: component_facts(&system),
    });
    let stages = stage_names(&structure, &system);
    let (stop, subject) = (clock.at(steps), Subject::Package(every));
    Ok(Setup { system, stages, steps, stop, subject, rails: Rails::default(), manifest })
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
