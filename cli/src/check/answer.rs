//! What a check prints: sentences, or JSON for scripts.

use std::fmt;
use std::path::Path;

use anyhow::{Error, Result};
use files::Mistake;
use hotfoot::RunError;
use serde::Serialize;

use crate::output::{Reported, is_closed_pipe, message, print, print_json, tell};

/// How the answer to a check is given.
pub(super) struct Answer<'a> {
    of: &'a Path,
    json: bool,
    quiet: bool,
}

/// What is wrong with an FMU.
#[derive(Debug)]
pub(super) struct Problems {
    /// The FMU.
    pub of: String,
    /// What is right nevertheless, and advice.
    pub right: Vec<String>,
    /// What is wrong.
    pub problems: Vec<String>,
}

impl fmt::Display for Problems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:\n{}", self.of, self.problems.join("\n"))
    }
}

impl std::error::Error for Problems {}

/// The answer for scripts.
#[derive(Serialize)]
struct Report<'a> {
    /// What was checked.
    checked: String,
    /// Whether nothing is wrong.
    ok: bool,
    /// What is right, advice and notes.
    notes: &'a [String],
    problems: Vec<Problem>,
}

/// Something wrong, with its place in a file where it is known.
#[derive(Serialize)]
struct Problem {
    message: String,
    file: Option<String>,
    line: Option<usize>,
    column: Option<usize>,
}

impl<'a> Answer<'a> {
    pub(super) fn new(of: &'a Path, json: bool, quiet: bool) -> Self {
        Self { of, json, quiet }
    }

    /// Prints what was found, in sentences.
    ///
    /// # Errors
    /// What is wrong, which is told already.
    pub(super) fn of(&self, found: Result<Vec<String>>) -> Result<()> {
        let error = match found {
            Ok(notes) if self.json => return self.print(&notes, vec![]),
            Ok(_) if self.quiet => return Ok(()),
            Ok(notes) => return notes.iter().try_for_each(print),
            Err(error) if error.is::<Reported>() || is_closed_pipe(&error) => return Err(error),
            Err(error) => error,
        };
        let found = error.downcast_ref::<Problems>();
        let notes = found.map_or(&[] as &[String], |found| found.right.as_slice());
        if self.json {
            let problems = found.map_or_else(
                || vec![problem(&error)],
                |found| found.problems.iter().cloned().map(without_position).collect(),
            );
            self.print(notes, problems)?;
        } else {
            if !self.quiet {
                notes.iter().try_for_each(print)?;
            }
            tell(format_args!("Error: {}", message(&error)));
        }
        Err(Reported.into())
    }

    fn print(&self, notes: &[String], problems: Vec<Problem>) -> Result<()> {
        let (checked, ok) = (self.of.display().to_string(), problems.is_empty());
        print_json(&Report { checked, ok, notes, problems })
    }
}

fn without_position(message: String) -> Problem {
    Problem { message, file: None, line: None, column: None }
}

/// An error with the place of a mistake.
fn problem(error: &Error) -> Problem {
    let of_run = error.downcast_ref::<RunError>().and_then(|error| match error {
        RunError::Scenario(mistake) => Some(mistake),
        _ => None,
    });
    let Some(mistake) = error.downcast_ref::<Mistake>().or(of_run) else {
        return without_position(message(error));
    };
    let mark = mistake.mark.as_ref();
    Problem {
        message: mistake.sentence.clone(),
        file: Some(mistake.file.clone()),
        line: mark.map(|mark| mark.line),
        column: mark.map(|mark| mark.column),
    }
}
