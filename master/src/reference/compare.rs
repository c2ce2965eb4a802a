//! A run against the reference result.

use std::path::Path;

use super::files::Reference;
use super::{ReferenceError, run};
use crate::fmi::Import;

/// Runs an FMU again and compares it with the result that it carries.
///
/// Gives a sentence for each signal that differs by more than the tolerance, and else how much
/// the worst signal differs.
///
/// # Errors
/// When the FMU has no reference result, or fails.
pub fn compare(fmu: &Path) -> Result<Result<String, Vec<String>>, ReferenceError> {
    let reference = Reference::of(fmu)?;
    let import = Import::open(fmu)?;
    let now = run::run(&import, &reference.experiment, &reference.inputs)?;
    if now.times.len() != reference.result.times.len() {
        let problem = format!(
            "the run gives {} rows, the reference result has {}",
            now.times.len(),
            reference.result.times.len()
        );
        return Err(ReferenceError::content(fmu, problem));
    }
    let tolerance = reference.experiment.relative_tolerance;
    let mut worst = 0.0_f64;
    let mut problems = vec![];
    for (signal, name) in now.names.iter().enumerate() {
        let pairs = || now.rows.iter().zip(&reference.result.rows);
        let scale = pairs().map(|(_, then)| then[signal].abs()).fold(0.0, f64::max);
        let (difference, row) = pairs()
            .enumerate()
            .map(|(row, (now, then))| ((now[signal] - then[signal]).abs(), row))
            .fold(
                (0.0, 0),
                |worst, own| if own.0 > worst.0 || own.0.is_nan() { own } else { worst },
            );
        // A signal that rests at zero has no scale; it must rest at zero again.
        let relative = if difference == 0.0 { 0.0 } else { difference / scale };
        if relative <= tolerance {
            worst = worst.max(relative);
            continue;
        }
        problems.push(format!(
            "`{name}` is {} at {} s, but was {} when the FMU was made: a difference of {relative:.1e} \
             of its largest value, where {tolerance:.1e} is allowed",
            now.rows[row][signal], now.times[row], reference.result.rows[row][signal]
        ));
    }
    let rows = now.times.len();
    Ok(match problems.is_empty() {
        true => Ok(format!(
            "{} signals over {} s ({rows} rows) are those of the reference result; the largest \
             difference is {worst:.1e}",
            now.names.len(),
            reference.experiment.stop_time_s
        )),
        false => Err(problems),
    })
}
