//! A run against the reference result.

use std::fmt;
use std::path::Path;

use super::files::Reference;
use super::table::Table;
use super::{ReferenceError, run};
use crate::fmi::Import;

/// What became of a comparison.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// All signals agree.
    Same(Agreement),
    /// A sentence for each signal that differs by more than the tolerance.
    Different(Vec<String>),
}

/// How well a run agrees with the result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Agreement {
    signals: usize,
    rows: usize,
    stop_time: f64,
    /// Largest difference, in parts of the largest magnitude of its signal.
    worst: f64,
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { signals, rows, stop_time, worst } = self;
        write!(
            f,
            "{signals} signals over {stop_time} s ({rows} rows) are those of the reference result; \
             the largest difference is {worst:.1e}"
        )
    }
}

/// Runs an FMU again and compares it with the result that it carries.
///
/// # Errors
/// When the FMU has no reference result, or fails.
pub fn compare(fmu: &Path) -> Result<Verdict, ReferenceError> {
    let reference = Reference::of(fmu)?;
    let import = Import::open(fmu)?;
    let now = run::run(&import, &reference.experiment, &reference.inputs)?;
    let (rows, wanted) = (now.times.len(), reference.result.times.len());
    if rows != wanted {
        let problem = format!("the run gives {rows} rows, the reference result has {wanted}");
        return Err(ReferenceError::content(fmu, problem));
    }
    let tolerance = reference.experiment.relative_tolerance;
    let mut worst = 0.0_f64;
    let mut problems = vec![];
    for (signal, name) in now.names.iter().enumerate() {
        let (difference, row) = largest_difference(&now, &reference.result, signal);
        if difference <= tolerance {
            worst = worst.max(difference);
            continue;
        }
        problems.push(format!(
            "`{name}` is {} at {} s, but was {} when the FMU was made: a difference of \
             {difference:.1e} of its largest value, where {tolerance:.1e} is allowed",
            now.rows[row][signal], now.times[row], reference.result.rows[row][signal]
        ));
    }
    let (signals, stop_time) = (now.names.len(), reference.experiment.stop_time_s);
    Ok(match problems.is_empty() {
        true => Verdict::Same(Agreement { signals, rows, stop_time, worst }),
        false => Verdict::Different(problems),
    })
}

/// The largest difference of a signal, in parts of its largest magnitude, and its row. What is not
/// a number differs from everything.
fn largest_difference(now: &Table, then: &Table, signal: usize) -> (f64, usize) {
    let pairs = || now.rows.iter().zip(&then.rows).map(|(now, then)| (now[signal], then[signal]));
    let scale = pairs().map(|(_, then)| then.abs()).fold(0.0, f64::max);
    let relative = |(now, then): (f64, f64)| match now == then {
        // A signal that rests at zero has no scale.
        true => 0.0,
        false => (now - then).abs() / scale,
    };
    let larger = |largest: (f64, usize), own: (f64, usize)| match own.0 <= largest.0 {
        true => largest,
        false => own,
    };
    pairs().map(relative).zip(0..).fold((0.0, 0), larger)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(values: &[f64]) -> Table {
        Table {
            names: vec!["signal".to_owned()],
            times: (0..values.len()).map(|row| row as f64).collect(),
            rows: values.iter().map(|value| vec![*value]).collect(),
        }
    }

    fn largest(now: &[f64], then: &[f64]) -> (f64, usize) {
        largest_difference(&table(now), &table(then), 0)
    }

    #[test]
    fn differences_are_parts_of_the_largest_value() {
        assert_eq!(largest(&[0.0, 1.0, -4.0], &[0.0, 1.0, -4.0]), (0.0, 0));
        assert_eq!(largest(&[0.0, 1.5, -4.0], &[0.0, 1.0, -4.0]), (0.125, 1));
        assert_eq!(largest(&[0.0, 0.0], &[0.0, 0.0]), (0.0, 0), "a signal at rest");
        assert_eq!(largest(&[0.0, 1e-30], &[0.0, 0.0]), (f64::INFINITY, 1));
    }

    #[test]
    fn what_is_no_number_differs() {
        let (difference, row) = largest(&[0.0, f64::NAN], &[0.0, 1.0]);
        assert!(difference.is_nan() && row == 1);
    }
}
