//! A run against the reference result.

use std::fmt;
use std::path::Path;

use numerics::seconds;

use super::files::Reference;
use super::table::{Signal, Table};
use super::{ReferenceError, run};
use crate::fmi::Import;
use crate::system::structure::Value;

/// What became of a comparison.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// All signals agree.
    Same(Agreement),
    /// A sentence for each signal that differs by more than the tolerance.
    Different(Vec<String>),
}

/// How well a run agrees with the result.
#[derive(Debug, Clone, PartialEq)]
pub struct Agreement {
    signals: usize,
    rows: usize,
    stop_time: f64,
    /// Largest difference, in parts of the largest magnitude of its signal.
    worst: f64,
    /// Signals of the result that the FMU does not have.
    left_out: Vec<String>,
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { signals, rows, stop_time, worst, left_out } = self;
        write!(
            f,
            "{signals} signals over {} s ({rows} rows) are those of the reference result; \
             the largest difference is {worst:.1e}",
            seconds(*stop_time)
        )?;
        match left_out.is_empty() {
            true => Ok(()),
            false => write!(
                f,
                "\nnot compared, as the FMU has no such variables: {}",
                left_out.join(", ")
            ),
        }
    }
}

/// Runs an FMU again and compares it with the result that it carries.
///
/// # Errors
/// When the FMU has no reference result, or fails.
pub fn compare(fmu: &Path) -> Result<Verdict, ReferenceError> {
    let Reference { experiment, inputs, result, left_out } = Reference::of(fmu)?;
    let import = Import::open(fmu)?;
    let now = run::run(&import, &experiment, &inputs)?;
    let mut problems: Vec<String> = wrong_times(&now, &result).into_iter().collect();
    let tolerance = experiment.relative_tolerance;
    let mut worst = 0.0_f64;
    for (signal, Signal { name, .. }) in now.signals.iter().enumerate() {
        let (difference, row) = largest_difference(&now, &result, signal);
        if difference <= tolerance {
            worst = worst.max(difference);
            continue;
        }
        let (own, then) = (&now.rows[row][signal], &result.rows[row][signal]);
        let by = match own {
            Value::Real(_) => format!(
                ": a difference of {difference:.1e} of its largest value, where {tolerance:.1e} is \
                 allowed"
            ),
            _ => String::new(),
        };
        problems.push(format!(
            "`{name}` is {own} at {} s, but was {then} when the FMU was made{by}",
            seconds(now.times[row])
        ));
    }
    let (signals, rows) = (now.signals.len(), now.times.len());
    let stop_time = now.times.last().map_or(0.0, |last| last.min(experiment.stop_time_s));
    Ok(match problems.is_empty() {
        true => Verdict::Same(Agreement { signals, rows, stop_time, worst, left_out }),
        false => Verdict::Different(problems),
    })
}

/// Says that a run has other rows than the result.
fn wrong_times(now: &Table, then: &Table) -> Option<String> {
    let same = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME_TIME * b.abs().max(1.0);
    let common = now.times.iter().zip(&then.times).take_while(|(a, b)| same((a, b))).count();
    let at = |times: &[f64]| match times.get(common) {
        Some(time) => format!("goes on at {} s", seconds(*time)),
        None => format!("ends at {} s", times.last().copied().map_or(0.0, seconds)),
    };
    (common < now.times.len().max(then.times.len())).then(|| {
        format!(
            "after {common} rows the run {}, but the reference result {}",
            at(&now.times),
            at(&then.times)
        )
    })
}

/// Difference of two times that count as the same, in parts of the time or of 1 s.
const SAME_TIME: f64 = 1e-6;

/// The largest difference of a signal, in parts of its largest magnitude, and its row. What is not
/// a number differs from everything, and what is no Real by all or nothing.
fn largest_difference(now: &Table, then: &Table, signal: usize) -> (f64, usize) {
    let pairs = || now.rows.iter().zip(&then.rows).map(|(now, then)| (&now[signal], &then[signal]));
    let magnitude = |value: &Value| if let Value::Real(value) = value { value.abs() } else { 0.0 };
    let scale = pairs().map(|(_, then)| magnitude(then)).fold(0.0, f64::max);
    let relative = |pair: (&Value, &Value)| match pair {
        // A signal that rests at zero has no scale.
        (now, then) if now == then => 0.0,
        (Value::Real(now), Value::Real(then)) => (now - then).abs() / scale,
        _ => f64::INFINITY,
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

    fn table(values: Vec<Value>) -> Table {
        Table {
            signals: vec![],
            times: (0..values.len()).map(|row| row as f64).collect(),
            rows: values.into_iter().map(|value| vec![value]).collect(),
        }
    }

    fn largest(now: &[f64], then: &[f64]) -> (f64, usize) {
        let reals = |values: &[f64]| table(values.iter().copied().map(Value::Real).collect());
        largest_difference(&reals(now), &reals(then), 0)
    }

    #[test]
    fn what_is_no_real_is_the_same_or_not() {
        let text = |text: &str| Value::Text(text.to_owned());
        for (a, b) in [
            (text("a"), text("b")),
            (Value::Integer(1), Value::Integer(2)),
            (Value::Boolean(true), Value::Boolean(false)),
        ] {
            let (now, then) = (table(vec![a.clone(), b]), table(vec![a.clone(), a]));
            assert_eq!(largest_difference(&now, &now, 0), (0.0, 0));
            assert_eq!(largest_difference(&now, &then, 0), (f64::INFINITY, 1));
        }
    }

    #[test]
    fn a_run_that_ends_at_another_time_is_another_run() {
        let ended = |rows| table(vec![Value::Real(1.0); rows]);
        assert_eq!(wrong_times(&ended(3), &ended(3)), None);
        let sentence = wrong_times(&ended(3), &ended(2)).unwrap();
        assert_eq!(
            sentence,
            "after 2 rows the run goes on at 2 s, but the reference result ends at 1 s"
        );
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
